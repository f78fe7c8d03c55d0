#include "step/end_loads.h"

#include <algorithm>

namespace ripstop {
namespace {

// Of the accuracy wanted, rad: the load on cloth at an angle a to the wind changes by the share
// da / tan a, and sails fly at some five degrees and more.
constexpr double turnThatMatters = 0.05;

} // namespace

void withDamping(const System& system, const Damping& damping, double reach,
                 const SeenVelocities& velocities, std::span<const PaddedVec3> acceleration,
                 std::vector<PaddedVec3>& result)
{
    result.assign(acceleration.begin(), acceleration.end());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const Mat3& at = damping.at[i];
        if (system.inverseMass[i] == 0.0 || at.isZero(0.0))
            continue;
        const Vec3 now = velocities.now[i];
        const Vec3 begin =
            velocities.before.empty() ? now : Vec3((4.0 * now - velocities.before[i]) / 3.0);
        const Mat3 inertia = Mat3::Identity() / system.inverseMass[i] + reach * at;
        result[i] +=
            inertia.inverse() * (at * (Vec3(velocities.seen[i]) - begin - reach * acceleration[i]));
    }
}

bool hasTurnedFromForeseen(const System& system, const State& state,
                           std::span<const PaddedVec3> start, double h)
{
    const double most = turnThatMatters * system.accuracy;
    const auto missOf = [&](int particle) {
        const auto p = std::size_t(particle);
        return system.inverseMass[p] == 0.0
                   ? Vec3(Vec3::Zero())
                   : Vec3(state.position[p] - start[p] - h * state.velocityBefore[p]);
    };
    const auto turns = [&](int a, int b) {
        const Vec3 side = state.position[std::size_t(b)] - state.position[std::size_t(a)];
        return (missOf(b) - missOf(a)).squaredNorm() > most * most * side.squaredNorm();
    };
    for (std::size_t i = 0; i < system.panels.size(); ++i) {
        const auto [a, b, c] = system.panels[i].corner;
        if (!state.panelGone[i] && (turns(a, b) || turns(a, c)))
            return true;
    }
    return false;
}

} // namespace ripstop
