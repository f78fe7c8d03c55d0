// The design that a file holds: a scene, or the one that the run of a recording began with.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <filesystem>

namespace ripstop {

Result<Scene> readDesign(const std::filesystem::path& file);

} // namespace ripstop
