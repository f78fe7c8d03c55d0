// Boxes and spheres around the origin of their own frame, with a margin that rounds them.
//
// Outside, the distance to a box is |max(|p| - half, 0)|, and its direction is the normal of a
// face, an edge or a corner; inside it is the largest of |p| - half, towards the nearest face.
#pragma once

#include "shapes/nearest.h"

#include <optional>

namespace ripstop {

Nearest nearestOnBox(const Vec3& half, const Vec3& point); // half the edges, m
Nearest nearestOnSphere(double radius, const Vec3& point);

// Where a point goes that was at `from` and is at `to`, or nothing when it touches nothing on the
// way: the surface is the plane through `surface` with this normal. A point that went through the
// shape or ended deep in it is returned to the side that it came from, so that a thin shape holds
// however fast the point is.
struct Touch
{
    Vec3 surface; // m
    Vec3 normal;  // unit, outwards
};
std::optional<Touch> touchBox(const Vec3& half, double margin, const Vec3& from, const Vec3& to);
std::optional<Touch> touchSphere(double radius, const Vec3& from, const Vec3& to);

} // namespace ripstop
