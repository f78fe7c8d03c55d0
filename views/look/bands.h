// Bands on the fabric: seams and hems of their width, and borders that run straight along an edge.
//
// A mesh of triangles has borders like saws: those that stand on the edge have the colour of the
// border, those that touch it with a corner that of the sail. Of what a builder made, such a border
// is drawn as a strip of the same area along the edge, so that it weighs what it weighs. What is
// sewn is a strip beside its links. Each band is cut from the panels that it lies on, so that it
// folds with them, and stands in shares of their corners: a frame only has to mix these.
#pragma once

#include "look/fabric.h"
#include "look/look.h"

#include <vector>

namespace ripstop {

enum class BandKind { Border, Sewn }; // of one layer of cloth, and of several that lie above it

// A convex piece of a panel.
struct BandPiece
{
    int panel; // index
    Color color;
    BandKind kind;
    std::vector<std::array<float, 3>> corners; // shares of the corners of the panel, 1
};

struct Bands
{
    std::vector<Color> panelColor; // [panels] below the bands
    std::vector<BandPiece> pieces; // of panels that are there, the upper ones last
};

//     panels  [panels]     facing alike
//     points  [panels][3]  of their corners on the cloth
Bands bandsOf(std::span<const Corners> panels, std::span<const std::array<ClothPoint, 3>> points,
              const Layout& layout, const Look& look);

} // namespace ripstop
