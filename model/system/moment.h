// A moment of a run that another run can begin with, in another window of time and after edits. It
// is constant once it is made, so any thread may have it. Code that only passes a Moment on
// declares its name and asks recording/recording.h for what is to be shown of it.
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
