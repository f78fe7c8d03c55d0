// Fabric whose panels were all given one grain, as a person does who types an angle for all of
// them, although it is counted from a side of each (flat_panel.h): on a mesh of uneven triangles
// its warps point every way.
//
// A part is told where all its panels have the same grain to the last bit, its cloth is not the
// same in all directions, and the warps lie more than a few degrees apart. Imported, painted and
// mapped panels have grains of their own.
#pragma once

#include "scene/edit.h"

#include <vector>

namespace ripstop {

struct ScatteredWarps
{
    Id part;
    double grain = 0.0; // degrees, of all panels
    double apart = 0.0; // degrees, of the two warps that lie farthest apart, at most 90
};

std::vector<ScatteredWarps> scatteredWarps(const Scene& scene);

// Has all warps of these parts run at their one angle from the way in which the picture on the
// fabric goes up.
Edit turnedOneWay(const Scene& scene, const std::vector<ScatteredWarps>& parts);

} // namespace ripstop
