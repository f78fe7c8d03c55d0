// The heights of a picture, 0 for black to 1 for white: grey PNG or PGM of 2 x 2 to 8192 x 8192
// points.
// It reads the file at each call. heightsFromFile() (shape_files.h), which keeps the result, is
// its only caller; the message of a failure names the file and what to do.
#pragma once

#include "base/result.h"
#include "shapes/height_grid.h"

#include <filesystem>

namespace ripstop {

Result<HeightGrid> readHeightPicture(const std::filesystem::path& file);

} // namespace ripstop
