// A system in motion: state, stepper and watchdog together. The runner thread, the command line
// and the exporters all drive one of these, so that they get the same bits.
//
// One thread at a time may use a simulation, and it is the only owner of what it changes: the
// system that it was given is copied before a patch changes it where anybody else holds it. Frames
// and samples are values of their own and may go anywhere.
//
// What tears, cuts and pins make of a system is the work of derived_system.h, what pilots and hands
// tell that of hand_work.h; both and the stepper stand behind Private, so that an edit of the
// engine is no edit of those who drive it.
#pragma once

#include "compile/update.h"
#include "simulation/commands.h"
#include "simulation/frame.h"
#include "simulation/reached.h"
#include "simulation/run_input.h"
#include "system/system.h"
#include "system/trouble.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ripstop {

struct StepTimes; // step/step_times.h

class Simulation
{
public:
    // Threads that make use of the whole machine. Small designs stay on one of them, and the result
    // is the same at any number.
    static int mostThreads();

    explicit Simulation(std::shared_ptr<const System> system, int threads = 1);

    // Goes on from a checkpoint: the state of a simulation of this system.
    Simulation(std::shared_ptr<const System> system, State checkpoint, int threads = 1);

    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    // Goes on with an edited system. The motion carries over unless its run number differs.
    void load(std::shared_ptr<const System> system);

    // Goes on after an edit. A patch changes the system in place and leaves it with the same bits
    // as loading the compiled scene; the system is copied first if anyone else holds it.
    void load(Update update) { load(std::vector{std::move(update)}); }

    // Those that have come while it was busy: patches that follow each other are one edit.
    void load(std::vector<Update> updates);

    void command(const Commands& commands);

    // Takes effect at once; cuts and halts are those since the start of the run, and are made once.
    void handle(const HandCommands& told);

    void halt(); // stops all motion; it starts again from rest

    // Goes on from a moment of another run, with the motion of what both have: to the same bits
    // when nothing was edited since. What was done in this run is forgotten.
    void resume(const Moment& moment);

    // Shows another instant of the same system, for who has kept it; no step follows.
    void place(State state);

    // Adds what commands and hands change from now on; null stops that.
    void keepInputs(std::vector<RunInput>* inputs);

    // One time step. False, and the last good state stays, when the next one would be broken;
    // trouble() then says why.
    bool step();

    // Steps until `time`, s, is reached, as hasReached() has it.
    bool runUntil(double time);

    // Cuts each substep, however long the solver makes it, in so many from now on (certificate.h).
    void refine(int times);

    // Adds what each stage of the steps from now on takes; null stops that.
    void keepTimes(StepTimes* times);

    // What runs: the system that was loaded, or what tears have made of it (split_system.h).
    const System& system() const;
    const std::shared_ptr<const System>& compiled() const;
    const State& state() const;
    std::span<const std::uint32_t> touches() const; // as Stepper::touches() has them
    const std::optional<Trouble>& trouble() const;

    std::shared_ptr<Frame> frame() const; // a new one, the caller's own
    ProbeSample sample() const;           // its probes alone

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace ripstop
