// A blow is told by what lines hold before and after the step; a late break by what the stepper saw
// break, less what was above its strength already.
#include "simulation/snatch_loads.h"

#include "forces/spring_force.h"
#include "measure/diagnostics.h"
#include "step/inputs.h"
#include "tearing/tearing.h"

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

void SnatchLoads::note(const System& system, const Stepper& stepper, bool wasTooLong)
{
    m_taken[m_next] = takenBy(stepper, system);
    m_next = (m_next + 1) % m_taken.size();
    const bool isBlow = stepper.hasSnatch() || wasTooLong;
    m_sinceBlow = isBlow ? 0 : std::min(m_sinceBlow + 1, m_taken.size());
}

double SnatchLoads::shortfall(const System& system, const State& before, const State& after)
{
    const bool begins = after.step <= std::int64_t(m_taken.size());
    if (begins || m_sinceBlow == m_taken.size())
        return 0.0;
    const double taken = std::accumulate(m_taken.begin(), m_taken.end(), 0.0);
    const double stretch = std::max(stretchOf(system, before), stretchOf(system, after));
    return stretch > 0.0 ? std::sqrt(1.0 + taken / stretch) - 1.0 : 0.0;
}

// All of this must be some part of the energy of the motion: light lines get tight all the time.
bool SnatchLoads::isTooLong(const System& system, const State& before, const State& after,
                            const Stepper& stepper)
{
    constexpr double leastOfMotion = 0.001;
    constexpr double mostChange = 0.2;
    constexpr double mostOfStretch = 0.02;
    if (stepper.integrator() != Integrator::Bdf2)
        return false;
    const double least = leastOfMotion * kineticEnergy(system, after);
    const double taken = takenBy(stepper, system);
    const auto [less, more] =
        std::minmax({stretchOfLines(system, before), stretchOfLines(system, after)});
    if (more > least && more - less > mostChange * more)
        return true;
    return taken > least && (stepper.hasSnatch() || taken < more)
           && taken > mostOfStretch * stretchOf(system, after);
}

int SnatchLoads::finerForBreaks(const System& system, const State& before, const Stepper& stepper,
                                int finer)
{
    constexpr double most = 256.0;
    constexpr double mostWork = 65536.0; // particles, in all substeps of one
    if (!(stepper.lateBreak() > system.accuracy))
        return finer;
    const double late = stepper.lateBreak() - mostOverloadOfLines(system, before);
    if (!(late > system.accuracy))
        return finer;
    const double enough = std::exp2(std::ceil(std::log2(late / system.accuracy * finer)));
    const double worth = std::min(most, mostWork / double(before.position.size()));
    return std::max(finer, int(std::min(enough, worth)));
}

double SnatchLoads::stretchOf(const System& system, const State& state)
{
    return stretchEnergy(system, state, lengths(system, state));
}

// Of those that resist one way only.
double SnatchLoads::stretchOfLines(const System& system, const State& state)
{
    double sum = 0.0;
    const std::span rest = lengths(system, state);
    for (std::size_t i = 0; i < system.rods.size(); ++i) {
        const Rod& rod = system.rods[i];
        if (rod.resists == Resists::Both || rod.compliance == 0.0 || state.rodTorn[i])
            continue;
        const Vec3 along = state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)];
        sum += elasticEnergy(1.0 / rod.compliance, rod.resists, along.norm() - rest[i]);
    }
    return sum;
}

std::span<const double> SnatchLoads::lengths(const System& system, const State& state)
{
    m_restLength.resize(system.rods.size());
    fillRestLengths(system, state, m_restLength);
    return m_restLength;
}

} // namespace ripstop
