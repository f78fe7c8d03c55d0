// Looks for particles that begin inside a collider. Contact puts them outside in the first step,
// which stretches what they are tied to by as much: energy out of nothing, in which a design
// breaks, flies off or diverges.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

// One warning for each part and collider. What cannot move, contact leaves where it is.
void checkStart(const Scene& scene, const AddFinding& add);

} // namespace ripstop
