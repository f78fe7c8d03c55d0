// The sections of comparisons, and how designs are flown for them.
#pragma once

#include "builders/builder.h"
#include "run/simulation.h"
#include "verify/reference.h"

#include <memory>
#include <string_view>

namespace ripstop {

std::vector<Reference> parachuteReferences();
std::vector<Reference> kiteReferences();
std::vector<Reference> gliderReferences();
std::vector<Reference> shapeReferences();

// A design of a shipped builder at the start of its run; null when the values are out of its range.
std::unique_ptr<Simulation> design(std::string_view builder, const Parameters& given);

// Mean of a probe of the design over the samples, 0.1 s apart, from one time to another, s. Not a
// number when it cannot be flown so far.
double meanProbe(Simulation& simulation, std::string_view probe, double from, double to);

} // namespace ripstop
