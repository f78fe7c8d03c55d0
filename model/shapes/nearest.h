#pragma once

#include "base/vec3.h"

namespace ripstop {

// What a solid shape says of a point.
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
