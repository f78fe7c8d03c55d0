// What a panel carries of the pull of a fabric at one instant, in the numbers that people read. The
// engine finds it (system/membrane.h), frames have it.
#pragma once

#include "base/cloth_law.h"

namespace ripstop {

struct PanelPull
{
    bool carries = false; // or links do it, and there is nothing to tell
    ClothState state = ClothState::Slack;
    double strain = 0.0;  // 1, the largest of its threads; 0 where it is slack
    double tension = 0.0; // N/m, the largest principal one, per width of the flat cloth; negative
                          // where it pushes all around

    friend bool operator==(const PanelPull&, const PanelPull&) = default;
};

} // namespace ripstop
