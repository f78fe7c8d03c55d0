// Looks for colliders that fit between particles. These are what touches; links and panels do not,
// so that a line slips by a bar that is thinner than its links are long.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkGaps(const Scene& scene, const AddFinding& add);

} // namespace ripstop
