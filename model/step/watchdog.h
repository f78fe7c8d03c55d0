// The watchdog: tells after a step whether the motion is still one that a simulation can go on
// from. It reads the states that it is given and nothing else: any thread may call it.
#pragma once

#include "base/message.h"
#include "system/system.h"
#include "system/trouble.h"

#include <optional>

namespace ripstop {

// Looks for a position that is not finite or a speed above the system's limit. `before` is the
// state one step earlier, in which the cause is looked for; the step had that many substeps.
std::optional<Trouble> findTrouble(const System& system, const State& before, const State& after,
                                   int substeps);

} // namespace ripstop
