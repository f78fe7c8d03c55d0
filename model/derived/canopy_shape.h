// The shape of fabric that holds air: which panels make one canopy, which way each of them faces,
// and where its edges are.
//
// Panels that share an edge belong together. A piece is wound such that the cone from the middle of
// its mouth over the panels holds a positive volume where the run starts: normals point out of the
// air. The mouth is the edge with the most particles that links tie to something outside the
// piece, the longest of equal ones; other edges are vents.
#pragma once

#include "base/result.h"
#include "scene/items.h"

#include <array>
#include <vector>

namespace ripstop {

struct CanopyPiece
{
    struct Facet
    {
        int panel;                // row in Part::panels
        std::array<Id, 3> corner; // normal (b - a) x (c - a) points out of the air
        double area;              // m^2, of the cloth as it is cut (cloth_area.h)
    };
    std::vector<Facet> facets;          // in the order of the panels
    std::vector<Id> mouth;              // once around
    std::vector<std::vector<Id>> vents; // once around each, wound as the mouth is
};

// The message says what is wrong with the fabric of the part and what to do about it.
Result<std::vector<CanopyPiece>> canopyPieces(const Part& part);

} // namespace ripstop
