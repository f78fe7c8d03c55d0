// Shapes that take time to make: hills, and what is read from pictures and meshes; and the sizes of
// pictures that are drawn on fabric.
//
// The same file with the same date is read once while somebody uses it, so that an edit of a
// collider that has a large mesh costs nothing. Any thread may call these. One that must not wait
// asks without effort: it gets null for what would have to be read or made first.
#pragma once

#include "base/result.h"
#include "shapes/height_grid.h"
#include "shapes/picture_file.h"
#include "shapes/triangle_tree.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace ripstop {

enum class Effort { Any, None };

// The place of a file that a scene names, which is seen from the folder of the scene.
std::filesystem::path placeOfFile(std::string_view folder, std::string_view file);

// Grey PNG of 8 or 16 bits (others are turned into grey) or PGM; black is 0 and white is 1, and
// the top of the picture is at the lowest z. The message names the file and what to do.
Result<std::shared_ptr<const HeightGrid>> heightsFromFile(const std::filesystem::path& file,
                                                          Effort effort = Effort::Any);

// The triangles of a mesh file in any format of mesh_file.h, all its meshes together. The message
// names the file and what to do.
Result<std::shared_ptr<const TriangleTree>> meshFromFile(const std::filesystem::path& file,
                                                         Effort effort = Effort::Any);

// Of a picture that is to be drawn, PNG or JPEG, when all of it is there (picture_file.h).
Result<PictureSize> pictureSize(const std::filesystem::path& file);

// Generated hills (height_grid.h); null only without effort.
std::shared_ptr<const HeightGrid> hills(int grid, std::uint32_t seed, double length,
                                        Effort effort = Effort::Any);

} // namespace ripstop
