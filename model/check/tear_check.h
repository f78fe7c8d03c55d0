// Looks for links that their material means to tear and that cannot, as its rule says nothing of
// them (tear_bounds.h). Of panels, elastic_check.h tells the same.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkTearing(const Scene& scene, const AddFinding& add);

} // namespace ripstop
