#include "forces/air_step.h"

#include "forces/panel_load.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

constexpr double nudge = 0.05; // m/s

} // namespace

// By a difference of loads. The damping of a panel is at least 0: past the stall the load falls as
// the panel meets the air faster, and damps nothing.
void addAirDamping(const System& system, const State& state, Damping& damping)
{
    damping.more.resize(system.panels.size());
    damping.less.resize(system.panels.size());
    fillNudgedPanelLoads(system, state, nudge, damping.more);
    fillNudgedPanelLoads(system, state, -nudge, damping.less);
    for (std::size_t i = 0; i < system.panels.size(); ++i) {
        if (state.panelGone[i])
            continue;
        const auto [a, b, c] = system.panels[i].corner;
        const Vec3& first = state.position[std::size_t(a)];
        const Vec3 normal = (state.position[std::size_t(b)] - first)
                                .cross(state.position[std::size_t(c)] - first)
                                .normalized();
        const double slope = (damping.more[i] - damping.less[i]).dot(normal) / (2.0 * nudge);
        const Mat3 third = std::max(0.0, slope) / 3.0 * normal * normal.transpose();
        for (const int corner : {a, b, c})
            damping.at[std::size_t(corner)] += third;
    }
}

} // namespace ripstop
