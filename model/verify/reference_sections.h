// The sections of comparisons with measured data (reference.h), and how designs are built and flown
// for them. Adding a section is a function here and its name in the list of allReferences().
#pragma once

#include "builders/builder.h"
#include "simulation/simulation.h"
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

// The number that stands for a choice of a parameter, by its name.
double choiceOf(std::string_view builder, std::string_view parameter, std::string_view choice);

// Mean of a probe of the design over the samples, 0.1 s apart, from one time to another, s. Not a
// number when it cannot be flown so far.
double meanProbe(Simulation& simulation, std::string_view probe, double from, double to);

} // namespace ripstop
