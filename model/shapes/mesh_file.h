#pragma once

#include "base/result.h"
#include "shapes/triangle_tree.h"

#include <filesystem>

namespace ripstop {

// See meshFromFile(), which remembers.
Result<TriangleTree> readMeshFile(const std::filesystem::path& file);

} // namespace ripstop
