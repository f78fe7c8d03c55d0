#include "run/runner.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ripstop {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

Clock::duration seconds(double s)
{
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

// Simulated seconds per second of the clock, over about the last half second.
class Pace
{
public:
    void restart(double simulated)
    {
        m_clock = Clock::now();
        m_simulated = simulated;
    }
    double update(double simulated)
    {
        const double passed = std::chrono::duration<double>(Clock::now() - m_clock).count();
        if (passed > 0.5) {
            m_ratio = (simulated - m_simulated) / passed;
            restart(simulated);
        }
        return m_ratio;
    }

private:
    Clock::time_point m_clock = Clock::now();
    double m_simulated = 0.0;
    double m_ratio = 0.0;
};

// When the next step of a paced run is due.
class Timetable
{
public:
    void restart() { m_due = Clock::now(); }
    void setPlaying(bool playing)
    {
        if (playing && !m_playing)
            restart(); // the time of a pause is not made up for
        m_playing = playing;
    }
    void stepped(double timeStep, double speed)
    {
        m_due = speed > 0.0 ? m_due + seconds(timeStep / speed) : Clock::now();
        m_due = std::max(m_due, Clock::now() - 100ms); // too slow for real time: do not chase it
    }
    bool isPlaying() const { return m_playing; }
    bool isDue() const { return m_playing && Clock::now() >= m_due; }
    Clock::duration left() const { return m_due - Clock::now(); }

private:
    Clock::time_point m_due = Clock::now();
    bool m_playing = false;
};

// What depends on the clock is nowhere but in what somebody watches.
void readClock(std::vector<double>& probe, double realTimeRatio, const System& system)
{
    for (std::size_t i = 0; i < system.probes.size(); ++i)
        if (system.probes[i].quantity == Quantity::StepsPerSecond)
            probe[i] = realTimeRatio / system.timeStep;
}

} // namespace

Runner::Runner()
    : m_thread([this](const std::stop_token& stop) { run(stop); })
{}

void Runner::load(Update update)
{
    std::vector<Update> replaced; // dies after the lock is released
    {
        const std::lock_guard lock(m_mutex);
        if (update.system)
            m_updates.swap(replaced);
        m_updates.push_back(std::move(update));
    }
    wake();
}

std::vector<Update> Runner::takeUpdates()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_updates, {});
}

void Runner::setPlaying(bool playing)
{
    m_playing = playing;
    wake();
}

void Runner::setSpeed(double ratio)
{
    m_speed = ratio;
    wake();
}

void Runner::stepOnce()
{
    ++m_stepsLeft;
    wake();
}

void Runner::cancelSteps() { m_stepsLeft = 0; }

void Runner::playUntil(double time)
{
    m_until = time;
    wake();
}

void Runner::command(Commands commands)
{
    m_commands.put(std::make_shared<const Commands>(std::move(commands)));
    wake();
}

void Runner::handle(HandCommands commands)
{
    m_hands.put(std::make_shared<const HandCommands>(std::move(commands)));
    wake();
}

void Runner::settle(std::optional<SettleGoal> goal)
{
    m_settle.put(std::make_shared<const std::optional<SettleGoal>>(goal));
    wake();
}

std::vector<ProbeSample> Runner::takeSamples()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_samples, {});
}

std::vector<std::shared_ptr<Recording>> Runner::takeRecordings()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_recordings, {});
}

void Runner::tell(const std::shared_ptr<Recording>& recording)
{
    const std::lock_guard lock(m_mutex);
    m_recordings.push_back(recording);
}

void Runner::wake()
{
    {
        const std::lock_guard lock(m_mutex);
        m_woken = true;
    }
    m_wake.notify_one();
}

void Runner::run(const std::stop_token& stop)
{
    std::optional<Simulation> simulation;
    Timetable timetable;
    auto framed = Clock::time_point();
    bool fresh = false; // there is something that no frame has shown
    Pace pace;
    std::optional<Settler> settler;
    Recorder recorder;

    const auto keepSample = [&](ProbeSample read) {
        const std::lock_guard lock(m_mutex);
        m_samples.push_back(std::move(read));
    };
    const auto show = [&] {
        auto frame = simulation->frame();
        if (settler)
            frame->settling = settler->progress();
        frame->realTimeRatio = pace.update(frame->time);
        readClock(frame->probe, frame->realTimeRatio, simulation->system());
        if (!frame->probe.empty()) // a frame may go unseen, what the probes read may not
            keepSample({frame->run, frame->layout, frame->time, frame->probe});
        m_frames.put(std::move(frame));
        framed = Clock::now();
        fresh = false;
    };
    const auto sample = [&] {
        if (simulation->system().probes.empty())
            return;
        ProbeSample read = simulation->sample();
        readClock(read.probe, pace.update(read.time), simulation->system());
        keepSample(std::move(read));
    };

    while (!stop.stop_requested()) {
        // What was asked for before the updates were taken, and still is after it, is asked for in
        // the scene that they make: who loads and then plays is not shown a step of the old one.
        const bool wasPlaying = m_playing;
        const int stepsBefore = m_stepsLeft;
        const double untilBefore = m_until;
        if (auto updates = takeUpdates(); !updates.empty()) {
            for (Update& waiting : updates) {
                const Update update = std::exchange(waiting, {});
                if (!simulation)
                    simulation.emplace(update.system);
                simulation->load(update);
                recorder.loaded(*simulation, update.design);
            }
            if (settler && settler->run() != simulation->system().run)
                settler.emplace(settler->goal(), *simulation);
            timetable.restart();
            show();
        }
        if (const auto commands = simulation ? m_commands.take() : nullptr)
            simulation->command(*commands);
        if (const auto hands = simulation ? m_hands.take() : nullptr) {
            simulation->handle(*hands);
            fresh = true; // what is held or cut is seen in a pause, too
        }
        if (const auto goal = simulation ? m_settle.take() : nullptr) {
            settler.reset();
            if (*goal)
                settler.emplace(**goal, *simulation);
            fresh = true;
        }
        timetable.setPlaying(wasPlaying && m_playing);
        if (simulation && simulation->trouble())
            m_stepsLeft = 0; // steps that cannot be made are not made up for

        double until = std::min(untilBefore, m_until.load());
        const double timeStep = simulation ? simulation->system().timeStep : 0.0;
        const bool catchingUp =
            simulation && !hasReached(simulation->state().time, until, timeStep);
        int stepsLeft = std::min(stepsBefore, m_stepsLeft.load());
        const bool asked = simulation && stepsLeft > 0;
        const bool onTime = timetable.isDue();
        const bool settling = settler && !settler->isOver();
        if (simulation && !simulation->trouble() && (catchingUp || settling || asked || onTime)) {
            recorder.setMemory(m_recordingMemory);
            if (recorder.beforeStep(*simulation))
                tell(recorder.recording());
            fresh = simulation->step();
            if (fresh)
                recorder.afterStep(*simulation);
            if (settling && fresh)
                settler->look(*simulation);
            // unless another time has been asked for meanwhile
            if (catchingUp && hasReached(simulation->state().time, until, timeStep))
                m_until.compare_exchange_strong(until, -std::numeric_limits<double>::infinity());
            while (asked && stepsLeft > 0 // unless they have been cancelled meanwhile
                   && !m_stepsLeft.compare_exchange_weak(stepsLeft, stepsLeft - 1)) {
            }
            if (onTime)
                timetable.stepped(timeStep, m_speed);
            // Views take a frame every 16 ms; making more would only cost time.
            const bool settled = settling && settler->isOver();
            if (asked || settled || simulation->trouble() || Clock::now() - framed > 15ms)
                show();
            else
                sample();
            continue;
        }
        if (fresh && (!timetable.isPlaying() || timetable.left() > 2ms))
            show();

        const bool running = timetable.isPlaying() && simulation && !simulation->trouble();
        std::unique_lock lock(m_mutex);
        const auto patience = running ? timetable.left() : Clock::duration(1s);
        m_wake.wait_for(lock, stop, patience, [&] { return m_woken; });
        m_woken = false;
    }
}

} // namespace ripstop
