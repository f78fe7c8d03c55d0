// What the scene says about the looks of the elements of a layout.
//
// A layout knows ids, ends and corners; colours, visibility, tear limits and strip widths belong to
// parts and materials of the scene. A Look is that, resolved into one array per quantity with an
// entry for each row of the layout. The stage makes it again when changesLook() says that an edit
// may show, or when the layout differs, and never per frame. Layers, picking and occlusion read it,
// in the thread of the window.
#pragma once

#include "laws/tear_limits.h"
#include "scene/edit.h"
#include "simulation/frame.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ripstop {

using Color = std::array<std::uint8_t, 3>; // red, green, blue, 0 .. 255

struct Look
{
    struct PaintedFactors // what an element has of its material
    {
        double stiffness = 1.0; // 1
        double strength = 1.0;  // 1
    };
    struct Warp // of a panel that carries the pull of the fabric
    {
        bool isThere = false;
        std::array<double, 2> shares{}; // derived/flat_panel.h
        double turn = 0.0;              // degrees, -90 to 90, from the way that the print goes up
    };

    std::vector<std::uint8_t> particleShown;  // [particles]
    std::vector<std::uint8_t> isWeight;       // [particles] free, and heavy for its part
    std::vector<std::uint8_t> linkShown;      // [links]
    std::vector<Color> linkColor;             // [links]
    std::vector<TearLimit> linkTear;          // [links]
    std::vector<double> linkWidth;            // [links] m, of the strip of fabric; 0 for none
    std::vector<std::uint8_t> panelShown;     // [panels]
    std::vector<Color> panelColor;            // [panels]
    std::vector<FabricTear> panelTear;        // [panels]
    std::vector<PaintedFactors> linkPainted;  // [links]
    std::vector<PaintedFactors> panelPainted; // [panels]
    std::vector<Warp> panelWarp;              // [panels]

    // [particles] places on the cloth, 1; empty when no particle has one.
    std::vector<std::array<float, 2>> texture;
};

// Elements of the layout that are no longer in the scene are not shown.
Look lookOf(const Scene& scene, const Layout& layout);

// True when the edit may change the look: a colour, a material, what is shown, what tears, the
// tables. Most edits change numbers of the physics and do not.
bool changesLook(const Edit& edit);

// Reads a colour such as "#c8553d"; a text that cannot be read gives grey.
Color colorFromText(const std::string& text);

} // namespace ripstop
