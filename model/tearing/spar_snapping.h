// Spars that snap where they are bent too far (Bend::breaking).
//
// A tube that has broken hinges on nothing, so that its pieces part: of the two links at the bend
// the one breaks along which the moment is larger, told by the bend at its other end, and of two
// alike the first; what is clamped is not the spar. Panels beside it stay, as a spar in the pocket
// of a sail takes no fabric along.
#pragma once

#include "system/system.h"

namespace ripstop {

// How many times its breaking moment a spar bears at a bend; 0 where it has none or has snapped.
double snapRatio(const System& system, const State& state, const Bend& spar);

// Breaks the link and notes the event; false where one of the two has gone already.
bool snap(const System& system, State& state, const Bend& spar);

} // namespace ripstop
