// Files of meshes as polygons or as triangles. OBJ (obj_file.h), PLY and OFF (ply_file.h) are read
// here, all others by assimp in a process of its own (mesh_process.h).
// Both functions read the file at each call and may run on any thread; the message of a failure is
// a whole sentence that names the file. Files above 1 GiB are refused.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "shapes/polygon_mesh.h"
#include "shapes/triangle_tree.h"

#include <filesystem>

namespace ripstop {

// The triangles of a collider. meshFromFile() of shape_files.h keeps the result.
Result<TriangleTree> readMeshFile(const std::filesystem::path& file);

// A mesh as it is, to be brought in: polygons stay polygons, and nothing is joined or left out but
// single points, and lines within the faces. OBJ, STL, PLY, OFF, glTF, GLB, Collada, VTP, VTU and
// what else assimp reads. VTK's bring masses of points, and of lines those that go beyond the
// faces. glTF and Collada say their unit and which way is up: their points come in metres, with y
// up.
Result<PolygonMesh> readPolygonFile(const std::filesystem::path& file,
                                    const Progress& progress = {});

// "obj", "stl", ...: what a file dialog offers.
std::span<const std::string_view> meshExtensions();

} // namespace ripstop
