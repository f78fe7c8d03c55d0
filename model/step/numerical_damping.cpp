// One pass over the particles; the sums are taken in the order of parts, so that threads change no
// bit.
#include "step/numerical_damping.h"

#include "base/portable_math.h"
#include "parallel/ordered_parts.h"

#include <array>
#include <numbers>

namespace ripstop {
namespace {

// What moves more slowly than this is at rest, and rounding turns it.
constexpr double memory = 10.0; // s

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

// What is left of a change of velocity, m/s, across the rods of a particle that never stretch.
Vec3 acrossRigidRods(const System& system, const State& state, std::size_t particle, Vec3 change)
{
    constexpr double independent = 0.1; // 1, of a direction that others do not have
    std::array<Vec3, 3> along;
    std::size_t count = 0;
    const Rows& rodsAt = system.rodsAt;
    for (int k = rodsAt.start[particle]; k < rodsAt.start[particle + 1]; ++k) {
        const auto r = std::size_t(rodsAt.items[std::size_t(k)]);
        const Rod& rod = system.rods[r];
        if (rod.compliance > 0.0 || state.rodTorn[r] || count == along.size())
            continue;
        Vec3 direction =
            (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)]).normalized();
        for (std::size_t other = 0; other < count; ++other)
            direction -= direction.dot(along[other]) * along[other];
        if (direction.norm() < independent)
            continue;
        along[count++] = direction.normalized();
        change -= change.dot(along[count - 1]) * along[count - 1];
    }
    return change;
}

} // namespace

double NumericalDamping::ratio() const
{
    return turned > 0.0 ? taken / (std::numbers::pi * turned) : 0.0;
}

void NumericalDamping::follow(const NumericalDamping& step, double timeStep)
{
    const double kept = portableExp(-timeStep / memory);
    taken = kept * taken + step.taken * timeStep;
    turned = kept * turned + step.turned * timeStep;
}

NumericalDamping numericalDampingOf(const System& system, const State& state,
                                    std::span<const PaddedVec3> start,
                                    std::span<const std::uint32_t> touches, Integrator integrator,
                                    double substep, ThreadPool& pool)
{
    const bool isBdf2 = integrator == Integrator::Bdf2;
    const bool isFirst = isBdf2 && state.driftSubstep != substep; // also after an impact
    if (start.empty() || isFirst)
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
                const auto across = [&](const Vec3& change) {
                    return acrossRigidRods(system, state, i, change);
                };
                const Vec3 change = across(state.velocity[i] - start[i]);
                part.turned += mass
                               * (0.5 * (state.velocity[i] + start[i]).norm() * change.norm()
                                  + still * weight * substep);
                part.taken += isBdf2 ? 0.5 * mass * across(secondDifference(state, i)).squaredNorm()
                                     : mass * change.squaredNorm();
            }
            return part;
        },
        [&](const NumericalDamping& part) {
            all.taken += part.taken;
            all.turned += part.turned;
        });
    return {all.taken / substep, all.turned / substep};
}

} // namespace ripstop
