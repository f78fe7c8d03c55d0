// Where the materials of the library lie along a number of a material: the marks of a slider, so
// that E t is turned from one named cloth to the next.
//
// A number of fabrics has marks of fabrics and films, one of lines those of lines, one of spars
// those of spars. Materials that share a value share its mark.
#pragma once

#include "materials/preset.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ripstop {

struct LibraryMark
{
    double value;                       // SI
    std::vector<const Preset*> presets; // that have it, in the order of the library
};

// The numbers by which cloth, line and spar are bought and tuned, in the order in which sliders
// show them: E t, G t, EA, EI and the strengths.
std::span<const Property* const> tradeNumbers();
bool isTradeNumber(const Property& property);

// What the material most likely is made like: the kind of the preset that it has, or likelyKind().
PresetKind presetKindOf(const Material& material, std::span<const Preset> own = {});

bool isOfOneFamily(PresetKind a, PresetKind b); // fabrics and films are one

// Ascending by value; none for a property that is no trade number.
std::vector<LibraryMark> marksOf(const Property& property, const Material& material,
                                 std::span<const Preset> own = {});

// The range of a slider in which the marks around the value can be told apart: a quarter of it to
// four times it, in decades.
SliderRange rangeAmongMarks(double value);

std::string_view shortLabelOf(const Preset& preset);

} // namespace ripstop
