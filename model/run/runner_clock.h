// The two clocks of a runner: how fast a run goes, and when its next step is due. Used on the
// thread of the simulation; nothing of what they tell changes what is computed.
#pragma once

#include <algorithm>
#include <chrono>

namespace ripstop {

using RunnerClock = std::chrono::steady_clock;

// Simulated seconds per second of the clock, over about the last half second.
class Pace
{
public:
    double update(double simulated) // s
    {
        const double passed = std::chrono::duration<double>(RunnerClock::now() - m_clock).count();
        if (passed > 0.5) {
            m_ratio = (simulated - m_simulated) / passed;
            m_clock = RunnerClock::now();
            m_simulated = simulated;
        }
        return m_ratio;
    }

private:
    RunnerClock::time_point m_clock = RunnerClock::now();
    double m_simulated = 0.0; // s
    double m_ratio = 0.0;
};

// When the next step of a paced run is due.
class Timetable
{
public:
    void restart() { m_due = RunnerClock::now(); }
    void setPlaying(bool playing)
    {
        if (playing && !m_playing)
            restart(); // the time of a pause is not made up for
        m_playing = playing;
    }
    void stepped(double timeStep, double speed) // s; simulated seconds per second
    {
        const std::chrono::duration<double> step(timeStep / speed);
        m_due = speed > 0.0 ? m_due + std::chrono::duration_cast<RunnerClock::duration>(step)
                            : RunnerClock::now();
        // too slow for real time: do not chase it
        m_due = std::max(m_due, RunnerClock::now() - std::chrono::milliseconds(100));
    }
    bool isPlaying() const { return m_playing; }
    bool isDue() const { return m_playing && RunnerClock::now() >= m_due; }
    RunnerClock::duration left() const { return m_due - RunnerClock::now(); }

private:
    RunnerClock::time_point m_due = RunnerClock::now();
    bool m_playing = false;
};

} // namespace ripstop
