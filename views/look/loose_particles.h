// Particles that no link and no panel holds: nothing else shows where they are.
//
// What is torn or cut holds nothing any more. Layers and picking ask, in the thread of the window;
// it is a walk over all links and panels.
#pragma once

#include "simulation/frame.h"

#include <cstdint>
#include <vector>

namespace ripstop {

std::vector<std::uint8_t> looseParticles(const Frame& frame); // [particles]

} // namespace ripstop
