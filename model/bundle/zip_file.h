// Zip files of folders, by libzip. Failures say which file is at fault; both calls end early when
// the progress says so.
#pragma once

#include "base/progress.h"
#include "base/result.h"

#include <filesystem>
#include <optional>

namespace ripstop {

// All files of a folder, at any depth, under the name `top` in the zip. The target is the old file
// or the new one, whole. Times of files are left out: the same files give the same bytes.
std::optional<Failure> zipFolder(const std::filesystem::path& folder, const std::string& top,
                                 const std::filesystem::path& target, const Progress& progress);

// Unpacks into a folder that is there, checking each file. Names that lead out of it are refused.
std::optional<Failure> unzip(const std::filesystem::path& zip, const std::filesystem::path& folder,
                             const Progress& progress);

} // namespace ripstop
