// Looks for corners of spars that turn as on a hinge where they look as if they were stiff: spars
// go on into each other only where they turn by little (laws/joined_spars.h).
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkHinges(const Scene& scene, const ElementIndex& index, const AddFinding& add);

} // namespace ripstop
