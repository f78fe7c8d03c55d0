// What was done in a recorded run, done again to a simulation that computes it once more. Used on
// the thread that steps the simulation; the recording may still grow meanwhile, what is added later
// is not done.
#pragma once

#include "base/hands.h"
#include "base/result.h"
#include "simulation/run_input.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ripstop {

class Recording;
class Simulation;
struct State;

// Does to a simulation again what a recording says was done to it.
class InputPlayer
{
public:
    // `start` is an exact state of the recording; what was taken at its boundary is done first.
    InputPlayer(const Recording& recording, const State& start);

    // Call before each step. Fails when a design cannot be compiled here.
    std::optional<Failure> giveTo(Simulation& simulation);

private:
    std::optional<Failure> give(const RunInput& input, Simulation& simulation);

    const Recording& m_recording;
    std::vector<RunInput> m_inputs;
    std::size_t m_next = 0;
    HandCommands m_hands; // told so far
};

} // namespace ripstop
