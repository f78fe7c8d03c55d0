// Loading and patching, stepping under the watchdog, and what is shown of it; the class itself
// hands each call to its private half.
#include "simulation/simulation.h"

#include "compile/patch.h"
#include "constraints/guides.h"
#include "contact/obstacle_motion.h"
#include "forces/wind.h"
#include "measure/diagnostics.h"
#include "measure/energy_ledger.h"
#include "measure/probe.h"
#include "simulation/derived_system.h"
#include "simulation/hand_work.h"
#include "simulation/load_watch.h"
#include "simulation/note_accuracy.h"
#include "simulation/probe_peaks.h"
#include "simulation/probe_reader.h"
#include "simulation/ramps.h"
#include "simulation/recent_damping.h"
#include "simulation/snatch_loads.h"
#include "step/stepper.h"
#include "step/watchdog.h"
#include "system/moment.h"

#include <Eigen/Geometry>

#include <utility>

namespace ripstop {
namespace {

Vec3 middleOf(std::span<const Vec3> places)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& place : places)
        if (place.allFinite())
            box.extend(place);
    return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
}

} // namespace

class Simulation::Private
{
public:
    Private(std::shared_ptr<const System> compiled, int threads)
        : derived(std::move(compiled))
        , run{derived.compiled()->start, {}}
        , stepper(threads)
    {}
    Private(std::shared_ptr<const System> compiled, State checkpoint, int threads)
        : derived(std::move(compiled), checkpoint)
        , run{std::move(checkpoint), {}, false}
        , stepper(threads)
    {}

    void load(std::shared_ptr<const System> system);
    void apply(std::span<const std::shared_ptr<const Patch>> patches);
    void resume(const Moment& moment);
    void place(State state);
    bool step();
    std::shared_ptr<Frame> frame();
    Readings readings() const;

    const System& system() const { return derived.system(); }

    DerivedSystem derived;
    RunState run;
    HandWork hands;
    ProbeReader probes;
    Stepper stepper;
    EnergyLedger ledger;
    RunAccuracy accuracy;
    RecentDamping damping; // that it tells of
    SnatchLoads snatches;
    LoadWatch loads;
    ProbePeaks peaks;
    std::optional<Trouble> trouble;

private:
    enum class Look { AtEnd, Within }; // where loads are looked for in a step

    std::optional<NotedNumbers> numbersBeforeEdit() const;
    void rampFrom(const std::optional<NotedNumbers>& noted);
    std::shared_ptr<const System> endRamps();
    void followRamps(double time);
    void forgetAccuracy();
    int advance(bool keepsLedger, Look look);
    int advanceAgain(bool keepsLedger, int finer);
    void startOver();
    void resetTo(const Patch& patch);
    double substep() const; // s, of the next step
    void fillArrays(Frame& frame) const;
};

// --- loading ---------------------------------------------------------------------------------

// Before the first step nothing pulls yet, and edits count at once.
std::optional<NotedNumbers> Simulation::Private::numbersBeforeEdit() const
{
    if (run.now.step == 0)
        return std::nullopt;
    return NotedNumbers(*derived.compiled(), run.now);
}

// After the compiled system was edited, and before anything is derived from it.
void Simulation::Private::rampFrom(const std::optional<NotedNumbers>& noted)
{
    if (noted)
        noted->rampTo(*derived.compiled(), run.now);
    if (hasRamps(run.now))
        derived.apply(rampsAt(*derived.compiled(), run.now, run.now.time));
}

// Makes the compiled system what it was compiled to. Returns what was derived of it and is no more.
std::shared_ptr<const System> Simulation::Private::endRamps()
{
    if (!hasRamps(run.now))
        return nullptr;
    return derived.apply(endsOf(*derived.compiled(), run.now));
}

void Simulation::Private::followRamps(double time)
{
    if (!hasRamps(run.now))
        return;
    if (const auto before = derived.apply(rampsAt(*derived.compiled(), run.now, time)))
        derived.carryOn(*before, run);
    dropEnded(run.now, time);
}

// A new run, from the start of the compiled system.
void Simulation::Private::startOver()
{
    forgetAccuracy();
    loads.begin();
    run.atStart = true;
    run.now = derived.compiled()->start;
    hands.forget();
}

void Simulation::Private::load(std::shared_ptr<const System> system)
{
    forgetAccuracy();
    const bool again = system->run != derived.compiled()->run;
    const auto noted = numbersBeforeEdit();
    const std::shared_ptr<const System> before = derived.replace(std::move(system));
    if (again) {
        startOver();
    } else {
        run.atStart = false;
        rampFrom(noted);
        derived.carryOn(*before, run);
    }
    trouble.reset(); // the edit may have cured it
}

// One edit, of patches of one run: what goes over begins where it was before all of them.
void Simulation::Private::apply(std::span<const std::shared_ptr<const Patch>> patches)
{
    forgetAccuracy();
    loads.edited();
    const bool again = patches.back()->run != derived.compiled()->run;
    const auto noted = numbersBeforeEdit();
    std::shared_ptr<const System> before = endRamps();
    for (const auto& patch : patches)
        if (auto derivedBefore = derived.apply(*patch))
            before = std::move(derivedBefore);
    trouble.reset();
    if (before && again)
        return startOver();
    if (again) {
        for (const auto& patch : patches)
            resetTo(*patch);
        return;
    }
    rampFrom(noted);
    if (before) { // what tears have split is made anew from what was patched
        run.atStart = false;
        return derived.carryOn(*before, run);
    }

    // what carryOver() does, for what can differ
    for (const auto& patch : patches)
        for (const auto& [i, row] : patch->particles) {
            run.atStart = false;
            if (row.pinned) {
                run.now.velocity[std::size_t(i)].setZero();
                run.now.drift[std::size_t(i)].setZero();
                run.now.velocityBefore[std::size_t(i)].setZero();
            }
            turnAlong(guidedOf(row, i), run.now);
        }
}

// A new run begins with the patch. While a design at rest is edited there is little to put back.
void Simulation::Private::resetTo(const Patch& patch)
{
    if (!run.atStart)
        return startOver();
    loads.begin();
    hands.forget();
    const State& start = derived.compiled()->start;
    run.now.gusts = start.gusts;
    for (const auto& particle : patch.particles) {
        const auto i = std::size_t(particle.first);
        run.now.position[i] = start.position[i];
        run.now.velocity[i] = start.velocity[i];
    }
}

void Simulation::Private::resume(const Moment& moment)
{
    forgetAccuracy();
    loads.begin();
    hands.forget();
    run.atStart = false;
    trouble.reset();
    endRamps();
    derived.goOnFrom(moment, run);
    const NotedNumbers noted(*moment.system, moment.state);
    noted.rampTo(*derived.compiled(), run.now);
    followRamps(run.now.time);
}

void Simulation::Private::place(State state)
{
    loads.begin();
    snatches = {};
    peaks.forget();
    const bool ramped = hasRamps(run.now) || hasRamps(state);
    endRamps();
    if (ramped)
        derived.apply(rampsAt(*derived.compiled(), state, state.time));
    if (ramped || state.splits != run.now.splits || state.hands.pins != run.now.hands.pins)
        derived.derive(state);
    run.now = std::move(state);
}

// --- stepping --------------------------------------------------------------------------------

bool Simulation::Private::step()
{
    if (trouble)
        return false;
    run.atStart = false;
    const bool keepsLedger = wantsLedger(system());
    const double energy = keepsLedger ? energies(system(), run.now).total() : 0.0;
    followRamps(run.now.time + system().timeStep);
    if (keepsLedger) // what a ramp brings is the work of the hand that typed
        run.now.work.hands += energies(system(), run.now).total() - energy;
    run.lastGood = run.now;
    const std::size_t tears = run.now.tears.size();
    int substeps = advance(keepsLedger, Look::AtEnd);
    const bool isTooLong = snatches.isTooLong(system(), run.lastGood, run.now, stepper);
    if (system().solver == Solver::Auto) { // others do what they are told
        int finer = 1;
        if (isTooLong)
            substeps = advanceAgain(keepsLedger, finer = SnatchLoads::finer);
        for (;;) {
            const int enough = SnatchLoads::finerForBreaks(system(), run.lastGood, stepper, finer);
            if (enough == finer)
                break;
            substeps = advanceAgain(keepsLedger, finer = enough);
        }
    }
    trouble = findTrouble(system(), run.lastGood, run.now, substeps);
    if (trouble) {
        ++accuracy.steps; // of which nothing else is true
        ++accuracy.missed;
        std::swap(run.now, run.lastGood);
        peaks.forget(); // of a step that has not been
    } else {
        noteAccuracy(system(), stepper, run.now, run.now.tears.size() - tears, damping, accuracy);
        loads.look(system(), run.now, tears);
        peaks.noteTears(system(), std::span(run.now.tears).subspan(tears), loads.judged());
        snatches.note(system(), stepper, isTooLong);
        if (loads.hasPeakAfter(run.lastGood.time))
            loads.noteShortfall(run.lastGood.time,
                                snatches.shortfall(system(), run.lastGood, run.now));
        derived.followTears(tears, run);
    }
    return !trouble;
}

// From where the step began, each substep cut in so many. How many the next step takes is as it was
// chosen: that may be a usual one.
int Simulation::Private::advanceAgain(bool keepsLedger, int finer)
{
    const int chosen = run.now.substeps;
    run.now = run.lastGood;
    const int refinement = stepper.refinement();
    stepper.refine(finer * refinement);
    const int substeps = advance(keepsLedger, Look::Within);
    stepper.refine(refinement);
    run.now.substeps = chosen;
    return substeps;
}

// Returns the number of substeps that it took.
int Simulation::Private::advance(bool keepsLedger, Look look)
{
    stepper.stopWatches();
    peaks.beginStep(system(), run.now);
    if (keepsLedger) {
        ledger.begin(system(), run.now, substep());
        stepper.watch(ledger);
    }
    if (look == Look::Within) {
        loads.beginStep();
        stepper.watch(loads);
        stepper.watch(peaks);
    }
    const int substeps = stepper.step(system(), run.now);
    if (keepsLedger)
        ledger.end(system(), run.now);
    return substeps;
}

void Simulation::Private::forgetAccuracy()
{
    accuracy = {};
    damping = {};
    snatches = {};
    peaks.forget();
}

double Simulation::Private::substep() const
{
    return system().timeStep / stepper.substepsOf(system(), run.now);
}

// --- showing ---------------------------------------------------------------------------------

std::shared_ptr<Frame> Simulation::Private::frame()
{
    const State& state = run.now;
    auto frame = std::make_shared<Frame>();
    frame->generation = system().generation;
    frame->run = system().run;
    frame->layout = derived.layout(state);
    frame->time = state.time;
    frame->step = state.step;
    frame->accuracy = accuracy;
    frame->accuracy.fastestSwing = stepper.fastestTrueSwing(system(), state);
    frame->solverChoice = stepper.choice(system());
    frame->substeps = stepper.substepsOf(system(), state);
    frame->hash = stateHash(state);
    fillArrays(*frame);

    Readings instant = readings();
    frame->strain = instant.strain();
    frame->tension = instant.tension();
    frame->panelLoad = instant.panelLoad();
    frame->panelPull = panelPulls(system(), state);
    frame->probe = probes.read(instant);
    frame->highest = probes.highest(frame->probe, peaks);
    frame->linkMargin = instant.margin().link;
    frame->panelMargin = instant.margin().panel;
    frame->worstNow = loads.now(system(), state);
    frame->worstOfRun = loads.ofRun();
    frame->firstBreaks = loads.firstBreaks();

    hands.fill(*frame, system(), state, substep());
    if (trouble) {
        frame->stopped = trouble->message;
        frame->culprit = trouble->particle;
    }
    return frame;
}

void Simulation::Private::fillArrays(Frame& frame) const
{
    const State& state = run.now;
    frame.position.assign(state.position.begin(), state.position.end());
    frame.velocity.assign(state.velocity.begin(), state.velocity.end());
    frame.torn.reserve(system().links.size());
    for (const LinkPlace& link : system().links)
        frame.torn.push_back(isTorn(link, state));
    frame.gone = state.panelGone;
    frame.gust = commonWind(system(), state) - system().wind;
    frame.wind = windAt(system(), state, middleOf(frame.position));
    for (std::size_t i = 0; i < system().obstacles.size(); ++i)
        frame.colliderPosition.push_back(obstaclePosition(system(), state, i, state.time));
    frame.inputCommand = state.inputCommand;
    frame.inputValue = state.inputValue;
    for (const State::Tear& tear : state.tears)
        frame.tears.push_back({tear.time, tear.element, tear.length, tear.strain, tear.force,
                               tear.place, tear.energy});
}

Readings Simulation::Private::readings() const
{
    const bool follows = run.now.step == run.lastGood.step + 1
                         && run.now.velocity.size() == run.lastGood.velocity.size();
    return {system(), run.now, follows ? &run.lastGood : nullptr};
}

// --- the class itself ------------------------------------------------------------------------

int Simulation::mostThreads() { return ThreadPool::cores(); }

Simulation::Simulation(std::shared_ptr<const System> system, int threads)
    : d(std::make_unique<Private>(std::move(system), threads))
{}

Simulation::Simulation(std::shared_ptr<const System> system, State checkpoint, int threads)
    : d(std::make_unique<Private>(std::move(system), std::move(checkpoint), threads))
{}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::load(std::shared_ptr<const System> system) { d->load(std::move(system)); }

void Simulation::load(std::vector<Update> updates)
{
    std::vector<std::shared_ptr<const Patch>> patches; // of one edit
    const auto applyPatches = [&] {
        if (!patches.empty())
            d->apply(patches);
        patches.clear();
    };
    for (Update& update : updates) {
        if (update.system) {
            applyPatches();
            d->load(std::exchange(update.system, nullptr)); // a patch copies what others hold
        }
        if (update.patch) {
            if (!patches.empty() && patches.back()->run != update.patch->run)
                applyPatches();
            patches.push_back(std::move(update.patch));
        }
        if (update.moment) {
            applyPatches();
            d->resume(*update.moment);
        }
    }
    applyPatches();
}

void Simulation::command(const Commands& commands)
{
    d->hands.command(commands, d->system(), d->run);
}

void Simulation::handle(const HandCommands& told) { d->hands.handle(told, d->derived, d->run); }

void Simulation::halt() { d->hands.halt(d->run); }

void Simulation::resume(const Moment& moment) { d->resume(moment); }

void Simulation::place(State state) { d->place(std::move(state)); }

void Simulation::keepInputs(std::vector<RunInput>* inputs) { d->hands.keepInputs(inputs); }

bool Simulation::step() { return d->step(); }

bool Simulation::runUntil(double time)
{
    while (!hasReached(state().time, time, system().timeStep))
        if (!step())
            return false;
    return true;
}

void Simulation::refine(int times) { d->stepper.refine(times); }
void Simulation::keepTimes(StepTimes* times) { d->stepper.keepTimes(times); }

const System& Simulation::system() const { return d->system(); }

const std::shared_ptr<const System>& Simulation::compiled() const { return d->derived.compiled(); }

const State& Simulation::state() const { return d->run.now; }

std::span<const std::uint32_t> Simulation::touches() const { return d->stepper.touches(); }

const std::optional<Trouble>& Simulation::trouble() const { return d->trouble; }

std::shared_ptr<Frame> Simulation::frame() const { return d->frame(); }

ProbeSample Simulation::sample() const
{
    Readings instant = d->readings();
    std::vector<double> probe = d->probes.read(instant);
    std::vector<double> highest = d->probes.highest(probe, d->peaks);
    return {d->system().run, d->derived.layout(d->run.now), d->run.now.time, std::move(probe),
            std::move(highest)};
}

} // namespace ripstop
