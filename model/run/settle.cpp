#include "run/settle.h"

#include "measure/diagnostics.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

double highestSpeed(const System& system, const State& state)
{
    double square = 0.0;
    for (std::size_t i = 0; i < state.velocity.size(); ++i)
        if (system.inverseMass[i] > 0.0)
            square = std::max(square, state.velocity[i].squaredNorm());
    return std::sqrt(square);
}

// s: of a pendulum as long as all of it is large, pi sqrt(L / g); 0 without weight.
double longestHalfSwing(const System& system, const State& state)
{
    const double gravity = system.gravity.norm();
    if (state.position.empty() || gravity == 0.0)
        return 0.0;
    Vec3 low = state.position.front(), high = low;
    for (const auto& place : state.position) {
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
    }
    return std::numbers::pi * std::sqrt((high - low).norm() / gravity);
}

} // namespace

Settler::Settler(const SettleGoal& goal, const Simulation& simulation)
    : m_goal(goal)
    , m_start(simulation.state().time)
    , m_still(m_start)
    , m_during(std::max(goal.during, longestHalfSwing(simulation.system(), simulation.state())))
    , m_run(simulation.system().run)
{
    m_progress.goal = goal.speed;
    m_progress.within = goal.within;
    m_progress.number = goal.number;
}

void Settler::look(Simulation& simulation)
{
    const State& state = simulation.state();
    const double kinetic = kineticEnergy(simulation.system(), state);
    m_progress.speed = highestSpeed(simulation.system(), state);
    m_progress.kinetic = kinetic;
    m_progress.since = state.time - m_start;
    if (m_progress.speed > m_goal.speed) {
        m_still = state.time;
        m_tooFast = m_progress.speed;
    }
    const double roundOff = 1e-9; // s
    if (state.time - m_still >= m_during - roundOff)
        m_progress.outcome = Settling::Outcome::Still;
    else if (m_progress.since >= m_goal.within - roundOff)
        m_progress.outcome = Settling::Outcome::GaveUp;
    if (m_progress.outcome == Settling::Outcome::GaveUp)
        m_progress.speed = std::max(m_progress.speed, m_tooFast);

    // Stiff links tremble on top of the motion that matters, and take up slack right after a halt:
    // neither is a peak.
    constexpr double passed = 0.9; // of the energy of the peak
    constexpr int fewest = 8;      // steps between two halts
    ++m_steps;
    m_peak = std::max(m_peak, kinetic);
    if (!m_goal.damped || m_progress.outcome != Settling::Outcome::Under || m_steps < fewest
        || kinetic >= passed * m_peak)
        return;
    simulation.halt();
    m_peak = 0.0;
    m_steps = 0;
}

} // namespace ripstop
