#include "forces/bend_force.h"

#include "base/step_limit.h"
#include "parallel/simd_pack.h"

#include <algorithm>
#include <limits>

namespace ripstop {
namespace {

bool isGone(const System& system, const State& state, const Bend& bend)
{
    if (bend.ofSpar)
        return isTorn(system.links[std::size_t(bend.of[0])], state)
               || isTorn(system.links[std::size_t(bend.of[1])], state);
    return state.panelGone[std::size_t(bend.of[0])] || state.panelGone[std::size_t(bend.of[1])];
}

Vec3 sum(const Bend& bend, const std::vector<PaddedVec3>& x)
{
    Vec3 sum = bend.weight[0] * x[std::size_t(bend.corner[0])];
    for (std::size_t k = 1; k < 4; ++k)
        sum += bend.weight[k] * x[std::size_t(bend.corner[k])];
    return sum;
}

RIPSTOP_CLONES
void fillTurns(const System& system, const State& state, PaddedVec3* turn, std::size_t first,
               std::size_t last)
{
    const PaddedVec3* const x = state.position.data();
    for (std::size_t i = first; i < last; ++i) {
        const Bend& bend = system.bends[i];
        if (isGone(system, state, bend)) {
            pack(turn[i]) = Pack{};
            continue;
        }
        Pack y = bend.weight[0] * pack(x[bend.corner[0]]);
        for (std::size_t k = 1; k < 4; ++k)
            y += bend.weight[k] * pack(x[bend.corner[k]]);
        pack(turn[i]) = y;
    }
}

// What the bend's own turn gives, N per m of it.
double ownMoment(const Bend& bend, const Vec3& turn)
{
    const double size = bend.restTurn > 0.0 ? turn.norm() : 0.0;
    return size > 0.0 ? bend.stiffness * (1.0 - bend.restTurn / size) : bend.stiffness;
}

RIPSTOP_CLONES
void fillMoments(const System& system, const State& state, const PaddedVec3* turn,
                 PaddedVec3* moment, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        const Bend& bend = system.bends[i];
        if (isGone(system, state, bend)) {
            pack(moment[i]) = Pack{};
            continue;
        }
        Pack z = ownMoment(bend, turn[i]) * pack(turn[i]);
        if (!bend.ofSpar)
            for (std::size_t k = 0; k < 4; ++k)
                if (bend.beside[k] >= 0)
                    z += bend.coupling[k] * pack(turn[bend.beside[k]]);
        pack(moment[i]) = z;
    }
}

} // namespace

void fillBends(const System& system, const State& state, ThreadPool& pool,
               std::span<PaddedVec3> turn, std::span<PaddedVec3> moment)
{
    const std::size_t count = system.bends.size();
    pool.parallelFor(count, [&](std::size_t first, std::size_t last) {
        fillTurns(system, state, turn.data(), first, last);
    });
    pool.parallelFor(count, [&](std::size_t first, std::size_t last) {
        fillMoments(system, state, turn.data(), moment.data(), first, last);
    });
}

double bendingEnergy(const System& system, const State& state)
{
    const auto turnOf = [&](const Bend& bend) {
        return isGone(system, state, bend) ? Vec3(Vec3::Zero()) : Vec3(sum(bend, state.position));
    };
    double energy = 0.0;
    for (const Bend& bend : system.bends) {
        if (isGone(system, state, bend))
            continue;
        const Vec3 turn = turnOf(bend);
        const double own = turn.norm() - bend.restTurn;
        energy += 0.5 * bend.stiffness * own * own;
        for (std::size_t k = 0; k < 4; ++k)
            if (bend.beside[k] >= 0)
                energy += 0.5 * bend.coupling[k]
                          * turn.dot(turnOf(system.bends[std::size_t(bend.beside[k])]));
    }
    return energy;
}

double bendStepLimit(const System& system)
{
    double limit = std::numeric_limits<double>::infinity();
    if (system.bends.empty())
        return limit;
    std::vector<double> stiffness = bendSums(system.bends, system.inverseMass.size());
    std::vector<double> damping(stiffness.size(), 0.0);
    for (const Spring& spring : system.springs)
        for (const int end : {spring.a, spring.b}) {
            stiffness[std::size_t(end)] += spring.stiffness;
            damping[std::size_t(end)] += spring.damping;
        }
    for (std::size_t i = 0; i < stiffness.size(); ++i)
        if (system.inverseMass[i] > 0.0)
            limit = std::min(
                limit, springStepLimit(1.0 / system.inverseMass[i], stiffness[i], damping[i]));
    return limit;
}

} // namespace ripstop
