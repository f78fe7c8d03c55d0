// Tearing: links that break, and the panels beside them that go with them.
#pragma once

#include "sim/system.h"

#include <span>

namespace ripstop {

// Breaks every link above its limit (above, not at) and notes the event. A rod is judged by its
// length before projection, since none is ever long afterwards, or by its multiplier.
//   rodLength    [rods]     m, before projection
//   springForce  [springs]  N, on end `a`
void tearLinks(const System& system, State& state, std::span<const double> rodLength,
               std::span<const PaddedVec3> springForce, std::span<const double> restLength);

} // namespace ripstop
