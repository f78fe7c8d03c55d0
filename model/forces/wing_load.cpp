#include "forces/wing_load.h"

#include "forces/wind.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

struct Panel // as it is in a state
{
    Vec3 normal; // m^2, twice the area long
    Vec3 middle; // m
    Vec3 motion; // m/s
};

Panel panelIn(const FabricPanel& panel, const State& state)
{
    const auto [a, b, c] = panel.corner;
    const auto& x = state.position;
    const auto& v = state.velocity;
    const Vec3& from = x[std::size_t(a)];
    const Vec3& toB = x[std::size_t(b)];
    const Vec3& toC = x[std::size_t(c)];
    return {(toB - from).cross(toC - from), (from + toB + toC) / 3.0,
            (v[std::size_t(a)] + v[std::size_t(b)] + v[std::size_t(c)]) / 3.0};
}

} // namespace

void listWings(System& system)
{
    system.of<FabricLists>().wings.clear();
    const auto isWing = [](const MaterialAir& air) { return air.stall > 0.0; };
    if (std::none_of(system.materialAir.begin(), system.materialAir.end(), isWing))
        return;
    std::vector<std::array<int, 3>> corners;
    std::vector<std::uint8_t> member;
    std::vector<Vec3> wind;
    for (const FabricPanel& panel : system.panels) {
        const Panel start = panelIn(panel, system.start);
        corners.push_back(panel.corner);
        member.push_back(isWing(system.materialAir[std::size_t(panel.air)]));
        wind.push_back(system.wind + localWind(system, start.middle) - start.motion);
    }
    system.of<FabricLists>().wings = wingsOf(corners, member, system.start.position, wind);
}

void WingLoads::add(const System& system, const State& state, std::span<PaddedVec3> load)
{
    const bool isLocal = hasLocalWind(system, state);
    for (const WingStrips& wing : system.of<FabricLists>().wings) {
        const Vec3 common = commonWind(system, state);
        m_panels.resize(std::max(m_panels.size(), wing.panels.size()));
        const std::span<WingPanel> panels(m_panels.data(), wing.panels.size());
        for (std::size_t i = 0; i < panels.size(); ++i) {
            const std::size_t place = std::size_t(wing.panels[i]);
            const FabricPanel& fabric = system.panels[place];
            const MaterialAir& air = system.materialAir[std::size_t(fabric.air)];
            const Panel panel = panelIn(fabric, state);
            panels[i].normal = panel.normal;
            panels[i].wind = common - panel.motion;
            if (isLocal)
                panels[i].wind += localWind(system, state, panel.middle);
            panels[i].plate = air.normalCoefficient;
            panels[i].saturation = air.saturation;
            panels[i].stall = air.stall;
            panels[i].gone = state.panelGone[place] != 0;
        }
        fillWingLoads(wing, rimOf(wing.front, state.position), rimOf(wing.rear, state.position),
                      system.airDensity, panels);
        for (std::size_t i = 0; i < panels.size(); ++i)
            load[std::size_t(wing.panels[i])] += panels[i].load;
    }
}

} // namespace ripstop
