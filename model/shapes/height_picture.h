#pragma once

#include "base/result.h"
#include "shapes/height_grid.h"

#include <filesystem>

namespace ripstop {

// See heightsFromFile(), which remembers.
Result<HeightGrid> readHeightPicture(const std::filesystem::path& file);

} // namespace ripstop
