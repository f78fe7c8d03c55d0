// The size of a picture in a file, PNG or JPEG, and whether all of it is there.
//
// What draws pictures shows one that is cut off or damaged in part, or not at all, without a word;
// so whoever names a picture asks first. Files of more than 256 MiB and pictures of more than 64
// million pixels are refused. The whole file is read; pictureSize() (shape_files.h) does so once.
#pragma once

#include "base/result.h"

#include <filesystem>

namespace ripstop {

struct PictureSize
{
    int width; // pixels
    int height;
};

// The message names the file and what to do.
Result<PictureSize> readPictureSize(const std::filesystem::path& file);

} // namespace ripstop
