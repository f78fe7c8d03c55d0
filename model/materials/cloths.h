// Cloth: which materials of a scene are cloth, and all cloths of the library, to fly one design
// with each of them.
#pragma once

#include "materials/presets.h"

#include <vector>

namespace ripstop {

// Materials that panels are made of, or links that stand for strips of fabric with a width; in the
// order of the scene. A line or a spar is none.
std::vector<Id> clothMaterials(const Scene& scene);

std::vector<const Preset*> clothPresets(); // fabrics and films of the library, in its order

} // namespace ripstop
