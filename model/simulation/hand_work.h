// What pilots and hands do to a run: takes what they tell, keeps it in the state of the run, and
// notes it with its time, so that it can be done again to the bit.
//
// Controls and what is held are told as they are now, cuts and halts as all since the start of the
// run, of which each is made once; a mailbox may skip values of both (HandCommands). What changes
// who can move and who hangs on whom, pins and cuts, goes the way of tears: into the state, and
// from there into the system (derived_system.h).
//
// Belongs to a Simulation and is called between two steps, by whoever steps that.
#pragma once

#include "simulation/commands.h"
#include "simulation/derived_system.h"
#include "simulation/run_input.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace ripstop {

class HandWork
{
public:
    // Adds what is told from now on; null stops that.
    void keepInputs(std::vector<RunInput>* inputs) { m_inputs = inputs; }

    void forget(); // what was done: another run begins

    void command(const Commands& told, const System& system, RunState& run);
    void handle(const HandCommands& told, DerivedSystem& system, RunState& run);
    void halt(RunState& run); // all motion, beside the halts that are told

    // What frames show of it; `h` is the next substep, s.
    void fill(Frame& frame, const System& system, const State& state, double h) const;

private:
    void handle(const Hands& told, DerivedSystem& system, RunState& run);
    void carry(const std::vector<Carry>& told, RunState& run);
    void pin(const std::vector<std::uint32_t>& told, DerivedSystem& system, RunState& run);
    void cut(const std::shared_ptr<const Cut>& cut, DerivedSystem& system, RunState& run);
    void stopMotion(RunState& run);
    void note(HandNote::What what, RunState& run);

    std::vector<ControlCommand> m_commands; // since the start, as all of these
    HandTrack m_track;
    std::size_t m_cuts = 0; // made
    int m_halts = 0;        // made
    std::vector<RunInput>* m_inputs = nullptr;
};

} // namespace ripstop
