// What a collider is as a solid: its numbers, what its file makes, and what is wrong with it.
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

// The ground of a height field, whose size is sound, and the mesh of a mesh; the message is a whole
// sentence.
Result<std::shared_ptr<const HeightGrid>> gridOf(const Scene& scene, const Collider& collider,
                                                 Effort effort = Effort::Any);
Result<std::shared_ptr<const TriangleTree>> meshOf(const Scene& scene, const Collider& collider,
                                                   Effort effort = Effort::Any);

// What its shape needs beside its numbers. Without effort both may be null where one will come.
struct ShapeData
{
    std::shared_ptr<const HeightGrid> grid;   // of a height field
    std::shared_ptr<const TriangleTree> mesh; // of a mesh
};
Result<ShapeData> shapeDataOf(const Scene& scene, const Collider& collider,
                              Effort effort = Effort::Any);

// What its row in the table of shapes is asked about; it points into the data.
Solid solidOf(const Collider& collider, const ShapeData& data = {});

// How the file of the collider is named in a scene that lies in another folder. An absolute path
// stays as it is, and so does that of a file that is not there: it may be meant to come.
std::string fileSeenFrom(const std::filesystem::path& newFolder, const Scene& scene,
                         const Collider& collider);

// What keeps the collider from working, as a sentence, or nothing.
std::optional<Message> colliderError(const Scene& scene, const Collider& collider);

// The mean edge of all panels, m, 0 without any.
double meanPanelEdge(const Scene& scene);

// How wide it is where fabric must not slip by, m; infinite for what is wide by nature.
double widthOf(const Collider& collider);

// Particles touch, panels do not: what is smaller than the gaps between particles goes through.
std::optional<Message> colliderWarning(const Collider& collider, double panelEdge);

} // namespace ripstop
