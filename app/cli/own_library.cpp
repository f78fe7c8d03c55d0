// A file that was named and is not there is told of; the usual one need not be there.
#include "cli/own_library.h"

#include <iostream>

namespace ripstop {

void addOwnMaterialsOption(CLI::App& command, const char* names, std::string& file)
{
    command
        .add_option(names, file,
                    "File of own materials; without it $XDG_DATA_HOME/ripstop/materials.json")
        ->type_name("FILE");
}

std::filesystem::path ownFileOf(const std::string& given)
{
    return given.empty() ? ownMaterialsFile() : std::filesystem::path(given);
}

std::vector<Preset> ownMaterials(const std::string& given)
{
    std::error_code ignored;
    if (!given.empty() && !std::filesystem::exists(given, ignored))
        std::cerr << "There is no file " << given << "; only built-in materials are known.\n";
    OwnMaterials own = readOwnMaterials(ownFileOf(given));
    if (own.problem)
        std::cerr << own.problem->message.english()
                  << (own.presets.empty() ? " Only built-in materials are known.\n" : "\n");
    return std::move(own.presets);
}

} // namespace ripstop
