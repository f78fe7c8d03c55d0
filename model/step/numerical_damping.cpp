// One pass over the particles; the sums are taken in the order of parts, so that threads change no
// bit.
#include "step/numerical_damping.h"

#include "parallel/ordered_parts.h"

#include <algorithm>
#include <numbers>

namespace ripstop {
namespace {

// What moves more slowly than this is at rest, and rounding turns it.
constexpr double still = 1e-6;  // m/s
constexpr double weight = 10.0; // m/s^2

bool isHeld(const System& system, std::size_t particle)
{
    const auto hasAny = [&](const Rows& rows) {
        return rows.start[particle + 1] > rows.start[particle];
    };
    return hasAny(system.rodsAt) || (!system.membranes.empty() && hasAny(system.panelsAt));
}

// Where an integrator looks back, the way (x - previous x) / h of the last substep, d, tells of the
// substep before as well: 2 d - v2 - v1 is half of v2 - 2 v1 + v0, but for terms of higher order.
Vec3 secondDifference(const State& state, std::size_t i)
{
    return 2.0 * (2.0 * state.drift[i] - state.velocity[i] - state.velocityBefore[i]);
}

} // namespace

double NumericalDamping::ratio() const
{
    return turned > 0.0 ? taken / (std::numbers::pi * turned) : 0.0;
}

void NumericalDamping::add(const NumericalDamping& other, double share)
{
    taken += share * other.taken;
    turned += share * other.turned;
}

NumericalDamping numericalDampingOf(const System& system, const State& state,
                                    std::span<const PaddedVec3> start,
                                    std::span<const std::uint32_t> touches, StepFormula formula,
                                    double substep, ThreadPool& pool)
{
    const bool isBdf2 = formula == StepFormula::Bdf2;
    if (start.empty())
        return {};
    NumericalDamping all;
    inOrderedParts(
        pool, state.position.size(),
        [&](std::size_t first, std::size_t last) {
            NumericalDamping part;
            for (std::size_t i = first; i < last; ++i) {
                const bool counts = system.inverseMass[i] > 0.0 && (touches.empty() || !touches[i])
                                    && (isBdf2 || isHeld(system, i));
                if (!counts)
                    continue;
                const double mass = 1.0 / system.inverseMass[i];
                const Vec3 change = state.velocity[i] - start[i];
                const Vec3 mean = 0.5 * (state.velocity[i] + start[i]);
                part.turned +=
                    mass * (mean.cwiseAbs().dot(change.cwiseAbs()) + still * weight * substep);
                part.taken += isBdf2 ? 0.5 * mass * secondDifference(state, i).squaredNorm()
                                     : mass * change.squaredNorm();
            }
            return part;
        },
        [&](const NumericalDamping& part) { all.add(part, 1.0); });
    return {all.taken / substep, all.turned / substep};
}

} // namespace ripstop
