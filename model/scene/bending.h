// What bending (base/bend.h) asks of the step in a scene that is not compiled.
#pragma once

#include "base/bend.h"
#include "scene/element_index.h"
#include "scene/scene.h"

namespace ripstop {

// N/m, at each particle, counted through all parts; empty when nothing bends stiffly. What points
// at nothing is passed over.
std::vector<double> bendSumsOf(const Scene& scene, const ElementIndex& index);

} // namespace ripstop
