// Looks for particles that weigh more than all links that end at them can bear together, by the
// force that these tear at (derived/tear_bounds.h): whichever way the links run and however the
// load is shared, m g is more than the sum of their strengths, so that the weight comes down.
//
// It is told only where nothing else can bear the weight: the particle is free, no panel and no
// control holds it, it does not lie on a collider, something is there that it can hang from, and
// no link can prop it from below.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkWeights(const Scene& scene, const ElementIndex& index, const AddFinding& add);

} // namespace ripstop
