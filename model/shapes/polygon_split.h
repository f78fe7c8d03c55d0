// Polygons as triangles, and points that lie on each other as one.
// Readers of meshes, the mesh repair and the drawing operations call these functions; they depend
// on their arguments alone. Lengths are in the unit of the points.
#pragma once

#include "base/vec3.h"

#include <array>
#include <span>
#include <vector>

namespace ripstop {

// [points] For each point the one before it that it is joined with, or its own index: the nearest
// within `tolerance` of those that stay, so that chains of points do not collapse.
std::vector<int> welded(const std::vector<Vec3>& points, double tolerance);

// Splits one polygon into triangles, point indices: a convex quad along its shorter diagonal,
// others by cutting ears (Meisters 1975), so that hollow ones keep their area, and points on their
// sides make no slivers.
void splitPolygon(std::span<const int> corners, const std::vector<Vec3>& points,
                  std::vector<std::array<int, 3>>& triangles);

// Twice the area vector of a polygon (Newell), in the square of the unit of the points.
Vec3 doubleArea(std::span<const int> corners, const std::vector<Vec3>& points);

// How far the corner that is farthest off lies from the plane of a polygon, which goes through the
// middle of its corners and across its area vector; in the unit of the points. A triangle and a
// polygon without area have none: 0.
double distanceFromPlane(std::span<const int> corners, const std::vector<Vec3>& points);

// Whether a quad has no hollow or straight corner, nor one that is straight but for a thousandth of
// its area, seen along its area vector.
bool isConvexQuad(std::span<const int> corners, const std::vector<Vec3>& points);

} // namespace ripstop
