// Whether anything in a frame has a strength, and with it a margin. Any thread may ask.
#pragma once

#include "simulation/frame.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

inline bool hasMargins(const Frame& frame)
{
    const auto isNumber = [](double margin) { return !std::isnan(margin); };
    return std::ranges::any_of(frame.linkMargin, isNumber)
           || std::ranges::any_of(frame.panelMargin, isNumber);
}

} // namespace ripstop
