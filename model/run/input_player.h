#pragma once

#include "run/recording.h"
#include "run/simulation.h"

namespace ripstop {

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
