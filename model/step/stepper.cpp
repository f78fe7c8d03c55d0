// The step, in order: scratch arrays and the plan of Solver::Auto are made to fit the system, gusts
// advance, and then each substep moves controls, fills accelerations, predicts positions, projects
// rods, takes the velocities over, resolves contact and judges which links tear.
// Tensions are taken after the last substep, as the mean of the last few. Every few steps the
// strain that is left decides the next number of substeps, and at once where what is solved
// together has missed its accuracy.
#include "step/stepper.h"

#include "base/portable_math.h"
#include "constraints/guides.h"
#include "contact/contact.h"
#include "contact/surface_search.h"
#include "forces/gusts.h"
#include "step/inputs.h"
#include "step/particle_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr int meanOver = 8;  // substeps, the last of a step, that tensions are the mean of
constexpr int lookEvery = 8; // steps, at the strain, where the solver chooses the substeps
constexpr int substepsOfBeginning = 8;

StepStage stageOf(ForceKind kind)
{
    switch (kind) {
    case ForceKind::Elastic:
        return StepStage::Springs;
    case ForceKind::Air:
        return StepStage::Air;
    case ForceKind::Weight:
    case ForceKind::Hand:
        break;
    }
    return StepStage::Sum;
}

// How near the ends of rods have to come to where they belong, 1, as a share of lengths. BDF2 goes
// on from the differences of three places, of which the errors are a larger part the shorter the
// substep is; what an iteration leaves, which is of second order, shrinks as this does.
double toleranceFor(Integrator integrator, double h)
{
    constexpr double enough = 3e-4;
    constexpr double usualSubstep = 1.0 / 240.0; // s
    const double share = h / usualSubstep;
    return integrator == Integrator::Bdf2 ? enough * std::min(1.0, share * share) : enough;
}

// Whether particle_motion.h has no use for its scratch.
bool leavesScratch(Integrator integrator)
{
    return integrator == Integrator::SemiImplicitEuler || integrator == Integrator::ImplicitEuler
           || isVerlet(integrator);
}

} // namespace

int Stepper::step(const System& system, State& state)
{
    m_clock.start();
    m_numericalDamping = {};
    m_noted = 0.0;
    m_hasSnatch = false;
    m_tearing.late = 0.0;
    prepare(system, state);
    const int chosen = chosenSubsteps(system, state);
    const int substeps =
        chosen * m_refinement * (beginsBdf2(system, state) ? substepsOfBeginning : 1);
    const double h = system.timeStep / substeps;
    m_clock.lap(StepStage::Plan);
    if (!system.fabricLayer.empty()) {
        m_fabric.find(system, state);
        m_clock.lap(StepStage::Contact);
    }
    if (m_integrator == Integrator::Bdf2 && state.driftSubstep > 0.0 && state.driftSubstep != h)
        lookBackAsFar(state, h, m_pool);
    const double startTime = state.time;
    advanceGusts(system, state);
    m_keep = portableExp(-system.viscosity * h);
    for (int s = 0; s < substeps; ++s) {
        state.time = startTime + (s + 1) * h;
        RodTask task = rodTask(system, state, h);
        task.tolerance = toleranceFor(m_integrator, h) / m_refinement;
        if (s == 0) {
            m_rods.start(task, state.rodTension);
            m_clock.lap(StepStage::Rods);
        }
        task.note = m_tearsByForce || s + meanOver >= substeps;
        task.shifted = s == 0;
        m_mayPart = s + 1 == substeps;
        substep(task, state, h);
        ++state.substep;
    }
    m_rods.takeTensions(rodTask(system, state, h), m_pool, state.rodTension);
    m_clock.lap(StepStage::Tensions);
    ++state.step;
    m_accuracy = accuracyOf(system, state, m_heldLength, m_pool, m_reach, m_rods.leastEnergy());
    if (m_integrator != Integrator::Bdf2 || m_looksBack)
        noteDamping(system, state, h, 1.0 - m_noted);
    m_accuracy.pulls =
        std::sqrt(m_accuracy.pulls * m_accuracy.pulls + m_rods.residual() * m_rods.residual());
    const bool hasMissed = m_plan.together && m_accuracy.ratio(system) > 1.0;
    if (system.solver == Solver::Auto && (hasMissed || state.step % lookEvery == 0))
        adapt(system, state, chosen);
    m_clock.lap(StepStage::Plan);
    return substeps;
}

// The velocities at the start of the last substep, m/s; empty where nothing has kept them.
std::span<const PaddedVec3> Stepper::startOf(const State& state) const
{
    if (m_integrator == Integrator::Bdf2)
        return state.velocityBefore;
    return leavesScratch(m_integrator) ? std::span<const PaddedVec3>(m_scratch)
                                       : std::span<const PaddedVec3>();
}

// Of the substep that has just ended, as a share of the time step.
void Stepper::noteDamping(const System& system, const State& state, double h, double share)
{
    const StepFormula formula = m_looksBack ? StepFormula::Bdf2 : StepFormula::Euler;
    m_numericalDamping.add(
        numericalDampingOf(system, state, startOf(state), m_touches, formula, h, m_pool), share);
    m_noted += share;
}

void Stepper::prepare(const System& system, State& state)
{
    m_placed.resize(system.obstacles.size());
    m_touches.assign(system.obstacles.empty() ? 0 : state.position.size(), 0);
    m_acceleration.resize(state.position.size());
    m_before.resize(state.position.size());
    m_scratch.resize(state.position.size());
    m_restLength.resize(system.rods.size());
    m_rodLength.resize(system.rods.size());
    m_tearing.overloads.reserve(system.tearableSprings.size() + system.tearableRods.size()
                                + system.membranes.size()
                                + system.of<BendLists>().ofSpars().size());
    m_lanes.reserve(m_forces.size());
    m_pinWays.reserve(system);
    for (const auto& force : m_forces)
        force->prepare(system, state);
    m_tears = state.tears.size();
    if (m_serial != system.serial || m_valuesSerial != system.valuesSerial)
        fillRestLengths(system, state, m_restLength);
    else
        shiftRestLengths(system, state, m_restLength); // those of another state, maybe
    m_rodDamping.prepare(system);
    m_serial = system.serial;
    m_valuesSerial = system.valuesSerial;
    m_summed = false;
    if (system.solver == Solver::Auto && !m_planFor.isOf(system)) {
        m_plan = planFor(system);
        m_planFor = PlanFor(system);
    }
    m_integrator = system.integrator;
    if (m_integrator == Integrator::Auto)
        m_integrator =
            system.solver == Solver::Auto ? m_plan.integrator : Integrator::SemiImplicitEuler;
    m_held.resize(solvesContact(system) ? state.position.size() : 0);
    for (auto* scratch : {&m_implicit, &m_seen, &m_velocityBefore, &m_nearby})
        scratch->resize(dampsImplicitly(system) ? state.position.size() : 0);
    m_tearsByForce = std::ranges::any_of(system.tearableRods, [&](int rod) {
        return system.rods[std::size_t(rod)].tear.rule == TearRule::Force;
    });
}

RodTask Stepper::rodTask(const System& system, State& state, double h) const
{
    const bool automatic = system.solver == Solver::Auto;
    const bool small = automatic || system.solver == Solver::SmallSteps;
    return {system,
            small ? Solver::SmallSteps : system.solver,
            small ? 1 : system.sweeps,
            automatic ? m_plan.direct : system.direct,
            state.rodTorn,
            m_restLength,
            reachOf(m_integrator, h, state.driftSubstep == h),
            std::uint64_t(state.substep),
            state.position,
            m_before,
            dampsImplicitly(system) ? m_implicit : m_acceleration};
}

void Stepper::substep(RodTask& task, State& state, double h)
{
    const System& system = task.system;
    const bool isBdf2 = m_integrator == Integrator::Bdf2;
    beginMoves(system, state, state.time - h, m_placed);
    moveCarried(state, h);
    m_pinWays.note(system, state);
    if (moveInputs(system, state, h)) {
        shiftRestLengths(system, state, m_restLength);
        task.shifted = true;
    }
    m_pinWays.giveVelocities(state, h);
    endMoves(system, state, state.time, m_placed);
    m_clock.lap(StepStage::Controls);
    for (const auto& force : m_forces) {
        force->advance(system, state, h);
        m_clock.lap(stageOf(force->kind()));
    }
    if (solvesContact(system))
        m_came = state.velocity;
    if (leavesScratch(m_integrator))
        m_scratch = state.velocity;
    if (isBdf2)
        move(ParticlePass::Foresee, system, state, h);
    const bool foresees = isBdf2 && state.driftSubstep == h;
    const std::span earlier(std::as_const(state.velocityBefore));
    fillLoads(task, state, h,
              {state.velocity, state.velocity, earlier.first(foresees ? earlier.size() : 0)});
    if (m_integrator == Integrator::RungeKutta4)
        takeMeans(system, state, h);
    const bool mayCorrect = foresees && dampsImplicitly(system);
    if (mayCorrect)
        m_velocityBefore = state.velocityBefore;
    predict(system, state, h);
    const SurfaceSearch search(system, m_before, m_came, m_placed, h);
    if (solvesContact(system))
        task.contacts = &search;
    project(task, state, h);
    m_clock.lap(StepStage::Rods);
    if (mayCorrect && hasTurnedFromForeseen(system, state, m_before, h))
        correctLoads(task, state, h);
    const bool impact = isBdf2 && m_rods.hasImpact();
    if (impact && state.driftSubstep == h)
        beginAnew(task, state, h);
    m_pinWays.forget(state, m_before);
    if (m_integrator == Integrator::VelocityVerlet) {
        move(ParticlePass::ForeseeVelocities, system, state, h);
        m_clock.lap(StepStage::Motion);
        fillAccelerations(system, state, h);
    }
    move(ParticlePass::FollowRods, system, state, h);
    m_clock.lap(StepStage::Motion);
    for (SubstepWatch* const watch : m_watches)
        watch->beforeContact(system, state);
    if (!system.fabricLayer.empty())
        m_fabric.resolve(system, state);
    if (solvesContact(system))
        followHeldContacts(system, state, m_rods.contacts(), m_placed, h, m_held, m_touches);
    resolveContacts(system, state, m_before, m_placed, h, m_pool, m_touches, m_held);
    for (SubstepWatch* const watch : m_watches) {
        watch->afterContact(system, state);
        watch->afterSolve(m_rods.contacts(), h, task.h);
    }
    keepOnGuides(system, m_before, state);
    if (isBdf2)
        move(ParticlePass::FollowContact, system, state, h);
    m_clock.lap(StepStage::Contact);
    tearOverloaded(system, state,
                   {m_rodLength, m_forces.ofSprings(), m_restLength, m_tears, m_mayPart},
                   m_tearing);
    m_clock.lap(StepStage::Tearing);
    m_looksBack = foresees && !impact;
    if (isBdf2 && !m_looksBack && state.substep > 0) { // a run begins so without a blow
        noteDamping(system, state, h, h / system.timeStep);
        m_hasSnatch |= m_rods.hasLines();
    }
    const bool waits = isBdf2 && state.driftSubstep < 0.0; // for motion from after an impact alone
    state.driftSubstep = impact ? -h : looksBack(m_integrator) && !waits ? h : 0.0;
    if (m_watches.empty())
        return;
    m_rods.takeDirectTensions(state.rodTension);
    for (SubstepWatch* const watch : m_watches)
        watch->afterSubstep(system, state, h, m_integrator);
    m_clock.lap(StepStage::Watch);
}

// Whether nothing acts that may differ from one substep to the next.
bool Stepper::isSteady(const System& system, const State& state) const
{
    return std::ranges::all_of(m_forces, [&](const auto& force) {
        return force->isSteady() || !force->acts(system, state);
    });
}

void Stepper::fillAccelerations(const System& system, const State& state, double h)
{
    if (m_summed && isSteady(system, state))
        return;
    m_summed = true;
    m_lanes.clear();
    Vec3 common = Vec3::Zero();
    for (const auto& force : m_forces) {
        if (!force->acts(system, state))
            continue;
        if (const Lane lane = force->fill(system, state, m_pool); lane.load)
            m_lanes.push_back(lane);
        common += force->acceleration(system);
        m_clock.lap(stageOf(force->kind()));
    }
    m_pool.parallelFor(state.position.size(), [&](std::size_t first, std::size_t last) {
        gatherAccelerations(m_lanes, common, system.inverseMass.data(), m_acceleration.data(),
                            first, last);
    });
    for (const auto& force : m_forces)
        if (force->acts(system, state))
            force->addToFew(system, state, h, m_acceleration);
    dropAcrossGuides(system, m_acceleration);
    m_clock.lap(StepStage::Sum);
}

// Puts the loads of where things are now in place of those that the substep began with.
void Stepper::fillLoads(RodTask& task, const State& state, double h,
                        const SeenVelocities& velocities)
{
    const System& system = task.system;
    fillAccelerations(system, state, h);
    if (!dampsImplicitly(system))
        return;
    fillDamping(system, state, m_damping);
    dropAcrossGuides(system, m_damping.at);
    task.damping = m_damping.at;
    m_seen.assign(velocities.seen.begin(), velocities.seen.end());
    withDamping(system, m_damping, task.h, velocities, m_acceleration, m_implicit);
    m_clock.lap(StepStage::Air);
}

// Does the substep once more from where it began, with the loads of where it has led.
void Stepper::correctLoads(RodTask& task, State& state, double h)
{
    for (std::size_t i = 0; i < state.position.size(); ++i)
        if (task.system.inverseMass[i] > 0.0) {
            state.velocity[i] += (state.position[i] - m_scratch[i]) / task.h;
            m_scratch[i] = state.velocityBefore[i];
            state.velocityBefore[i] = m_velocityBefore[i];
        }
    fillLoads(task, state, h, {state.velocity, m_scratch, m_velocityBefore});
    m_nearby = state.position;
    predict(task.system, state, h);
    task.nearby = m_nearby;
    project(task, state, h);
    m_clock.lap(StepStage::Rods);
}

void Stepper::predict(const System& system, State& state, double h)
{
    move(ParticlePass::Predict, system, state, h);
    m_pinWays.lookBack(state, m_before, h);
    m_clock.lap(StepStage::Motion);
    noteRodLengths(system, state);
    m_clock.lap(StepStage::Tearing);
}

// The classical Runge-Kutta method of fourth order, for all but the rods: leaves the mean
// acceleration of the substep in m_acceleration and the mean velocity in m_scratch. The first of
// the four has been filled.
void Stepper::takeMeans(const System& system, State& state, double h)
{
    auto& [startVelocity, sumOfVelocities, sumOfAccelerations] = m_stage;
    m_before = state.position;
    startVelocity = sumOfVelocities = state.velocity;
    sumOfAccelerations = m_acceleration;
    for (int stage = 1; stage <= 3; ++stage) {
        const double way = stage < 3 ? 0.5 * h : h;
        const double weight = stage < 3 ? 2.0 : 1.0;
        for (std::size_t i = 0; i < state.position.size(); ++i)
            if (system.inverseMass[i] > 0.0) {
                state.position[i] = m_before[i] + way * state.velocity[i];
                state.velocity[i] = startVelocity[i] + way * m_acceleration[i];
                sumOfVelocities[i] += weight * state.velocity[i];
            }
        fillAccelerations(system, state, h);
        for (std::size_t i = 0; i < state.position.size(); ++i)
            sumOfAccelerations[i] += weight * m_acceleration[i];
    }
    state.position = m_before;
    state.velocity = startVelocity;
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        m_acceleration[i] = sumOfAccelerations[i] / 6.0;
        m_scratch[i] = sumOfVelocities[i] / 6.0;
    }
}

void Stepper::move(ParticlePass pass, const System& system, State& state, double h)
{
    const bool drifts = state.driftSubstep == h;
    const bool damps = dampsImplicitly(system);
    const ParticleMotion motion{state.position.data(),
                                state.velocity.data(),
                                state.drift.data(),
                                state.velocityBefore.data(),
                                m_before.data(),
                                m_scratch.data(),
                                (damps ? m_implicit : m_acceleration).data(),
                                system.inverseMass.data(),
                                h,
                                reachOf(m_integrator, h, drifts),
                                m_keep,
                                drifts,
                                damps};
    m_pool.parallelFor(state.position.size(), [&](std::size_t first, std::size_t last) {
        runPass(pass, m_integrator, motion, first, last);
    });
}

// A line that gets tight stops what it holds within a substep. BDF2 goes on from how things moved
// before, which throws them back with half of their speed, and lines that do so again and again
// give more than they took: such a substep is done again as the first one, which is of implicit
// Euler, and so are the next two: what moved before the line held is then forgotten.
void Stepper::beginAnew(RodTask& task, State& state, double h)
{
    state.driftSubstep = 0.0;
    task.h = h;
    if (!task.damping.empty())
        withDamping(task.system, m_damping, h, {m_seen, state.velocityBefore, {}}, m_acceleration,
                    m_implicit);
    move(ParticlePass::PredictAnew, task.system, state, h);
    project(task, state, h);
    m_clock.lap(StepStage::Rods);
}

void Stepper::noteRodLengths(const System& system, const State& state)
{
    for (const int tearable : system.tearableRods) {
        const Rod& rod = system.rods[std::size_t(tearable)];
        m_rodLength[std::size_t(tearable)] =
            (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)]).norm();
    }
}

void Stepper::project(RodTask& task, State& state, double h)
{
    const bool drifts = m_integrator == Integrator::Bdf2 && state.driftSubstep == h;
    const std::span<const PaddedVec3> drift = state.drift;
    const bool damps = task.solver != Solver::PaperJacobi; // which knows of no compliance either
    m_heldLength = damps ? m_rodDamping.lengthsFor(
                       task.system, m_restLength,
                       {m_before, drifts ? drift : drift.first(0), h, task.h}, m_pool)
                         : m_restLength;
    m_reach = damps ? task.h : std::numeric_limits<double>::infinity();
    task.restLength = m_heldLength;
    task.damped = m_rodDamping.rods();
    task.gone = state.panelGone;
    task.drift = drifts ? drift : drift.first(0);
    task.substep = h;
    m_rods.project(task, m_pool);
    // Of single sweeps the tension of one substep says little; rods then tear by the mean over the
    // step before.
    if (m_tearsByForce && task.solver == Solver::SmallSteps)
        m_rods.takeDirectTensions(state.rodTension);
    else if (m_tearsByForce)
        m_rods.takeTensions(task, m_pool, state.rodTension);
}

} // namespace ripstop
