// What a solid shape answers to a point that was at one place and is at another.
//
// Each shape has a function touch...(its numbers, margin, from, to), in a frame of its own around
// the origin, in metres. The margin is added to the surface and rounds edges. A point that went
// through the shape or ended deep in it is returned to the side that it came from, so that a thin
// shape holds however fast the point is. The table of shapes (solid.h) calls them.
#pragma once

#include "base/vec3.h"

namespace ripstop {

// Where the point goes; no Touch when it touches nothing on the way. The surface is the plane
// through `surface` with this normal.
struct Touch
{
    Vec3 surface; // m
    Vec3 normal;  // unit, outwards
};

// A point that rests on a surface is off it by what round-off does, over the size of the shape.
inline constexpr double onSurface = 1e-9;

// A point that went into a round surface belongs to the nearest place on it when it touches
// lightly: when the cosine of the angle between there and where it came in is at least this.
inline constexpr double lightly = 0.995;

// A touch on the plane through `onIt`, at the foot of the point.
inline Touch touchOnPlane(const Vec3& point, const Vec3& onIt, const Vec3& normal)
{
    return {point - (point - onIt).dot(normal) * normal, normal};
}

} // namespace ripstop
