#pragma once

#include "system/system.h"

namespace ripstop {

// The motion of `state` under `from`, continued under `to`. Particles, links, panels, inputs
// and gusts are matched by key; what is torn stays torn. A new particle moves along with one that
// it is tied to, so that an edit does not jerk a running scene. `memory` is a state whose arrays
// are used again for the answer.
State carryOver(const System& from, const State& state, const System& to, State memory = {});

} // namespace ripstop
