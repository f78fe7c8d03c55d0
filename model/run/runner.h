#pragma once

#include "run/latest_value.h"
#include "run/recorder.h"
#include "run/settle.h"
#include "run/simulation.h"

#include <atomic>
#include <condition_variable>
#include <limits>
#include <thread>

namespace ripstop {

// Runs a simulation on a thread of its own, paced to the clock.
//
// Both directions are mailboxes of immutable values, so neither side ever waits for the other and
// nothing is shared that can change. Frames and commands have one slot, which may skip values, so
// what it carries must be a state and never an event: a reset is a system with another run number,
// not a message. Updates build on each other: what waits are the newest system and the patches
// since.
class Runner
{
public:
    Runner();

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
    [[nodiscard]] std::shared_ptr<const Frame> takeFrame() { return m_frames.take(); }

    // What the probes read after each step and edit, in order; all since the last call. Frames
    // leave out what nobody would see, and one that nobody took is lost; these are not.
    [[nodiscard]] std::vector<ProbeSample> takeSamples();

    // Bytes that each run from now on may keep of itself in memory; 0 keeps nothing.
    void setRecordingMemory(std::size_t bytes) { m_recordingMemory = bytes; }

    // Of the runs that have begun since the last call. They grow while the runs go on.
    [[nodiscard]] std::vector<std::shared_ptr<Recording>> takeRecordings();

private:
    void run(const std::stop_token& stop);
    void wake();
    void tell(const std::shared_ptr<Recording>& recording);

    std::vector<Update> takeUpdates();

    std::vector<Update> m_updates; // guarded by m_mutex
    LatestValue<Commands> m_commands;
    LatestValue<HandCommands> m_hands;
    LatestValue<std::optional<SettleGoal>> m_settle;
    LatestValue<Frame> m_frames;
    std::atomic<bool> m_playing = false;
    std::atomic<double> m_speed = 1.0;
    std::atomic<int> m_stepsLeft = 0;
    std::atomic<double> m_until = -std::numeric_limits<double>::infinity();
    std::atomic<std::size_t> m_recordingMemory = std::size_t(512) << 20; // bytes
    std::mutex m_mutex;
    bool m_woken = false;                                 // guarded by m_mutex
    std::vector<std::shared_ptr<Recording>> m_recordings; // the same
    std::vector<ProbeSample> m_samples;                   // the same
    std::condition_variable_any m_wake;
    std::jthread m_thread; // last: stops and joins before the rest is destroyed
};

} // namespace ripstop
