// Loads that come within a few time steps, as those of a line that gets tight with a weight flying
// at its end: its snatch load.
//
// The energy of what moves becomes that of what stretches there, E, and the load grows with its
// root. What the steps take on the way (step/numerical_damping.h), T, is missing from it: the load
// would be sqrt(1 + T / E) times as high. So a step is done again in finer ones where a line got
// tight and T is a part of E that counts, and what is missing from a peak all the same, its
// shortfall, is told.
//
// T of a peak is that of the last eight steps, since a load that takes longer to rise is told well:
// a quarter of a swing of 32 steps loses less than 1 % of it by BDF2. T is of all that moves and E
// of all rods and panels, so that this says how far a load is from sure, more than what it is. It
// is told with BDF2 alone, which notices when a line gets tight.
#pragma once

#include "step/stepper.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ripstop {

class SnatchLoads
{
public:
    // In how many each substep is cut where it is too long for a line that gets tight.
    static constexpr int finer = 8;

    // Whether it was, in the last step, of which this is the end. Only Solver::Auto is asked, as
    // others do what they are told.
    bool needFinerStep(const System& system, const State& state, const Stepper& stepper);

    // After each step.
    void note(const System& system, const Stepper& stepper);

    // 1, of a load that has its peak at the end of the last step; 0 where no line got tight shortly
    // before, or a run has just begun, as all lines get tight then.
    double shortfall(const System& system, const State& state);

private:
    double stretchOf(const System& system, const State& state); // J

    std::array<double, 8> m_taken{}; // J, by the last steps
    std::size_t m_next = 0;
    std::size_t m_sinceSnatch = std::tuple_size_v<decltype(m_taken)>; // steps, no more than these
    std::vector<double> m_restLength;                                 // [rods] m, of now
};

} // namespace ripstop
