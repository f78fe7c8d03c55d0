// Loads that come within a few time steps, as those of a line that gets tight with a weight flying
// at its end: its snatch load.
//
// The energy of what moves becomes that of what stretches there, E, and the load grows with its
// root. What the steps take on the way (step/numerical_damping.h), T, is missing from it: the load
// would be sqrt(1 + T / E) times as high. And of a load that rises and falls within a few steps,
// their ends miss the peak. So steps of a blow are done again in finer ones, where T is a part of
// E that counts or what lines hold changes by a fifth in a step, and loads are looked at within
// them. What is missing from a peak all the same, its shortfall, is told.
//
// A blow is where a line has got tight and stopped something within a substep, or where lines hold
// more than the steps take: of what they take while lines hold next to nothing, no line is the
// cause. All this is seen in the step alone, so that a run goes on alike from each moment.
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
    // In how many each substep of a blow is cut.
    static constexpr int finer = 8;

    // Whether the last step, which went from one state to the other, was of a blow and too long
    // for it.
    bool isTooLong(const System& system, const State& before, const State& after,
                   const Stepper& stepper);

    // What breaks does so at the end of a substep, and has borne more than it holds by then. In how
    // many each of the last step, which was cut in so many, is to be cut so that lines and spars
    // break within the accuracy of what they hold; no more than are worth the wait. What bore too
    // much before the step, as its strength was changed, breaks no sooner in finer ones.
    static int finerForBreaks(const System& system, const State& before, const Stepper& stepper,
                              int finer);

    // After each step, whether it was too long before it was done again, maybe.
    void note(const System& system, const Stepper& stepper, bool wasTooLong);

    // 1, of a load that has its peak in the last step; 0 where there was no blow shortly before, or
    // a run has just begun, as all lines get tight then.
    double shortfall(const System& system, const State& before, const State& after);

private:
    double stretchOf(const System& system, const State& state);      // J, of all
    double stretchOfLines(const System& system, const State& state); // J
    std::span<const double> lengths(const System& system, const State& state);

    std::array<double, 8> m_taken{}; // J, by the last steps
    std::size_t m_next = 0;
    std::size_t m_sinceBlow = std::tuple_size_v<decltype(m_taken)>; // steps, no more than these
    std::vector<double> m_restLength;                               // [rods] m, scratch
};

} // namespace ripstop
