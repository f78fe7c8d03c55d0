#include "forces/panel_load.h"

#include "forces/wind.h"
#include "parallel/simd_pack.h"

#include <algorithm>
#include <cstdint>

namespace ripstop {
namespace {

struct PanelWork
{
    const FabricPanel* panels;
    const MaterialAir* airs;
    const std::uint8_t* gone;   // [panels]
    const PaddedVec3* position; // [particles] m
    const PaddedVec3* velocity; // [particles] m/s
    Vec3 wind;                  // m/s, what is the same everywhere
    const System* system;       // whose other winds depend on the place, or null
    const State* state;
    double airDensity;  // kg/m^3
    PaddedVec3* load;   // [panels] N
    double nudge = 0.0; // m/s, added to the wind along the normal
};

} // namespace
} // namespace ripstop

#define RIPSTOP_KERNEL "forces/panel_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {

namespace {

PanelWork workOf(const System& system, const State& state, std::span<PaddedVec3> load)
{
    return {system.panels.data(),
            system.materialAir.data(),
            state.panelGone.data(),
            state.position.data(),
            state.velocity.data(),
            commonWind(system, state),
            hasLocalWind(system, state) ? &system : nullptr,
            &state,
            system.airDensity,
            load.data()};
}

} // namespace

Vec3 panelLoad(const MaterialAir& air, const Vec3& a, const Vec3& b, const Vec3& c,
               const Vec3& apparentWind, double airDensity)
{
    const FabricPanel alone = {{0, 1, 2}, 0};
    const std::uint8_t gone = 0;
    const PaddedVec3 position[3] = {a, b, c};
    const PaddedVec3 velocity[3];
    PaddedVec3 load;
    const PanelWork work = {&alone,       &air,    &gone,   position,   velocity,
                            apparentWind, nullptr, nullptr, airDensity, &load};
    (wideMachine ? wide::fillPanels : anywhere::fillPanels)(work, 0, 1);
    return load;
}

void fillPanelLoads(const System& system, const State& state, ThreadPool& pool,
                    std::span<PaddedVec3> load)
{
    fillPanelLoads(system, state, pool, load, wideMachine);
}

void fillNudgedPanelLoads(const System& system, const State& state, double nudge,
                          std::span<PaddedVec3> load)
{
    PanelWork work = workOf(system, state, load);
    work.nudge = nudge;
    (wideMachine ? wide::fillPanels : anywhere::fillPanels)(work, 0, system.panels.size());
}

void fillPanelLoads(const System& system, const State& state, ThreadPool& pool,
                    std::span<PaddedVec3> load, bool asWide)
{
    const PanelWork work = workOf(system, state, load);
    pool.parallelFor(system.panels.size(), [&](std::size_t first, std::size_t last) {
        (asWide ? wide::fillPanels : anywhere::fillPanels)(work, first, last);
    });
}

} // namespace ripstop
