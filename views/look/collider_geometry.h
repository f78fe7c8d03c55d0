// What a collider looks like, and where the view meets it.
//
// A body is made once for the shape of a collider and keeps its VTK surface; place, turn and scale
// are applied by whoever draws it or asks it. Layers draw the surfaces; camera, occlusion and
// picking ask for extremes, corners and rays. The shapes themselves are rows of a table in the
// model (shapes/): nothing here asks which shape it is. All of it runs in the thread of the window.
#pragma once

#include "scene/scene.h"
#include "shapes/solid.h"
#include "simulation/frame.h"

#include <Eigen/Geometry>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <memory>

namespace ripstop {

// What the numbers and the file of a collider make, in its own frame. It is kept from picture to
// picture: a mesh is not made into a surface again because something was selected. Files are read
// and hills are made by the engine and the check, on their threads; until one of them has, the body
// is late and has the shape of before, if any.
struct ColliderBody
{
    Id id{};
    Collider collider;                        // what the body was made of
    std::shared_ptr<const HeightGrid> grid;   // of a height field; null when it is flawed
    std::shared_ptr<const TriangleTree> mesh; // of a mesh; null when it is flawed
    bool isLate = false;
    Eigen::AlignedBox3d bounds;           // m; empty for a plane
    vtkSmartPointer<vtkPolyData> surface; // with normals; null for a plane or a failed file
};

// The bodies of all colliders of the scene, in its order. Those of `before` that are still right
// keep their surface.
std::vector<ColliderBody> bodiesOf(const Scene& scene, std::vector<ColliderBody> before);

// Where a collider is in a frame, m; where it starts when the frame does not know it.
Vec3 placeOf(const Frame& frame, Id id, const Collider& collider);

// From the frame of the collider to the scene: its turn and scale, without its place.
Eigen::Matrix3d turnAndScale(const Collider& collider);

// True for a landscape, which the camera does not step back from to have all of it in sight.
bool isGround(const ColliderBody& body);

// Points in the scene that are in sight when all of it is; none for a plane.
std::vector<Vec3> extremesOf(const ColliderBody& body, const Vec3& place);

// The eight corners of its bounds, in the scene; none for a plane.
std::vector<Vec3> cornersOf(const ColliderBody& body, const Vec3& place);

// The height of the ground at the place of something over it, m: of planes and landscapes, the
// highest that does not lie far above it. Minus infinity where there is none.
double groundBelow(const std::vector<ColliderBody>& bodies, const Frame& frame, const Vec3& place);

// How far along a ray (unit direction) the collider is met, m; infinite when it is not.
double distanceTo(const ColliderBody& body, const Vec3& place, const Vec3& origin,
                  const Vec3& direction);

} // namespace ripstop
