// How long a substep may be for what the air takes from fabric.
#pragma once

#include "system/system.h"

#include <vector>

namespace ripstop {

// The longest substep, s, that is sure to be stable for the fabric as it is in `state`; infinite
// without any. The load on a panel falls by c (N s/m) for each m/s that its mean moves along its
// normal. A corner has a third of the load and makes a third of the mean, so that the rate of
// damping at a particle of mass m is at most s = sum of c / (3 m) over its panels (Gershgorin), and
// explicit damping is stable for h s < 2.
//   rate  scratch
double airStepLimit(const System& system, const State& state, std::vector<double>& rate);

} // namespace ripstop
