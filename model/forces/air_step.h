// What the air takes from the motion of fabric: it bounds the substep, or joins the masses where
// all rods are solved together.
//
// The load on a panel falls by c (N s/m) for each m/s that its mean moves along its normal n. A
// corner has a third of the load and makes a third of the mean: the damping between two corners is
// c / 9 n n^T, and all of it is at most c / 3 n n^T at each corner alone (Gershgorin).
#pragma once

#include "forces/force.h"

namespace ripstop {

// Adds that at each particle that is a corner of a panel. It computes two loads for each panel.
void addAirDamping(const System& system, const State& state, Damping& damping);

} // namespace ripstop
