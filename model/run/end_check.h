// What a run must not end in: numbers that its steps survived and that no fabric can have. The
// watchdog (step/watchdog.h) stops a run for what is not finite or too fast; this looks at the end.
#pragma once

#include "base/message.h"

#include <vector>

namespace ripstop {

class Simulation;

// Natural rubber breaks at a strain of 7 to 10, and nothing stretches
// farther. Beyond that a link was pulled out of its place, by a sphere that encloses it for
// example.
inline constexpr double absurdStrain = 10.0; // 1

// Weight is the same everywhere here, which holds for small parts of the radius of the earth.
inline constexpr double absurdPlace = 1e7; // m

// One sentence for each that is so, with the worst element.
std::vector<Message> absurdities(const Simulation& simulation);

} // namespace ripstop
