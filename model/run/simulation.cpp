#include "run/simulation.h"

#include "assembly/carry_over.h"
#include "assembly/split_system.h"
#include "constraints/guides.h"
#include "contact/obstacle_motion.h"
#include "forces/hand_pull.h"
#include "forces/wind.h"
#include "measure/diagnostics.h"
#include "measure/probe.h"
#include "run/torn_system.h"
#include "tearing/cutting.h"
#include "tearing/tear_opening.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

std::shared_ptr<const System> derived(const std::shared_ptr<const System>& compiled,
                                      const State& state)
{
    if (state.splits.empty() && state.hands.pins.empty())
        return nullptr;
    return splitSystem(*compiled, state.splits, state.hands.pins);
}

std::shared_ptr<const Layout> layoutOf(const System& system,
                                       const std::shared_ptr<const System>& derived,
                                       const std::vector<Split>& splits)
{
    auto layout = std::make_shared<Layout>();
    const TwinOrigins origins(splits);
    if (!splits.empty()) {
        layout->particleKey = system.key;
        layout->torn = std::make_shared<TornSystem>(TornSystem{derived, splits});
    }
    layout->particleId.reserve(system.key.size());
    for (const Key key : system.key)
        layout->particleId.push_back(origins.particle(key));
    layout->pinned.reserve(system.inverseMass.size());
    layout->links.reserve(system.links.size());
    layout->panelCorners.reserve(system.panels.size());
    for (const double w : system.inverseMass)
        layout->pinned.push_back(w == 0.0);
    layout->guided = system.guided;
    for (const LinkPlace& link : system.links)
        layout->links.push_back({origins.link(link.key), link.kind, link.a, link.b,
                                 link.kind == LinkKind::Rod
                                     ? system.rods[std::size_t(link.index)].restLength
                                     : system.springs[std::size_t(link.index)].restLength});
    layout->panelId = system.panelKey;
    for (const FabricPanel& panel : system.panels)
        layout->panelCorners.push_back(panel.corner);
    for (const Input& input : system.inputs)
        layout->inputId.push_back(input.key);
    for (const Obstacle& obstacle : system.obstacles)
        layout->colliderId.push_back(obstacle.key);
    for (const ProbeSpec& probe : system.probes)
        layout->probes.push_back({probe.key, probe.name, probe.unit, probe.plotted});
    return layout;
}

Vec3 middleOf(std::span<const Vec3> places)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& place : places)
        if (place.allFinite())
            box.extend(place);
    return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
}

} // namespace

bool hasReached(double time, double until, double timeStep)
{
    return time >= until - (0.5 + 1e-6) * timeStep;
}

Simulation::Simulation(std::shared_ptr<const System> system, int threads)
    : m_system(std::move(system))
    , m_layout(layoutOf(*m_system, nullptr, {}))
    , m_state(m_system->start)
    , m_stepper(threads)
{}

Simulation::Simulation(std::shared_ptr<const System> system, State checkpoint, int threads)
    : m_system(std::move(system))
    , m_split(derived(m_system, checkpoint))
    , m_layout(layoutOf(this->system(), m_split, checkpoint.splits))
    , m_state(std::move(checkpoint))
    , m_atStart(false)
    , m_stepper(threads)
{}

void Simulation::load(std::shared_ptr<const System> system)
{
    const std::shared_ptr<const System> before =
        m_split ? std::exchange(m_split, nullptr) : m_system;
    m_atStart = system->run != m_system->run;
    m_system = std::move(system);
    if (m_atStart) {
        m_state = m_system->start;
        forget();
    } else {
        carryOn(*before);
    }
    m_layoutIsStale = true;
    m_trouble.reset(); // the edit may have cured it
}

// What was done in the run before.
void Simulation::forget()
{
    m_commands.clear();
    m_hands.clear();
    m_cuts = 0;
    m_halts = 0;
}

// The motion of the system before, in the one that tears and pins make of the new one.
void Simulation::carryOn(const System& before)
{
    m_split = derived(m_system, m_state);
    m_lastGood = carryOver(before, m_state, system(), std::move(m_lastGood));
    std::swap(m_state, m_lastGood);
    m_layoutIsStale = true;
}

// The mesh opens between two steps, where links have torn in the last.
void Simulation::followTears(std::size_t before)
{
    if (system().tearMesh != TearMesh::Split || m_state.tears.size() == before)
        return;
    if (openTears(system(), m_state)) {
        const std::shared_ptr<const System> torn = m_split ? m_split : m_system;
        carryOn(*torn);
    }
}

void Simulation::load(const Update& update)
{
    if (update.system)
        load(update.system);
    if (update.patch)
        apply(*update.patch);
    if (update.moment)
        resume(*update.moment);
}

void Simulation::apply(const Patch& patch)
{
    const bool again = patch.run != m_system->run;
    System& system = ownSystem();
    m_layoutIsStale |= ripstop::apply(patch, system);
    m_trouble.reset();
    if (m_split)
        return applySplit(again);
    if (again)
        return reset(patch);

    // what carryOver() does, for what can differ
    for (const auto& [i, row] : patch.particles) {
        m_atStart = false;
        if (row.pinned) {
            m_state.velocity[std::size_t(i)].setZero();
            m_state.drift[std::size_t(i)].setZero();
        }
        turnAlong(guidedOf(row, i), m_state);
    }
}

// What tears have split is made anew from what was patched.
void Simulation::applySplit(bool again)
{
    const std::shared_ptr<const System> before = std::exchange(m_split, nullptr);
    m_layoutIsStale = true;
    m_atStart = again;
    if (!again)
        return carryOn(*before);
    m_state = m_system->start;
    forget();
}

// A new run begins with the patch. While a design at rest is edited there is little to put back.
void Simulation::reset(const Patch& patch)
{
    const State& start = m_system->start;
    forget();
    if (!std::exchange(m_atStart, true)) {
        m_state = start;
        return;
    }
    m_state.gusts = start.gusts;
    for (const auto& particle : patch.particles) {
        const auto i = std::size_t(particle.first);
        m_state.position[i] = start.position[i];
        m_state.velocity[i] = start.velocity[i];
    }
}

System& Simulation::ownSystem()
{
    // Whoever compiled it gave it away, and it was not made const.
    if (m_system.use_count() > 1)
        m_system = std::make_shared<System>(*m_system);
    return const_cast<System&>(*m_system);
}

// Views build what they draw from the layout; most edits change numbers and leave it as it is.
void Simulation::refreshLayout() const
{
    if (!std::exchange(m_layoutIsStale, false))
        return;
    if (auto layout = layoutOf(system(), m_split, m_state.splits); *layout != *m_layout)
        m_layout = std::move(layout);
}

void Simulation::resume(const Moment& moment)
{
    forget();
    m_atStart = false;
    m_trouble.reset();
    m_state = moment.state;
    const std::shared_ptr<const System> before = derived(moment.system, m_state);
    carryOn(before ? *before : *moment.system);
}

void Simulation::place(State state)
{
    if (state.splits != m_state.splits || state.hands.pins != m_state.hands.pins) {
        m_split = derived(m_system, state);
        m_layoutIsStale = true;
    }
    m_state = std::move(state);
}

void Simulation::command(const Commands& commands)
{
    for (std::size_t i = 0; i < system().inputs.size(); ++i)
        if (const auto found = commands.find(system().inputs[i].key);
            found != commands.end() && std::isfinite(found->second)) {
            const Input& input = system().inputs[i];
            const double value = std::clamp(found->second, -input.limit, input.limit);
            if (value == m_state.inputCommand[i])
                continue;
            m_atStart = false;
            m_state.inputCommand[i] = value;
            m_commands.push_back({m_state.time, input.key, value});
            if (m_inputs)
                m_inputs->push_back({m_state.step, m_commands.back()});
        }
}

void Simulation::note(HandNote::What what)
{
    m_atStart = false;
    if (m_inputs)
        m_inputs->push_back({m_state.step, what});
    m_hands.append({m_state.time, std::move(what)});
}

void Simulation::handle(const HandCommands& told)
{
    handle(told.hands);
    for (; m_cuts < told.cuts.size(); ++m_cuts)
        cut(told.cuts[m_cuts]);
    for (; m_halts < told.halts; ++m_halts)
        stopMotion();
}

void Simulation::handle(const Hands& told)
{
    Hands& now = m_state.hands;
    if (told == now)
        return;
    if (told.pull != now.pull) {
        now.pull = told.pull;
        note(told.pull ? HandNote::What(*told.pull) : HandNote::LetGo{});
    }
    if (told.fan != now.fan) {
        now.fan = told.fan;
        note(told.fan ? HandNote::What(*told.fan) : HandNote::FanOff{});
    }
    carry(told.carries);
    pin(told.pins);
}

// What is no longer named stays where it has been put.
void Simulation::carry(const std::vector<Carry>& told)
{
    auto& carries = m_state.hands.carries;
    for (const Carry& carry : told) {
        auto held = std::find_if(carries.begin(), carries.end(), [&](const Carry& other) {
            return other.collider == carry.collider;
        });
        if (held == carries.end()) {
            held = carries.insert(carries.end(), {carry.collider, Vec3::Zero()});
            m_state.carried.emplace_back(Vec3::Zero());
        }
        if (held->way == carry.way)
            continue;
        held->way = carry.way;
        note(carry);
    }
}

void Simulation::pin(const std::vector<Key>& told)
{
    std::vector<Key>& pins = m_state.hands.pins;
    if (told == pins)
        return;
    const auto has = [](const std::vector<Key>& keys, Key key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    for (const Key key : pins)
        if (!has(told, key))
            note(HandNote::Pin{key, false});
    for (const Key key : told)
        if (!has(pins, key))
            note(HandNote::Pin{key, true});
    pins = told;
    const std::shared_ptr<const System> before = m_split ? m_split : m_system;
    carryOn(*before);
}

void Simulation::cut(const std::shared_ptr<const Cut>& cut)
{
    note(cut);
    if (cutAlong(system(), m_state, *cut)) {
        const std::shared_ptr<const System> whole = m_split ? m_split : m_system;
        carryOn(*whole);
    }
}

void Simulation::halt()
{
    ++m_halts;
    stopMotion();
}

void Simulation::stopMotion()
{
    note(HandNote::Halt{});
    for (PaddedVec3& velocity : m_state.velocity)
        velocity.setZero();
    for (PaddedVec3& drift : m_state.drift)
        drift.setZero();
}

bool Simulation::step()
{
    if (m_trouble)
        return false;
    m_atStart = false;
    m_lastGood = m_state;
    const std::size_t tears = m_state.tears.size();
    const bool keepsLedger = wantsLedger(system());
    m_stepper.watch(keepsLedger ? &m_ledger : nullptr);
    if (keepsLedger)
        m_ledger.begin(system(), m_state, substep());
    const int substeps = m_stepper.step(system(), m_state);
    if (keepsLedger)
        m_ledger.end(system(), m_state);
    m_trouble = findTrouble(system(), m_lastGood, m_state, substeps);
    if (m_trouble)
        std::swap(m_state, m_lastGood);
    else
        followTears(tears);
    return !m_trouble;
}

bool Simulation::runUntil(double time)
{
    while (!hasReached(m_state.time, time, system().timeStep))
        if (!step())
            return false;
    return true;
}

std::shared_ptr<Frame> Simulation::frame() const
{
    refreshLayout();
    auto frame = std::make_shared<Frame>();
    frame->generation = system().generation;
    frame->run = system().run;
    frame->layout = m_layout;
    frame->time = m_state.time;
    frame->step = m_state.step;
    frame->solverChoice = m_stepper.choice(system());
    frame->substeps = m_stepper.substepsOf(system(), m_state);
    frame->hash = stateHash(m_state);
    frame->position.assign(m_state.position.begin(), m_state.position.end());
    frame->velocity.assign(m_state.velocity.begin(), m_state.velocity.end());
    frame->torn.reserve(system().links.size());
    for (const LinkPlace& link : system().links)
        frame->torn.push_back(isTorn(link, m_state));
    frame->gone = m_state.panelGone;
    frame->gust = commonWind(system(), m_state) - system().wind;
    frame->wind = windAt(system(), m_state, middleOf(frame->position));
    for (std::size_t i = 0; i < system().obstacles.size(); ++i)
        frame->colliderPosition.push_back(obstaclePosition(system(), m_state, i, m_state.time));
    frame->inputCommand = m_state.inputCommand;
    frame->inputValue = m_state.inputValue;

    Readings instant = readings();
    frame->strain = instant.strain();
    frame->tension = instant.tension();
    frame->panelLoad = instant.panelLoad();
    frame->probe = m_probes.read(instant);

    for (const State::Tear& tear : m_state.tears)
        frame->tears.push_back(
            {tear.time, tear.link, tear.length, tear.strain, tear.force, tear.place, tear.energy});
    frame->commands = m_commands;
    fillHands(*frame);
    if (m_trouble) {
        frame->stopped = m_trouble->message;
        frame->culprit = m_trouble->particle;
    }
    return frame;
}

ProbeSample Simulation::sample() const
{
    refreshLayout();
    Readings instant = readings();
    return {system().run, m_layout, m_state.time, m_probes.read(instant)};
}

Readings Simulation::readings() const
{
    const bool follows = m_state.step == m_lastGood.step + 1
                         && m_state.velocity.size() == m_lastGood.velocity.size();
    return {system(), m_state, follows ? &m_lastGood : nullptr};
}

double Simulation::substep() const
{
    return system().timeStep / m_stepper.substepsOf(system(), m_state);
}

void Simulation::fillHands(Frame& frame) const
{
    const Hands& hands = m_state.hands;
    frame.hands = m_hands;
    frame.carries = hands.carries;
    frame.handPins = hands.pins;
    frame.underWay = m_state.step > 0 || m_cuts > 0 || m_halts > 0 || !hands.pins.empty();
    if (!hands.pull)
        return;
    const HeldGrip held = findGrip(system(), hands.pull->grip);
    const HandForce force = handForce(system(), m_state, *hands.pull, held, substep());
    if (held.holds())
        frame.held = HeldPoint{force.point, hands.pull->to, force.force.norm(), force.stiffness};
}

} // namespace ripstop
