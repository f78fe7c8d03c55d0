// What the scene says about the looks of the elements of a layout.
#pragma once

#include "run/frame.h"
#include "scene/edit.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ripstop {

using Color = std::array<std::uint8_t, 3>; // red, green, blue, 0 .. 255

// What a link tears at.
struct TearBound
{
    TearRule rule = TearRule::Never;
    double limit = 0.0; // m, 1 or N, as the rule says
};

struct Look
{
    std::vector<std::uint8_t> particleShown; // [particles]
    std::vector<std::uint8_t> isWeight;      // [particles] free, and heavy for its part
    std::vector<std::uint8_t> linkShown;     // [links]
    std::vector<Color> linkColor;            // [links]
    std::vector<TearBound> linkTear;         // [links]
    std::vector<double> linkWidth;           // [links] m, of the strip of fabric; 0 for none
    std::vector<std::uint8_t> panelShown;    // [panels]
    std::vector<Color> panelColor;           // [panels]

    // [particles] places on the cloth, 1; empty when no particle has one.
    std::vector<std::array<float, 2>> texture;
};

// Elements of the layout that are no longer in the scene are not shown.
Look lookOf(const Scene& scene, const Layout& layout);

// True when the edit may change the look: a colour, a material, what is shown, what tears, the
// tables. Most edits change numbers of the physics and do not.
bool changesLook(const Edit& edit);

// "#c8553d"; grey when it cannot be read.
Color colorFromText(const std::string& text);

} // namespace ripstop
