// Looks for fabric that is there twice, and for cloth that is heavier than any, as grams typed for
// kilograms make it.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkFabric(const Scene& scene, const ElementIndex& index, const AddFinding& add);

} // namespace ripstop
