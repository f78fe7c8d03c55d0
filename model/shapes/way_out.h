// What contact does with a point that begins inside a shape: it puts the point on the nearest
// surface at once, however deep that is, and what the point is tied to is stretched as far. The
// check of a scene and the watchdog of a run ask here.
#pragma once

#include "shapes/solid.h"

#include <optional>

namespace ripstop {

// Where a point inside the shape and its margin is put, in the frame of the shape. Nothing for one
// that is outside, or no deeper than what lies on a surface may be by rounding.
std::optional<Touch> wayOut(ColliderShape shape, const Solid& solid, const Vec3& point);

} // namespace ripstop
