// Has the links along a mesh of panels stand for strips of fabric, as an import would have made
// them (mesh_network.h): what was drawn or built as bare links gets E t and G t of its material.
//
// A side of a panel becomes a thread. It stands for the area of the panels beside it, all of a
// triangle's and half of a cell's. Two panels whose four corners are tied both ways are such a
// cell: both ties are biases, of biasWidth() of its mean sides. A link between the corners opposite
// to a side of two triangles is a bias of 8/3 (A + A') / D. Widths are areas over lengths, as the
// cloth was cut (cloth_area.h): in folds it is no narrower.
//
// Links that have a width already, that lie along no panel, or that are of another material, such
// as spars in a pocket, stay as they are.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

#include <vector>

namespace ripstop {

struct StripWidths
{
    Edit edit;
    std::size_t threads = 0;
    std::size_t biases = 0;
};

// Fails, with a sentence that says why, where no link of these materials gets a width.
Result<StripWidths> widthsFromMesh(const Scene& scene, const std::vector<Id>& materials);

} // namespace ripstop
