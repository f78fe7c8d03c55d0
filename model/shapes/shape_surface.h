// How a shape looks, and where a line of sight meets it: in the frame of the shape, for the view.
//
// A view draws the faces of a surface and asks these functions where a ray ends, so that it knows
// no shape by name. The engine needs neither.
#pragma once

#include "shapes/height_grid.h"
#include "shapes/triangle_tree.h"

#include <Eigen/Geometry>

#include <array>
#include <limits>
#include <vector>

namespace ripstop {

// Faces that one can draw. Without normals a view finds them by the angles between faces.
struct ShapeSurface
{
    std::vector<Vec3> points;              // m
    std::vector<Vec3> normals;             // [points], unit, or empty
    std::vector<std::array<int, 4>> faces; // counter-clockwise as seen from outside; the last
                                           // corner of a triangle is -1
};

// A panel that rests on a round surface with its corners dips into it with its middle; drawn a
// little smaller, the surface does not show through.
inline constexpr double drawnRadius = 0.965; // over the radius

ShapeSurface sphereSurface(double radius);
ShapeSurface boxSurface(const Vec3& half);
// The ground as fine as its grid, with at most 512 points along each side.
ShapeSurface groundSurface(const HeightGrid& grid, const Vec3& size);
ShapeSurface meshSurface(const TriangleTree& mesh);

// A line of sight.
struct ShapeRay
{
    Vec3 origin;    // m
    Vec3 direction; // of any length but 0, in which distances are given
};

inline constexpr double noHit = std::numeric_limits<double>::infinity();

// How far along the ray the shape is met; noHit when it is not.
double rayToSphere(double radius, const ShapeRay& ray);
double rayToBox(const Eigen::AlignedBox3d& box, const ShapeRay& ray);
double rayToGround(const HeightGrid& grid, const Vec3& size, const ShapeRay& ray);
double rayToMesh(const TriangleTree& mesh, const ShapeRay& ray);

} // namespace ripstop
