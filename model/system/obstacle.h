// What stops particles: the colliders of a scene, made ready to run.
//
// All shapes share one struct; the table of shapes (shapes/solid.h) says which of its numbers a
// shape uses. Grids and meshes are immutable and shared, between obstacles and between systems.
// Where an obstacle is at a time is told by contact/obstacle_motion.h, what it does by
// contact/contact.h.
#pragma once

#include "base/path_key.h"
#include "base/vec3.h"
#include "laws/contact_laws.h"
#include "shapes/solid.h"
#include "system/key.h"

#include <memory>
#include <vector>

namespace ripstop {

// A pointer to what an obstacle shares with others of the same shape. Two are equal when what they
// point at is equal.
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

// What the row of its shape in the table is asked about. It points into the obstacle, which must
// live as long.
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
