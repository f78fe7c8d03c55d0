// How deep in an obstacle a run began, for who looks for the cause of what became of it.
#pragma once

#include "system/system.h"

namespace ripstop {

// Of the start of the system: how many particles contact had to put outside of an obstacle, and how
// far the deepest of them, m.
struct StartDepth
{
    int particles = 0;
    double deepest = 0.0;
};
StartDepth startDepth(const System& system);

} // namespace ripstop
