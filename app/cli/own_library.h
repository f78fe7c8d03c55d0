// --materials FILE of commands that name presets: the user's own materials.
#pragma once

#include "cli/commands.h"
#include "materials/own_materials.h"

#include <string>

namespace ripstop {

// `names` as CLI11 has them: "--materials,--own-materials".
void addOwnMaterialsOption(CLI::App& command, const char* names, std::string& file);

// The file that was given, or the usual one.
std::filesystem::path ownFileOf(const std::string& given);

// Those of the file. One that cannot be read is told of on standard error, and has none.
std::vector<Preset> ownMaterials(const std::string& given);

} // namespace ripstop
