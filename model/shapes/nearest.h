// The nearest place of a solid shape to a point, as a signed distance and a direction. Boxes,
// spheres (round_shapes.h) and cylinders (cylinder.h) answer with it.
#pragma once

#include "base/vec3.h"

namespace ripstop {

struct Nearest
{
    double distance; // m, negative inside
    Vec3 normal;     // unit, the direction in which the distance grows

    // The place at `margin` above the surface, m.
    Vec3 moved(const Vec3& point, double margin) const
    {
        return point + (margin - distance) * normal;
    }
};

} // namespace ripstop
