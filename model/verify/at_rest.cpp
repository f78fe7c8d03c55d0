#include "verify/at_rest.h"

#include "compile/compile.h"
#include "simulation/simulation.h"

#include <limits>

namespace ripstop {

double AtRest::against(const std::vector<Vec3>& way) const
{
    double sum = 0.0;
    for (const Membrane& membrane : system->membranes) {
        const Corners corners = cornersOf(*system, membrane, state.position);
        const Vec3 tension = tensionIn(*system, membrane, corners).tension;
        const auto [warp, weft] =
            axesOf(membrane, corners[1] - corners[0], corners[2] - corners[0]);
        const auto& corner = system->panels[std::size_t(membrane.panel)].corner;
        for (int k = 0; k < 3; ++k) {
            const auto [along, across] = gradient(membrane, k);
            const Vec3 pull = (tension[0] * along + tension[2] * across) * warp
                              + (tension[2] * along + tension[1] * across) * weft;
            sum += membrane.area * pull.dot(way[std::size_t(corner[std::size_t(k)])]);
        }
    }
    return sum;
}

AtRest restOf(const Scene& scene, double seconds)
{
    const std::shared_ptr<const System> system = *compile(scene);
    return restOf(system, system->start, seconds);
}

AtRest restOf(std::shared_ptr<const System> system, const State& from, double seconds)
{
    Simulation simulation(system, from);
    const bool arrived = simulation.runUntil(from.time + seconds);
    AtRest rest{std::move(system), simulation.state()};
    if (!arrived)
        for (PaddedVec3& x : rest.state.position)
            x = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    return rest;
}

} // namespace ripstop
