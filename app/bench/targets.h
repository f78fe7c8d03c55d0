// What the engine is meant to reach on a machine like AMD's EPYC of 2.4 to 3 GHz, held against the
// rows that the races made. Judged by medians; the quiet figure stands beside it.
#pragma once

#include "terminal/terminal.h"

namespace ripstop {

// Only those targets for which there are rows.
Json judgedTargets(const Json& results);

void printTargets(const Json& targets);

} // namespace ripstop
