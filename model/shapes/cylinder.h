// A solid cylinder around the origin of its own frame, its axis along y, with a margin that rounds
// its rims.
//
// With r the distance from the axis, the distance to it is |max((r - radius, |y| - half), 0)|
// outside, and its direction is the normal of the side, of a cap or of a rim, which rounds like a
// ring; inside it is the larger of the two, towards side or cap, whichever is nearer.
#pragma once

#include "shapes/nearest.h"
#include "shapes/shape_surface.h"
#include "shapes/touch.h"

#include <optional>

namespace ripstop {

// Radius and half the height, m.
struct Cylinder
{
    double radius;
    double half;
};

Nearest nearestOnCylinder(const Cylinder& cylinder, const Vec3& point);

// See touch.h. The way is that through the shape with its margin: who crosses a thick rim at any
// speed is held by the side or the cap behind it.
std::optional<Touch> touchCylinder(const Cylinder& cylinder, double margin, const Vec3& from,
                                   const Vec3& to);

// See shape_surface.h.
double rayToCylinder(const Cylinder& cylinder, const ShapeRay& ray);
ShapeSurface cylinderSurface(const Cylinder& cylinder);

} // namespace ripstop
