// The place of a triangle that is nearest to a point, in shares of its corners. Contact of fabric
// with fabric and the tree of a mesh use it; lengths are in the unit of the caller.
#pragma once

#include "base/vec3.h"

#include <array>

namespace ripstop {

using Corners = std::array<Vec3, 3>; // of a triangle

// Shares of the corners in the place of the triangle that is nearest to a point; those that have
// none are exactly zero, so they tell whether that place is a corner, on an edge or within
// (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Vec3 nearestShares(const Corners& corner, const Vec3& point);

inline Vec3 atShares(const Corners& corner, const Vec3& share)
{
    return share[0] * corner[0] + share[1] * corner[1] + share[2] * corner[2];
}

} // namespace ripstop
