// The materials that the program knows, and how one of them is given to a material of a scene.
//
// A preset sets the physical numbers of a material (isPhysical()) and leaves its name, colour and
// air law alone; what it does not know gets its default. A material that tears by its strengths
// then does so by those of the preset. Where the material says what density its particles were
// given, they are weighed anew.
#pragma once

#include "base/result.h"
#include "materials/preset.h"
#include "scene/edit.h"

#include <span>
#include <string_view>
#include <vector>

namespace ripstop {

// The library that the program carries in itself: resources/materials.json.
std::span<const Preset> allPresets();
std::string_view presetFileText(); // that file

// The preset of this name, of the library or of `own`. The message names the nearest.
Result<const Preset*> findPreset(std::string_view name, std::span<const Preset> own = {});

// The preset that has given a material all its numbers, or null. It is one of `own` where both
// have.
const Preset* presetOf(const Material& material, std::span<const Preset> own = {});

// What a scene's material has of physical numbers, as a preset of its own. `source` is said of each
// of them, unless it is as `like` has it, which then says where it is from.
Preset presetFrom(const Material& material, PresetKind kind, std::string name, std::string source,
                  const Preset* like = nullptr);

// What a material with these numbers most likely is.
PresetKind likelyKind(const Material& material);

// Gives a material that is being made all numbers of the preset, densities included.
void give(Material& material, const Preset& preset);

struct PresetEdit
{
    Edit edit;
    std::vector<Id>
        notWeighed; // their particles keep their mass, as the old or new density is unknown
};

struct GivenPreset
{
    Id material;
    const Preset* preset;
};

// Gives each of these materials the numbers of its preset. The scene has no errors, and the
// materials are in it, each once.
Result<PresetEdit> presetEdit(const Scene& scene, const std::vector<GivenPreset>& given);

// Gives all of these materials the numbers of one preset.
Result<PresetEdit> presetEdit(const Scene& scene, const Preset& preset,
                              const std::vector<Id>& materials);

} // namespace ripstop
