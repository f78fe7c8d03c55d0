// Files of materials: JSON, "format": "ripstop-materials", "version": 1. The library of the program
// and the user's own materials are such files; docs/materials.md says what is in them.
//
// A file is read whole or not at all: the failure names the file, the material, the number and what
// to do. Each number has a unit, a source and a standing, and what no cloth can have (preset.h) is
// refused.
#pragma once

#include "base/result.h"
#include "materials/preset.h"

#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// `name` is what messages call the text.
Result<std::vector<Preset>> readMaterials(std::string_view text, std::string_view name);

// A file with these materials, in SI units.
std::string materialsText(const std::vector<Preset>& presets);

// The text of a file with this material besides, in the place of one of the same name if there is
// one. What else is in the text stays, also what this version does not know. `text` is one that
// readMaterials() takes, or empty.
std::string withMaterial(std::string_view text, const Preset& preset);

} // namespace ripstop
