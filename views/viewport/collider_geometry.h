// What a collider looks like, and where the view meets it.
#pragma once

#include "run/frame.h"
#include "scene/scene.h"

#include <Eigen/Geometry>

#include <vtkNew.h>
#include <vtkPolyData.h>

namespace ripstop {

// Where a collider is in a frame, m; where it starts when the frame does not know it.
Vec3 placeOf(const Frame& frame, Id id, const Collider& collider);

// Its surface in its own frame, with normals; nothing for a plane, or when its file fails.
vtkNew<vtkPolyData> surfaceOf(const Scene& scene, const Collider& collider);

// From its own frame to the scene, without its place.
Eigen::Matrix3d turnAndScale(const Collider& collider);

// Around it in its own frame, m; empty for a plane.
Eigen::AlignedBox3d boundsOf(const Scene& scene, const Collider& collider);

// The eight corners of that, in the scene.
std::vector<Vec3> cornersOf(const Scene& scene, const Collider& collider, const Vec3& place);

// How far along a ray (unit direction) the collider is met, m; infinite when it is not.
double distanceTo(const Scene& scene, const Collider& collider, const Vec3& place,
                  const Vec3& origin, const Vec3& direction);

} // namespace ripstop
