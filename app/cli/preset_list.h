// What `ripstop-cli presets` prints of materials: lists, all that is known of one, and the page of
// the manual.
#pragma once

#include "materials/preset.h"

#include <span>

namespace ripstop {

void printPresets(std::span<const Preset> presets);      // a paragraph for each
void printPresetsJson(std::span<const Preset> presets);  // one object
void printPreset(const Preset& preset);                  // each number with standing and source
void printPresetManual(std::span<const Preset> presets); // Markdown

} // namespace ripstop
