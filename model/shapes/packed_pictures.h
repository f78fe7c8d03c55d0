// Pictures that lie within the file of a mesh, as those of most .glb files do.
//
// A scene names the pictures on its fabric by their files, so each picture gets a name beside the
// mesh when that is read (mesh_file.h), and is written there when the mesh is imported. What is
// there already stays as it is: the same picture is not written twice, and another one makes the
// name go on with a number.
#pragma once

#include "base/result.h"
#include "shapes/polygon_mesh.h"

#include <filesystem>
#include <optional>

namespace ripstop {

// Gives each picture of the mesh its file, absolute. What is neither PNG nor JPEG, which is all
// that can be drawn on fabric, keeps an empty one.
void nameFilesBeside(const std::filesystem::path& meshFile,
                     std::vector<PolygonMesh::PackedPicture>& pictures);

// Writes the picture to its file; why it cannot be, or nothing.
std::optional<Failure> unpack(const PolygonMesh::PackedPicture& picture);

} // namespace ripstop
