// Why a simulation cannot go on. What finds it is step/watchdog.h; simulations, exporters and the
// command line pass it on.
#pragma once

#include "base/message.h"
#include "system/key.h"

namespace ripstop {

struct Trouble
{
    double time = 0.0; // s
    Key particle = 0;  // the first that went wrong
    Message message;   // element, time and likely cause, for people
};

} // namespace ripstop
