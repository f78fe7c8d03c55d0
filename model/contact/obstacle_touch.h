// What a particle touches of an obstacle on its way.
#pragma once

#include "contact/obstacle_motion.h"
#include "shapes/touch.h"

#include <optional>

namespace ripstop {

struct Passage // of a particle past an obstacle, as seen from the obstacle
{
    Vec3 from; // m, at the start of the substep
    Vec3 to;
};

// The surface that it touches, in the frame of the scene. `inside` also looks for a particle that
// was deep inside a closed mesh before.
std::optional<Touch> touched(const Obstacle& obstacle, const PlacedObstacle& placed,
                             const Passage& passage, bool inside);

// The same for a particle that comes nearer than `reach`, m, or touches.
std::optional<Touch> surfaceNear(const Obstacle& obstacle, const PlacedObstacle& placed,
                                 const Passage& passage, double reach);

} // namespace ripstop
