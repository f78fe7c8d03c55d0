// How lines part: of links between which nothing else is tied, and which so pull alike, one breaks.
#pragma once

#include "system/system.h"
#include "tearing/overload.h"

#include <vector>

namespace ripstop {

// s, in which a link that has let go loses its load: a pull crosses it in the root of mass times
// compliance; one that is damped gives way no sooner than its damping time lets it. A spring
// without stiffness never pulls itself together.
double easingTime(const System& system, const LinkPlace& link);

// Leaves of the links of each line only the worst, of equals the first; and none of a line that has
// parted elsewhere, for as long as a pull takes to run along what is left of it and back.
void leaveOneOfLines(const System& system, const State& state, std::vector<Overload>& overloads);

} // namespace ripstop
