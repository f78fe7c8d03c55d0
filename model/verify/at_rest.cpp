#include "verify/at_rest.h"

#include "compile/compile.h"
#include "run/simulation.h"

#include <limits>

namespace ripstop {

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
