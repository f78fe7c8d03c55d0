// A missing file is an empty one. Whatever is written is read before by the reader of the format,
// so that no file is made that could not be read again.
#include "materials/own_materials.h"

#include "base/new_file.h"
#include "materials/material_file.h"
#include "materials/presets.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

std::string reason() { return errno != 0 ? std::strerror(errno) : "unknown error"; }

// The text of the file, empty where there is none.
Result<std::string> contentOf(const fs::path& file)
{
    std::error_code ignored;
    if (file.empty() || !fs::exists(file, ignored))
        return std::string();
    if (!fs::is_regular_file(file, ignored))
        return Failure("%1 is no file: materials cannot be read from it.", file.string());
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (!in || (in.peek() != std::ifstream::traits_type::eof() && !(text << in.rdbuf())))
        return Failure("%1 cannot be read: %2.", file.string(), reason());
    return text.str();
}

bool isBuiltIn(const std::string& name)
{
    return std::ranges::find(allPresets(), name, &Preset::name) != allPresets().end();
}

std::optional<Failure> write(const fs::path& file, const std::string& text)
{
    std::error_code ignored; // opening says it
    fs::create_directories(file.parent_path(), ignored);
    Result<NewFile> made = NewFile::open(file);
    if (!made)
        return made.failure();
    made->out() << text;
    return made->commit();
}

} // namespace

fs::path ownMaterialsFile()
{
    const char* data = std::getenv("XDG_DATA_HOME");
    if (data && fs::path(data).is_absolute())
        return fs::path(data) / "ripstop" / "materials.json";
    const char* home = std::getenv("HOME");
    return home && *home ? fs::path(home) / ".local" / "share" / "ripstop" / "materials.json"
                         : fs::path();
}

OwnMaterials readOwnMaterials(const fs::path& file)
{
    const Result<std::string> text = contentOf(file);
    if (!text)
        return {{}, text.failure()};
    if (text->empty())
        return {};
    Result<std::vector<Preset>> presets = readMaterials(*text, file.string());
    if (!presets)
        return {{}, presets.failure()};
    OwnMaterials own{std::move(*presets), std::nullopt};
    for (Preset& preset : own.presets) {
        preset.own = true;
        if (isBuiltIn(preset.name))
            own.problem = Failure("%1, material %2: A material of that name comes with Ripstop; "
                                  "give yours another one.",
                                  file.string(), preset.name);
    }
    std::erase_if(own.presets, [](const Preset& preset) { return isBuiltIn(preset.name); });
    return own;
}

std::optional<Failure> saveOwnMaterial(const fs::path& file, const Preset& preset,
                                       SameName sameName)
{
    if (file.empty())
        return Failure("There is no place for own materials: set XDG_DATA_HOME or HOME, or name a "
                       "file.");
    if (preset.name.empty())
        return Failure("The material needs a name.");
    if (isBuiltIn(preset.name))
        return Failure("A material called %1 comes with Ripstop; choose another name.",
                       preset.name);
    if (preset.values.empty())
        return Failure("The material has no number that could be kept.");
    if (const auto why = implausible(preset))
        return Failure("%1 is not saved: %2.", preset.name, *why);
    const Result<std::string> text = contentOf(file);
    if (!text)
        return text.failure();
    if (!text->empty()) {
        const Result<std::vector<Preset>> there = readMaterials(*text, file.string());
        if (!there)
            return Failure("%1 is not saved, to lose nothing of a file that cannot be read. %2",
                           preset.name, there.message());
        if (sameName == SameName::Refused
            && std::ranges::find(*there, preset.name, &Preset::name) != there->end())
            return Failure("There is an own material called %1 already; choose another name, or "
                           "have it replaced.",
                           preset.name);
    }
    return write(file, withMaterial(*text, preset));
}

std::string materialNameOf(std::string_view label)
{
    std::string name;
    for (const char c : label) {
        const bool upper = c >= 'A' && c <= 'Z';
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (upper || plain)
            name += upper ? char(c - 'A' + 'a') : c;
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    while (!name.empty() && name.back() == '_')
        name.pop_back();
    return name;
}

} // namespace ripstop
