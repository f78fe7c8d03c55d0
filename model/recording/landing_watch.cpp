#include "recording/landing_watch.h"

#include "contact/contact.h"
#include "simulation/simulation.h"

#include <algorithm>

namespace ripstop {

void LandingWatch::begin()
{
    m_touches.begin(TouchWatch::Begin::AsItIs);
    m_landings.clear();
}

void LandingWatch::beforeStep(const Simulation& simulation)
{
    if (!simulation.system().obstacles.empty())
        m_velocity = simulation.state().velocity;
}

void LandingWatch::afterStep(const Simulation& simulation)
{
    if (simulation.system().obstacles.empty())
        return;
    m_events.clear();
    m_touches.look(simulation, m_events);
    for (const RunEvent& event : m_events)
        if (event.kind == RunEvent::Kind::Contact && !isKnown(event))
            add(simulation, event);
}

bool LandingWatch::isKnown(const RunEvent& contact) const
{
    return std::ranges::any_of(m_landings, [&](const Landing& landing) {
        return landing.part == contact.what && landing.collider == contact.with;
    });
}

void LandingWatch::add(const Simulation& simulation, const RunEvent& contact)
{
    const System& system = simulation.system();
    const std::span<const std::uint32_t> touches = simulation.touches();
    const auto part = std::ranges::find(system.parts, contact.what, &PartPlace::key);
    const auto obstacle = std::ranges::find(system.obstacles, contact.with, &Obstacle::key);
    const std::uint32_t bit = touchOf(std::size_t(obstacle - system.obstacles.begin()));
    // twins of a tear stand behind all parts
    const std::size_t known = std::min(touches.size(), m_velocity.size());
    const std::size_t end =
        part + 1 == system.parts.end() ? known : std::min(known, std::size_t((part + 1)->first));

    Landing landing{contact.time, contact.what, contact.with};
    double fastest = -1.0; // m/s
    for (auto i = std::size_t(part->first); i < end; ++i)
        if ((touches[i] & bit) && m_velocity[i].norm() > fastest) {
            fastest = m_velocity[i].norm();
            landing.particle = system.key[i];
            landing.place = simulation.state().position[i];
            landing.velocity = m_velocity[i];
        }
    if (fastest >= 0.0)
        m_landings.push_back(landing);
}

} // namespace ripstop
