// Materials that one can buy, with where their numbers come from.
//
// A preset sets the physical numbers of a material and leaves its name, colour, air law and damping
// alone; what another preset would have set and this one does not know gets its default. Where the
// material says what density its particles were given, they are weighed anew.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

enum class PresetKind { Fabric, Line, Spar };
std::string_view presetKindName(PresetKind kind); // "fabric", "line", "spar"

struct Preset
{
    PresetKind kind;
    std::string name;   // "skytex_27", what the command line takes
    std::string label;  // on screen
    std::string source; // who says so, and what of it is derived or assumed
    // Keys of material properties and their values, SI.
    std::vector<std::pair<std::string_view, Value>> values;
};

std::span<const Preset> allPresets();
Result<const Preset*> findPreset(std::string_view name); // the message names the nearest

// The preset that has given a material all its numbers, or null.
const Preset* presetOf(const Material& material);

// Gives a material that is being made all numbers of the preset, densities included.
void give(Material& material, const Preset& preset);

struct PresetEdit
{
    Edit edit;
    std::vector<Id>
        notWeighed; // their particles keep their mass, as the old or new density is unknown
};

// Gives these materials the preset's numbers. The scene has no errors, and `materials` are in it.
Result<PresetEdit> presetEdit(const Scene& scene, const Preset& preset,
                              const std::vector<Id>& materials);

} // namespace ripstop
