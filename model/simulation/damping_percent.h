// How much the time steps damp a motion, as the command line and the complaints of a run say it.
#pragma once

#include "base/message.h"

namespace ripstop {

// The number before "% of critical", to two digits. How far above 100 it is says nothing: what is
// damped by that much does not swing.
Message dampingPercent(double damping);

} // namespace ripstop
