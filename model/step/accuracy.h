// How true the pulls of a step are: what the law of each rod says its pull is, by its length and
// compliance, against what the equations of motion gave it, which is its tension.
//
// Both are the same where the solver has converged. Sweeps that have not leave rods longer than
// their tension explains: the design is softer then than what was typed, however still it hangs.
//
//   - Rods with a compliance c: the error is the root of sum c (law - given)^2 / sum c given^2, the
//     energy of what is off over that of the pulls. Pulls that strain a rod by less than 1e-5 do
//     not count; and where all of them are less than a tenth of the weight, as in what falls
//     freely, errors are compared with that (DirectSolver::leastEnergy()).
//   - Rods without one have no law but their length: their strain stands for the error, against the
//     strain that is wanted.
//
// Springs, bends and the like are forces: what they give is what their laws say, and where that is
// too stiff for the step the watchdog says so.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <limits>
#include <span>

namespace ripstop {

struct StepAccuracy
{
    double pulls = 0.0;  // 1, the error of pulls in rods with compliance
    double strain = 0.0; // 1, the largest of rods without
    int pullsRod = -1;   // the rod that is furthest off, or -1
    int strainRod = -1;

    // How often the error is as large as it may be: at most 1 when the step is as true as wanted.
    double ratio(const System& system) const;
    int worstRod(const System& system) const;
};

// Rods between pins, which no solver can help, do not count.
//   restLength  [rods]  m, with damping (constraints/rod_damping.h)
//   reach       s, of the last substep; infinite where damping counts for nothing
//   leastEnergy J, twice the energy of pulls that errors are compared with at least
StepAccuracy accuracyOf(const System& system, const State& state,
                        std::span<const double> restLength, ThreadPool& pool,
                        double reach = std::numeric_limits<double>::infinity(),
                        double leastEnergy = 0.0);

} // namespace ripstop
