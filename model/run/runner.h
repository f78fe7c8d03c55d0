// Runs a simulation on a thread of its own, paced to the clock.
//
// Both directions are mailboxes of immutable values (runner_mail.h), so neither side ever waits for
// the other and nothing is shared that can change. Frames and commands have one slot, which may
// skip values, so what it carries must be a state and never an event: a reset is a system with
// another run number, not a message. Updates build on each other: what waits are the newest system
// and the patches since.
//
// Everything here may be called from any thread, and takes effect at the next step boundary. What
// the thread of the simulation does between two steps is runner_loop.h:
//
//     state    what it does                           until
//     Empty    sleeps, there is no system             an update brings the first one
//     Resting  sleeps, nothing asks for a step        play, a time, steps or rest are asked for
//     Paced    a step whenever the clock says so      pause, or it is hurried
//     Hurried  step after step, as fast as it can     the time, the steps or rest are reached
//     Stuck    sleeps, the next step would be broken  an update may have cured it
#pragma once

#include "base/hands.h"
#include "compile/update.h"
#include "run/settle.h"
#include "simulation/commands.h"
#include "simulation/frame.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

namespace ripstop {

class Recording;
struct RunnerMail;

class Runner
{
public:
    Runner();
    ~Runner();
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    // Takes effect at the next step boundary. The motion carries over unless `run` differs. The
    // first update is a system.
    void load(Update update);
    void load(std::shared_ptr<const System> system) { load(Update{std::move(system), nullptr}); }

    void setPlaying(bool playing);
    // Simulated seconds per second of the clock; 0 is as fast as it can.
    void setSpeed(double ratio);
    void stepOnce();                 // one time step, playing or not
    void cancelSteps();              // those asked for that have not been made
    void playUntil(double time);     // s; plays unpaced and stops exactly there
    void command(Commands commands); // all commands so far; the newest value of each control

    void handle(HandCommands commands); // all so far

    // Runs on, as fast as it can, until all is still or the goal's time is over; nothing ends that
    // sooner. Where it stands is told by Frame::settling.
    void settle(std::optional<SettleGoal> goal);

    // The newest frame, or null when there is none since the last call.
    [[nodiscard]] std::shared_ptr<const Frame> takeFrame();

    // What the probes read after each step and edit, in order; all since the last call. Frames
    // leave out what nobody would see, and one that nobody took is lost; these are not.
    [[nodiscard]] std::vector<ProbeSample> takeSamples();

    // Bytes that each run from now on may keep of itself in memory; 0 keeps nothing.
    void setRecordingMemory(std::size_t bytes);

    // Of the runs that have begun since the last call. They grow while the runs go on.
    [[nodiscard]] std::vector<std::shared_ptr<Recording>> takeRecordings();

private:
    std::unique_ptr<RunnerMail> m_mail;
    std::jthread m_thread; // last: stops and joins before the rest is destroyed
};

} // namespace ripstop
