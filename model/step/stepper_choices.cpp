// What a step takes: how many substeps, and what is solved together in them, by the plan of
// Solver::Auto and the motion of now.
#include "step/stepper.h"
#include "step/true_swings.h"

#include <algorithm>

namespace ripstop {

int Stepper::substepsOf(const System& system, const State& state) const
{
    return chosenSubsteps(system, state) * m_refinement;
}

double Stepper::fastestTrueSwing(const System& system, const State& state) const
{
    if (m_serial != system.serial)
        return 0.0;
    const bool held = !system.rods.empty() || !system.membranes.empty();
    return ripstop::fastestTrueSwing(m_integrator, held,
                                     system.timeStep / substepsOf(system, state));
}

int Stepper::chosenSubsteps(const System& system, const State& state) const
{
    if (system.solver != Solver::Auto)
        return system.substeps;
    const int least = m_planFor.isOf(system) ? m_plan.least : system.substeps;
    if (state.substeps > 0)
        return std::max(state.substeps, least);
    return m_planFor.isOf(system) ? std::max(m_plan.substeps, substepsForDamping(system, state))
                                  : system.substeps;
}

// Sweeps show by their strain when the air asks for more substeps.
int Stepper::substepsForDamping(const System& system, const State& state) const
{
    return m_plan.direct.empty()
               ? 1
               : ripstop::substepsForDamping(system, state, dampsImplicitly(system), m_damping);
}

// Whether what forces take from motion joins the masses (end_loads.h).
bool Stepper::dampsImplicitly(const System& system) const
{
    return system.solver == Solver::Auto && m_plan.together && isImplicit(m_integrator)
           && system.airDensity > 0.0;
}

bool Stepper::solvesTogether(const System& system) const
{
    return system.solver == Solver::Direct || (system.solver == Solver::Auto && m_plan.together);
}

// Whether obstacles are solved together with rods: where all rods are, by an integrator that moves
// particles to where rods put them.
bool Stepper::solvesContact(const System& system) const
{
    return solvesTogether(system) && !system.obstacles.empty()
           && (isImplicit(m_integrator) || m_integrator == Integrator::SemiImplicitEuler);
}

// What BDF2 has missed once, as where cloth flaps or lands, it would miss again soon: it takes
// fewer substeps only after a while.
void Stepper::adapt(const System& system, State& state, int substeps)
{
    constexpr int whileOf = 64; // steps
    int next = adaptedSubsteps(substeps, m_plan.least, m_accuracy.ratio(system));
    if (m_plan.together && m_integrator == Integrator::Bdf2 && state.step % whileOf != 0)
        next = std::max(next, substeps);
    state.substeps = std::max(next, substepsForDamping(system, state));
}

// BDF2 begins with implicit Euler, which takes (w h)^2 of the energy of a swing each time. So the
// first step of a run is cut into many, where all rods stretch: others would only ring in what the
// solver makes of them.
bool Stepper::beginsBdf2(const System& system, const State& state) const
{
    return m_integrator == Integrator::Bdf2 && solvesTogether(system) && state.step == 0
           && state.driftSubstep == 0.0
           && std::ranges::all_of(system.rods, [](const Rod& rod) { return rod.compliance > 0.0; });
}

} // namespace ripstop
