// The sides of panels, as pairs of particles that are the same whichever comes first, so that
// panels and links can be found by what they share.
#pragma once

#include "scene/items.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ripstop {

using PanelSide = std::pair<Id, Id>; // the lower id first

inline PanelSide sideOf(Id a, Id b) { return {std::min(a, b), std::max(a, b)}; }

// ab, bc and ca, as `restLengths` has them.
inline std::array<PanelSide, 3> sidesOf(const Panel& panel)
{
    return {sideOf(panel.a, panel.b), sideOf(panel.b, panel.c), sideOf(panel.c, panel.a)};
}

inline constexpr std::array<double Panel::*, 3> restLengths{&Panel::restAB, &Panel::restBC,
                                                            &Panel::restCA};

} // namespace ripstop
