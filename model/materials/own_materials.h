// The user's own materials: a file of the same format as the library (material_file.h), from which
// every scene can take.
//
// It stands in $XDG_DATA_HOME/ripstop/materials.json, which is ~/.local/share/ripstop unless told
// otherwise. A file that cannot be read is left as it is: its materials are missing, the failure
// says why, and nothing is written into it until it can be read again.
#pragma once

#include "base/result.h"
#include "materials/preset.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace ripstop {

std::filesystem::path ownMaterialsFile(); // empty where there is neither the variable nor a home

struct OwnMaterials
{
    std::vector<Preset> presets;    // none where there is no file, or a bad one
    std::optional<Failure> problem; // why it could not be read, or which material is left out
};
OwnMaterials readOwnMaterials(const std::filesystem::path& file);

enum class SameName { Refused, Replaced };

// Adds a material to the file, which is made with its folder where there is none. The new file
// takes the place of the old one when it is whole.
std::optional<Failure> saveOwnMaterial(const std::filesystem::path& file, const Preset& preset,
                                       SameName sameName);

// What commands can take as a name: "Spinnaker cloth, 60 g" becomes "spinnaker_cloth_60_g".
std::string materialNameOf(std::string_view label);

} // namespace ripstop
