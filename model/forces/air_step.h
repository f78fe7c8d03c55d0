// How fast the air takes motion from fabric, which bounds the substep.
//
// The load on a panel falls by c (N s/m) for each m/s that its mean moves along its normal. A
// corner has a third of the load and makes a third of the mean, so that the rate of damping at a
// particle of mass m is at most the sum of c / (3 m) over its panels (Gershgorin).
#pragma once

#include "system/system.h"

#include <span>

namespace ripstop {

// Adds the rate of each particle that is a corner of a panel. It computes two loads for each panel,
// and is meant for the choice of substeps and not for each of them.
//   rate  [particles]  1/s, added to
void addAirDampingRates(const System& system, const State& state, std::span<double> rate);

} // namespace ripstop
