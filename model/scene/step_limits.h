// The longest substep that springs and bending allow at each particle of a scene that is not
// compiled, s; the formula and its source stand in base/step_limit.h. The check of a scene takes
// the smallest one, and the stability look of the author (author/stability.h) reads all of them.
// Nothing in it fails: references to nothing are passed over.
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
