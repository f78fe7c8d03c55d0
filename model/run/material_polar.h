// The polar of a material of a scene, for those who know scenes and no systems: the window and
// whatever else shows what is authored. A calculation of its own, on any thread.
#pragma once

#include "measure/polar.h"
#include "scene/items.h"

namespace ripstop {

// As platePolar() has it, of what the material is compiled to; `step` in degrees.
std::vector<PolarRow> platePolar(const Material& material, double step);

} // namespace ripstop
