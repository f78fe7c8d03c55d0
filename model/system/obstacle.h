// What stops particles.
#pragma once

#include "base/contact_laws.h"
#include "base/path_key.h"
#include "base/vec3.h"
#include "shapes/solid.h"
#include "system/key.h"

#include <memory>
#include <vector>

namespace ripstop {

// What an obstacle shares with others of the same shape; equal when what it points at is.
template <typename T>
struct Shared : std::shared_ptr<const T>
{
    using std::shared_ptr<const T>::shared_ptr;
    Shared(std::shared_ptr<const T> other)
        : std::shared_ptr<const T>(std::move(other))
    {}

    friend bool operator==(const Shared& a, const Shared& b)
    {
        return a.get() == b.get() || (a.get() && b.get() && *a.get() == *b.get());
    }
};

// In its own frame a shape lies around the origin; a point p of that frame is at position + turn p.
// The shape says which numbers count (shapes/solid.h).
struct Obstacle
{
    ColliderShape shape;
    Vec3 position; // m
    Vec3 normal;   // unit
    double radius; // m, of spheres and cylinders
    Response response;
    double restitution;
    double friction;
    double thickness = 0.0;                             // m, added to the surface
    Vec3 size = Vec3::Ones();                           // m
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); // of shapes that use it
    std::vector<PathKey> path = {};                     // empty: stays at `position`
    Shared<HeightGrid> grid = {};                       // of a height field
    Shared<TriangleTree> mesh = {};                     // of a mesh
    double scale = 1.0;                                 // m per unit of the mesh
    Key key = 0;

    friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

// What its row in the table of shapes is asked about. It points into the obstacle.
inline Solid solidOf(const Obstacle& obstacle)
{
    return {.normal = obstacle.normal,
            .radius = obstacle.radius,
            .size = obstacle.size,
            .scale = obstacle.scale,
            .margin = obstacle.thickness,
            .grid = obstacle.grid.get(),
            .mesh = obstacle.mesh.get()};
}

} // namespace ripstop
