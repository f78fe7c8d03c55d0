#pragma once

#include "system/system.h"

#include <memory>

namespace ripstop {

// An exact instant of a run: what it can go on from.
struct Moment
{
    std::shared_ptr<const System> system; // as it was compiled
    State state;
};

} // namespace ripstop
