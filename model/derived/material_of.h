// The material that an element names.
#pragma once

#include "scene/element_index.h"
#include "scene/scene.h"

namespace ripstop {

// Default numbers when there is none.
const Material& materialOf(const Scene& scene, const ElementIndex& index, Id id);

} // namespace ripstop
