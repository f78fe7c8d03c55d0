#include "recording/event_watch.h"

#include "simulation/simulation.h"

namespace ripstop {

void EventWatch::begin(const Simulation& simulation)
{
    const State& state = simulation.state();
    m_lastInput = {};
    m_time = state.time;
    m_tears = state.tears.size();
    m_touches.begin(state.step == 0 ? TouchWatch::Begin::Untouched : TouchWatch::Begin::AsItIs);
    m_lines.begin(state.time);
}

std::span<const RunEvent> EventWatch::look(const Simulation& simulation,
                                           std::span<const RunInput> inputs)
{
    const State& state = simulation.state();
    m_events.clear();
    for (const RunInput& input : inputs) {
        if (isEvent(input, m_lastInput))
            m_events.push_back(eventOf(input, m_time));
        m_lastInput = kindOf(input);
    }
    if (state.tears.size() > m_tears)
        m_events.push_back({RunEvent::Kind::Tear, state.step, state.tears[m_tears].time,
                            state.tears[m_tears].element, int(state.tears.size() - m_tears)});
    m_touches.look(simulation, m_events);
    m_lines.look(simulation, m_events);
    m_tears = state.tears.size();
    m_time = state.time;
    return m_events;
}

} // namespace ripstop
