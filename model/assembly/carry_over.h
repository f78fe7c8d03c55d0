// The motion of a run, continued in another system.
//
// A run goes on through edits, tears and cuts: each makes another System, with other arrays, and
// what the State of the old one says is found again by keys. What is of the run as a whole, such as
// time, hands and work, goes over as it is. It cannot fail: what the new system has no place for is
// dropped, and what is new begins as the start of the new system says.
//
// DerivedSystem (simulation/derived_system.h) calls it on the thread that steps, between steps.
#pragma once

#include "system/system.h"

namespace ripstop {

// The motion of `state` under `from`, continued under `to`. Particles, links, panels, inputs and
// gusts are matched by key, canopies by their part and piece; what is torn stays torn. A new
// particle moves along with one that it is tied to, so that an edit does not jerk a running scene.
// `memory` is a state whose arrays are used again for the answer.
State carryOver(const System& from, const State& state, const System& to, State memory = {});

} // namespace ripstop
