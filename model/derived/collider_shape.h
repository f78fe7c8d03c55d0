// What a collider is as a solid: its numbers as the table of shapes takes them (shapes/solid.h),
// the ground or mesh that its file makes, and what is wrong with it.
// Lengths are in m, angles of a turn in degrees. Files are read through the cache of
// shapes/shape_files.h; `Effort` says whether a caller may wait for one that is not read yet.
// Compiling, the check, the scene writer and the views ask here, so that all of them mean the same
// solid.
#pragma once

#include "scene/scene.h"
#include "shapes/shape_files.h"
#include "shapes/solid.h"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace ripstop {

// Frame of a collider to that of the scene: turned about x, then y, then z, as Blender's XYZ.
Eigen::Matrix3d turnOf(const Collider& collider);

// The ground of a height field, whose size must be sound, and the triangles of a mesh. The message
// of a failure is a whole sentence.
Result<std::shared_ptr<const HeightGrid>> gridOf(const Scene& scene, const Collider& collider,
                                                 Effort effort = Effort::Any);
Result<std::shared_ptr<const TriangleTree>> meshOf(const Scene& scene, const Collider& collider,
                                                   Effort effort = Effort::Any);

// What a shape needs beside its numbers. Without effort both may be null where one will come.
struct ShapeData
{
    std::shared_ptr<const HeightGrid> grid;   // of a height field
    std::shared_ptr<const TriangleTree> mesh; // of a mesh
};
Result<ShapeData> shapeDataOf(const Scene& scene, const Collider& collider,
                              Effort effort = Effort::Any);

// The collider as its row in the table of shapes takes it; it points into `data`, which must
// outlive it.
Solid solidOf(const Collider& collider, const ShapeData& data = {});

// What keeps the collider from working, as a sentence, or nothing.
std::optional<Message> colliderError(const Scene& scene, const Collider& collider);

// Width of the collider where fabric must not slip by, m; infinite for a shape without end.
double widthOf(const Collider& collider);

// Whether a place is less than `within`, m, above a plane, or off the box around another shape,
// so that what is there may lie on it. So it is where the shape has no box yet.
bool mayLieOn(const Scene& scene, const Collider& collider, const Vec3& place, double within);

} // namespace ripstop
