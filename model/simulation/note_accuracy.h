// Notes of each step of a run how true it was and how much of the motion it damped.
#pragma once

#include "simulation/recent_damping.h"
#include "simulation/run_accuracy.h"
#include "step/stepper.h"

#include <cstddef>

namespace ripstop {

// After the step of the stepper that led to `now` and in which so many things tore.
void noteAccuracy(const System& system, const Stepper& stepper, const State& now, std::size_t torn,
                  RecentDamping& damping, RunAccuracy& accuracy);

} // namespace ripstop
