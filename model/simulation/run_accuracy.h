// How true a run is, step by step: what was wanted of its forces, what the last step reached, and
// how often it was missed, which step/accuracy.h measures; and how much of its motion the steps
// damp, which step/numerical_damping.h and simulation/recent_damping.h do. It is no part of the
// state, and begins anew with a reset, an edit or a jump.
#pragma once

#include "base/message.h"
#include "laws/load_margin.h"

#include <cstdint>

namespace ripstop {

struct RunAccuracy
{
    // The steps that may miss what was wanted, as a share of all, before a run counts as untrue:
    // the first steps from the pose of the design and blows are hard to foresee.
    static constexpr double mostMissed = 0.01;

    // The damping ratio of the steps, 1, from which on they take what a design has of its own:
    // cords have about as much.
    static constexpr double mostDamping = 0.01;

    // The share of its energy, 1, from which on a motion dies away by the steps.
    static constexpr double mostLost = 0.05;

    double pulls = 0.0;         // 1, error of the pulls of the last step
    double strain = 0.0;        // 1, largest of the last step in rods that never stretch
    double wantedPulls = 0.01;  // 1
    double wantedStrain = 0.01; // 1
    bool isAutomatic = false;   // the solver chooses what it takes
    std::int64_t steps = 0;
    std::int64_t missed = 0;      // steps of which either was too large
    double worst = 0.0;           // 1, how often the error was as large as it may be, at most
    double worstTime = 0.0;       // s
    double missedLast = 0.0;      // s, at the end of the last step that missed
    std::uint32_t worstLink = 0;  // id; 0 for none
    std::int64_t tornUntrue = 0;  // links and panels that broke in such steps
    double tornUntrueFirst = 0.0; // s, when the first of them did
    double fastestSwing = 0.0;    // Hz, that the next step tells as it is: step/true_swings.h
    double damping = 0.0;         // 1, of critical, that the last ten seconds of steps have taken
    double lost = 0.0;            // 1, of the motion, at most: RecentDamping::lost()
    bool couldTakeBdf2 = false;   // its solver goes with it, and the last step was none
    bool losesInLines = false;    // `lost` is much, and there are lines that never stretch

    double missedShare() const { return steps > 0 ? double(missed) / double(steps) : 0.0; }
    bool isMet() const { return missedShare() <= mostMissed && tornUntrue == 0; }

    // A sentence for people where it is not met; empty where it is.
    Message complaint() const;

    // The same where it is met, and the steps damp the motion by more than `mostDamping`, or have
    // taken more than `mostLost` of it: forces that are not true come first.
    Message dampingComplaint() const;

    // Likewise, where the worst load of the run came in a blow and may have been far higher; empty
    // where it is told well, has broken, or is next to nothing all the same.
    Message loadComplaint(const WorstPlaces& ofRun) const;
};

} // namespace ripstop
