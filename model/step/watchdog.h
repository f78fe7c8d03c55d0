#pragma once

#include "base/message.h"
#include "system/system.h"

#include <optional>

namespace ripstop {

// Why a simulation cannot go on.
struct Trouble
{
    double time = 0.0; // s
    Key particle = 0;  // the first that went wrong
    Message message;   // element, time and likely cause, for people
};

// Looks for a position that is not finite or a speed above the system's limit. `before` is the
// state one step earlier, in which the cause is looked for; the step had that many substeps.
std::optional<Trouble> findTrouble(const System& system, const State& before, const State& after,
                                   int substeps);

} // namespace ripstop
