#include "verify/at_rest.h"

#include "compile/compile.h"
#include "run/simulation.h"

#include <limits>

namespace ripstop {

AtRest restOf(const Scene& scene, double seconds)
{
    AtRest result{*compile(scene), {}};
    Simulation simulation(result.system);
    const bool arrived = simulation.runUntil(seconds);
    result.state = simulation.state();
    if (!arrived)
        for (PaddedVec3& x : result.state.position)
            x = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    return result;
}

} // namespace ripstop
