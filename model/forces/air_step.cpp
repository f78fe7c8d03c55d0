#include "forces/air_step.h"

#include "forces/panel_load.h"
#include "forces/wind.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

constexpr double nudge = 0.01;     // of the apparent wind
constexpr double leastWind = 0.01; // m/s

// Damping of a panel's mean, by a difference of loads. It is at least 0: past the stall the load
// falls as the panel meets the air faster, and damps nothing.
Mat3 dampingOf(const System& system, const State& state, const FabricPanel& panel)
{
    const auto place = [&](int corner) -> const Vec3& {
        return state.position[std::size_t(panel.corner[std::size_t(corner)])];
    };
    Vec3 velocity = Vec3::Zero();
    for (const int corner : panel.corner)
        velocity += state.velocity[std::size_t(corner)] / 3.0;
    const Vec3 middle = (place(0) + place(1) + place(2)) / 3.0;
    const Vec3 wind = windAt(system, state, middle) - velocity;
    const Vec3 normal = (place(1) - place(0)).cross(place(2) - place(0)).normalized();
    const double step = nudge * std::max(wind.norm(), leastWind);
    const auto loadAt = [&](const Vec3& apparent) {
        return panelLoad(system.materialAir[std::size_t(panel.air)], place(0), place(1), place(2),
                         apparent, system.airDensity)
            .dot(normal);
    };
    const double slope = loadAt(wind + step * normal) - loadAt(wind - step * normal);
    return std::max(0.0, slope / (2.0 * step)) * normal * normal.transpose();
}

} // namespace

void addAirDamping(const System& system, const State& state, std::span<Mat3> damping)
{
    for (std::size_t i = 0; i < system.panels.size(); ++i) {
        if (state.panelGone[i])
            continue;
        const FabricPanel& panel = system.panels[i];
        const Mat3 third = dampingOf(system, state, panel) / 3.0;
        for (const int corner : panel.corner)
            damping[std::size_t(corner)] += third;
    }
}

} // namespace ripstop
