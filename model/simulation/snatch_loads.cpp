#include "simulation/snatch_loads.h"

#include "measure/diagnostics.h"
#include "step/inputs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace ripstop {
namespace {

double takenBy(const Stepper& stepper, const System& system) // J, in the last step
{
    return stepper.numericalDamping().taken * system.timeStep;
}

} // namespace

// What it takes must also be some part of the energy of the motion: light lines get tight all the
// time.
bool SnatchLoads::needFinerStep(const System& system, const State& state, const Stepper& stepper)
{
    constexpr double mostOfStretch = 0.02;
    constexpr double leastOfMotion = 0.001;
    if (!stepper.hasSnatch() || system.solver != Solver::Auto)
        return false;
    const double taken = takenBy(stepper, system);
    return taken > leastOfMotion * kineticEnergy(system, state)
           && taken > mostOfStretch * stretchOf(system, state);
}

void SnatchLoads::note(const System& system, const Stepper& stepper)
{
    m_taken[m_next] = takenBy(stepper, system);
    m_next = (m_next + 1) % m_taken.size();
    m_sinceSnatch = stepper.hasSnatch() ? 0 : std::min(m_sinceSnatch + 1, m_taken.size());
}

double SnatchLoads::shortfall(const System& system, const State& state)
{
    const bool begins = state.step <= std::int64_t(m_taken.size());
    if (begins || m_sinceSnatch == m_taken.size())
        return 0.0;
    const double taken = std::accumulate(m_taken.begin(), m_taken.end(), 0.0);
    const double stretch = stretchOf(system, state);
    return stretch > 0.0 ? std::sqrt(1.0 + taken / stretch) - 1.0 : 0.0;
}

double SnatchLoads::stretchOf(const System& system, const State& state)
{
    m_restLength.resize(system.rods.size());
    fillRestLengths(system, state, m_restLength);
    return stretchEnergy(system, state, m_restLength);
}

} // namespace ripstop
