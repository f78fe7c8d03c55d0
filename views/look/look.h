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

    struct Cloth // what of it is seen
    {
        // Of the three corners at rest: m along the weft and along the warp, from the first.
        std::array<std::array<float, 2>, 3> place{};
        float through = 0.0F; // 1, of the light that falls on its other side
        float grid = 0.0F;    // m between the threads of a ripstop; 0 for a plain weave
        bool isBuilt = false; // by a builder, whose borders are meant to be straight

        friend bool operator==(const Cloth&, const Cloth&) = default;
    };
    enum class Form : std::uint8_t { // what a link is seen as
        Wire,                        // of the mesh
        Round,                       // a line or a spar
        Sewn                         // a seam or a hem, where it lies on a side of a panel
    };

    std::vector<std::uint8_t> particleShown;  // [particles]
    std::vector<std::uint8_t> isWeight;       // [particles] free, and heavy for its part
    std::vector<std::uint8_t> isBridle;       // [particles] where lines meet (look/subject.h)
    std::vector<std::uint8_t> linkShown;      // [links]
    std::vector<Color> linkColor;             // [links]
    std::vector<Form> linkForm;               // [links]
    std::vector<double> linkThickness;        // [links] m, of what is round; 0 where unknown
    std::vector<TearLimit> linkTear;          // [links]
    std::vector<double> linkWidth;            // [links] m, of the strip of fabric; 0 for none
    std::vector<std::uint8_t> panelShown;     // [panels]
    std::vector<Color> panelColor;            // [panels]
    std::vector<FabricTear> panelTear;        // [panels]
    std::vector<PaintedFactors> linkPainted;  // [links]
    std::vector<PaintedFactors> panelPainted; // [panels]
    std::vector<Warp> panelWarp;              // [panels]
    std::vector<Cloth> panelCloth;            // [panels]

    struct Print // a picture on fabric
    {
        std::string file; // where it is
        Color ground{};   // below it, where it lets through
        std::vector<std::array<float, 2>>
            at; // [particles] in the picture, derived/fabric_picture.h
    };
    std::vector<Print> prints;
    std::vector<int> panelPrint; // [panels] index into prints; -1 for plain cloth
};

// Elements of the layout that are no longer in the scene are not shown.
Look lookOf(const Scene& scene, const Layout& layout);

// True when the edit may change the look: a colour, a material, what is shown, what tears, the
// tables. Most edits change numbers of the physics and do not.
bool changesLook(const Edit& edit);

// Reads a colour such as "#c8553d"; a text that cannot be read gives grey.
Color colorFromText(const std::string& text);

} // namespace ripstop
