// What is wrong with panels that carry the pull of a fabric: shapes at rest that are none,
// materials without a law or with one that cannot be, and threads that carry the same pull beside
// them. A part of check.h.
#pragma once

#include "check/finding.h"
#include "scene/element_index.h"

#include <functional>

namespace ripstop {

//   add  takes a sort (check.h), how bad it is, what to say of it, and of what it is said
using AddFinding = std::function<void(const char*, Severity, Message, Id)>;

// Panels whose corners dangle are left to others.
void checkElasticPanels(const Scene& scene, const ElementIndex& index, const AddFinding& add);

} // namespace ripstop
