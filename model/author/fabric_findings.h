// Before the first step: fabric that is carried twice, by nothing, or with its warps every way,
// each with the edit that repairs it (stability.h); and, as something worth telling, fabric that
// stays in a plane for ever.
#pragma once

#include "check/finding.h"

namespace ripstop {

std::vector<Finding> fabricFindings(const Scene& scene);

} // namespace ripstop
