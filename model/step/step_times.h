// Where the time of a step goes, in seconds of wall time by stage, for people who ask why a scene
// is slow. A stepper owns the clock and writes into the StepTimes that it is given, on the thread
// that steps.
#pragma once

#include <array>
#include <chrono>
#include <string_view>

namespace ripstop {

enum class StepStage {
    Plan,
    Controls,
    Springs,
    Air,
    Sum,
    Motion,
    Rods,
    Contact,
    Tearing,
    Tensions,
    Watch
};

inline constexpr std::array<std::string_view, 11> stepStageNames{
    "plan", "controls", "springs", "air",      "sum of forces", "motion",
    "rods", "contact",  "tearing", "tensions", "watch"};

struct StepTimes
{
    std::array<double, stepStageNames.size()> seconds{}; // s of wall time, by StepStage
};

// Gives the time since its last lap to a stage. Without anybody to give it to it does nothing.
class StepClock
{
public:
    void giveTo(StepTimes* times) { m_times = times; }

    void start()
    {
        if (m_times)
            m_lap = Clock::now();
    }

    void lap(StepStage stage)
    {
        if (!m_times)
            return;
        const Clock::time_point now = Clock::now();
        m_times->seconds[std::size_t(stage)] += std::chrono::duration<double>(now - m_lap).count();
        m_lap = now;
    }

private:
    using Clock = std::chrono::steady_clock;
    StepTimes* m_times = nullptr;
    Clock::time_point m_lap;
};

} // namespace ripstop
