// Finds the events of a run, step by step: tears, what it was told from outside, parts that touch
// colliders, lines that go slack. The same steps give the same events, in the window, in the
// terminal and in a recording.
#pragma once

#include "recording/slack_watch.h"
#include "recording/touch_watch.h"

#include <span>
#include <vector>

namespace ripstop {

class Simulation;

class EventWatch
{
public:
    void begin(const Simulation& simulation); // before the first step that is looked at

    // After each step: what happened in it and, of `inputs`, was told since the last. Valid until
    // the next look.
    std::span<const RunEvent> look(const Simulation& simulation, std::span<const RunInput> inputs);

private:
    InputKind m_lastInput;
    double m_time = 0.0; // s, of the step before
    std::size_t m_tears = 0;
    TouchWatch m_touches;
    SlackWatch m_lines;
    std::vector<RunEvent> m_events;
};

} // namespace ripstop
