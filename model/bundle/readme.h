// What a bundle tells a person: its README.md, and the command lines that make its files again.
#pragma once

#include "bundle/manifest.h"

namespace ripstop {

// The command lines that make the files of the bundle again, in its folder. The first flies it and
// compares.
std::vector<std::string> commandsOf(const Manifest& manifest, bool hasProbes, bool isSteered);

// Markdown; of what is in the folder.
std::string readmeText(const Manifest& manifest, const std::filesystem::path& folder);

} // namespace ripstop
