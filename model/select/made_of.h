// What the selected things are made of.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace ripstop {

// The materials of a selection, in the order of the scene: those that are selected themselves, and
// those of the links and panels that the selection means (elements.h). Particles have none.
std::vector<Id> materialsOf(const Scene& scene, const std::vector<Id>& selected);

} // namespace ripstop
