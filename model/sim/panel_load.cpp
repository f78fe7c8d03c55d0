#include "sim/panel_load.h"

#include <Eigen/Geometry>

namespace ripstop {

Vec3 panelLoad(const FabricPanel& panel, const Vec3& a, const Vec3& b, const Vec3& c,
               const Vec3& apparentWind, double airDensity)
{
    const Vec3 areaVector = 0.5 * (b - a).cross(c - a); // its length is the area
    const double area = areaVector.norm();
    if (area == 0.0 || panel.law == AirLaw::None)
        return Vec3::Zero();

    const Vec3 normal = areaVector / area;
    const double headOn = normal.dot(apparentWind);                                          // m/s
    const double pace = panel.law == AirLaw::Paper ? std::abs(headOn) : apparentWind.norm(); // m/s
    Vec3 load = (panel.normalCoefficient * pace * headOn) * normal;
    if (panel.skinFriction > 0.0) {
        const Vec3 along = apparentWind - headOn * normal;
        load += (panel.skinFriction * along.norm()) * along;
    }
    return (0.5 * airDensity * area) * load;
}

void fillPanelLoads(const System& system, const State& state, Crew& crew,
                    std::span<PaddedVec3> load)
{
    crew.each(system.panels.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (state.panelGone[i]) {
                load[i].setZero();
                continue;
            }
            const auto a = std::size_t(system.panels[i].corner[0]);
            const auto b = std::size_t(system.panels[i].corner[1]);
            const auto c = std::size_t(system.panels[i].corner[2]);
            const Vec3 panelVelocity =
                (state.velocity[a] + state.velocity[b] + state.velocity[c]) / 3.0;
            load[i] = panelLoad(system.panels[i], state.position[a], state.position[b],
                                state.position[c], system.wind - panelVelocity, system.airDensity);
        }
    });
}

} // namespace ripstop
