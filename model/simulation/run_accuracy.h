// How true the forces of a run are, step by step: what was wanted, what the last step reached, and
// how often it was missed. step/accuracy.h says what is measured; it is no part of the state, and
// begins anew with a reset, an edit or a jump.
#pragma once

#include "base/message.h"

#include <cstdint>

namespace ripstop {

struct RunAccuracy
{
    // The steps that may miss what was wanted, as a share of all, before a run counts as untrue:
    // the first steps from the pose of the design and blows are hard to foresee.
    static constexpr double mostMissed = 0.01;

    double pulls = 0.0;         // 1, error of the pulls of the last step
    double strain = 0.0;        // 1, largest of the last step in rods that never stretch
    double wantedPulls = 0.01;  // 1
    double wantedStrain = 0.01; // 1
    bool isAutomatic = false;   // the solver chooses what it takes
    std::int64_t steps = 0;
    std::int64_t missed = 0;     // steps of which either was too large
    double worst = 0.0;          // 1, how often the error was as large as it may be, at most
    double worstTime = 0.0;      // s
    double missedLast = 0.0;     // s, at the end of the last step that missed
    std::uint32_t worstLink = 0; // id; 0 for none
    double fastestSwing = 0.0;   // Hz, that the next step tells as it is: step/true_swings.h

    double missedShare() const { return steps > 0 ? double(missed) / double(steps) : 0.0; }
    bool isMet() const { return missedShare() <= mostMissed; }

    // A sentence for people where it is not met; empty where it is.
    Message complaint() const;
};

} // namespace ripstop
