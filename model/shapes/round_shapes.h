// Boxes and spheres around the origin of their own frame, with a margin that rounds them.
//
// Outside, the distance to a box is |max(|p| - half, 0)|, and its direction is the normal of a
// face, an edge or a corner; inside it is the largest of |p| - half, towards the nearest face.
#pragma once

#include "shapes/nearest.h"
#include "shapes/touch.h"

#include <optional>

namespace ripstop {

Nearest nearestOnBox(const Vec3& half, const Vec3& point); // half the edges, m
Nearest nearestOnSphere(double radius, const Vec3& point);

// See touch.h. The radius of the sphere has the margin in it.
std::optional<Touch> touchBox(const Vec3& half, double margin, const Vec3& from, const Vec3& to);
std::optional<Touch> touchSphere(double radius, const Vec3& from, const Vec3& to);

} // namespace ripstop
