// The longest substep at each particle of a scene that is not compiled (base/step_limit.h).
#pragma once

#include "scene/element_index.h"
#include "scene/scene.h"

namespace ripstop {

struct StepLimits
{
    std::vector<double> timeStep; // s, [particles] through all parts; infinity where nothing asks
    bool bends = false;           // something resists bending
};
StepLimits stepLimitsOf(const Scene& scene, const ElementIndex& index);

} // namespace ripstop
