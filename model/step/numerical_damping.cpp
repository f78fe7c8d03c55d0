// One pass over the particles; the sums are taken in the order of parts, so that threads change no
// bit.
#include "step/numerical_damping.h"

#include "parallel/ordered_parts.h"

#include <algorithm>
#include <array>
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

// The rods at a particle that never stretch. Along each, two ends that turn about each other with
// the velocity w across it come together by |w|^2 / L, which they share as their inverse masses
// are; whatever else a particle does along it is how the rod rings in what the solver makes of it.
class RigidRods
{
public:
    RigidRods(const System& system, const State& state, std::size_t particle, double substep)
    {
        const Rows& rodsAt = system.rodsAt;
        for (int k = rodsAt.start[particle]; k < rodsAt.start[particle + 1]; ++k) {
            const auto r = std::size_t(rodsAt.items[std::size_t(k)]);
            const Rod& rod = system.rods[r];
            if (rod.compliance > 0.0 || state.rodTorn[r] || m_count == m_direction.size())
                continue;
            add(system, state, particle, std::size_t(rod.a) == particle ? rod.b : rod.a, substep);
        }
    }

    // A difference of velocities of substeps, m/s, without what rings in it.
    //   change  m/s, of the velocity in the last substep
    Vec3 withoutRinging(Vec3 difference, const Vec3& change) const
    {
        for (std::size_t k = 0; k < m_count; ++k) {
            const Vec3& along = m_direction[k];
            const double all = along.dot(change);
            const double turning = std::clamp(m_turning[k], std::min(all, 0.0), std::max(all, 0.0));
            const double ringing = all != 0.0 ? 1.0 - turning / all : 1.0;
            difference -= ringing * along.dot(difference) * along;
        }
        return difference;
    }

private:
    // Directions are taken across those before, and what turning takes along each with them.
    void add(const System& system, const State& state, std::size_t own, int end, double substep)
    {
        constexpr double independent = 0.1; // 1, of a direction that others do not have
        const auto other = std::size_t(end);
        const Vec3 way = state.position[other] - state.position[own];
        const double length = way.norm();
        if (!(length > 0.0))
            return;
        Vec3 direction = way / length;
        const Vec3 apart = state.velocity[other] - state.velocity[own];
        const Vec3 across = apart - apart.dot(direction) * direction;
        const double u = system.inverseMass[own], w = system.inverseMass[other];
        double turning = u / (u + w) * across.squaredNorm() / length * substep;
        for (std::size_t k = 0; k < m_count; ++k) {
            const double shared = direction.dot(m_direction[k]);
            direction -= shared * m_direction[k];
            turning -= shared * m_turning[k];
        }
        const double left = direction.norm();
        if (left < independent)
            return;
        m_direction[m_count] = direction / left;
        m_turning[m_count++] = turning / left;
    }

    std::array<Vec3, 3> m_direction; // of length 1, across each other
    std::array<double, 3> m_turning; // m/s in a substep
    std::size_t m_count = 0;
};

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
                const RigidRods rods(system, state, i, substep);
                const Vec3 whole = state.velocity[i] - start[i];
                const Vec3 change = rods.withoutRinging(whole, whole);
                const Vec3 mean = 0.5 * (state.velocity[i] + start[i]);
                part.turned +=
                    mass * (mean.cwiseAbs().dot(change.cwiseAbs()) + still * weight * substep);
                part.taken +=
                    isBdf2
                        ? 0.5 * mass
                              * rods.withoutRinging(secondDifference(state, i), whole).squaredNorm()
                        : mass * change.squaredNorm();
            }
            return part;
        },
        [&](const NumericalDamping& part) { all.add(part, 1.0); });
    return {all.taken / substep, all.turned / substep};
}

} // namespace ripstop
