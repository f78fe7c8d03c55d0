// The events of a run that is not recorded; a recorder has its own.
#pragma once

#include "recording/event_watch.h"
#include "simulation/simulation.h"

#include <vector>

namespace ripstop {

class EventList
{
public:
    explicit EventList(Simulation& simulation)
    {
        simulation.keepInputs(&m_inputs);
        m_watch.begin(simulation);
    }

    void look(const Simulation& simulation)
    {
        const auto events = m_watch.look(simulation, m_inputs);
        m_events.insert(m_events.end(), events.begin(), events.end());
        m_inputs.clear();
    }

    const std::vector<RunEvent>& all() const { return m_events; }

private:
    EventWatch m_watch;
    std::vector<RunInput> m_inputs;
    std::vector<RunEvent> m_events;
};

} // namespace ripstop
