#pragma once

#include "sim/system.h"

#include <string_view>

namespace ripstop {

// "m", "deg", "N", ...; empty when dimensionless. Elevation is in degrees because that is how
// fliers speak of it.
std::string_view unitOf(Quantity quantity);

// The value that the probe reads now. Not a number when it has nothing to read, for example the
// glide ratio of something that does not sink.
double valueOf(const ProbeSpec& probe, const System& system, const State& state);

} // namespace ripstop
