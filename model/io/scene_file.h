// The scene file: JSON, *.ripstop.json, "format": "ripstop-scene", "version": 1.
//
// One element per line, values that equal their default left out, ids explicit, SI units. Keys
// that this version does not know are kept and written back. A scene is read whole or not at all.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace ripstop {

inline constexpr std::string_view sceneExtension = ".ripstop.json";

// The message names file, line, path inside the file ("parts[0].links[3].from") and what to do.
Result<Scene> readScene(const std::filesystem::path& file);
Result<Scene> parseScene(std::string_view text, std::string_view fileName);

std::string sceneText(const Scene& scene);

// For a file in `folder`: what the scene names beside itself (pictures, meshes) is named from
// there.
std::string sceneText(const Scene& scene, const std::filesystem::path& folder);

// Through a temporary file and rename: a crash while saving leaves the old file whole.
// Returns the failure, or nothing.
std::optional<Failure> saveScene(const Scene& scene, const std::filesystem::path& file);

} // namespace ripstop
