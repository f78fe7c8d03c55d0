// When the parts of a run first come down on colliders, where and how fast: what a parachute is
// asked first. Called before and after each step, on the thread that steps; it looks and changes
// nothing.
#pragma once

#include "base/vec3.h"
#include "recording/touch_watch.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

struct Landing
{
    double time = 0.0;            // s
    std::uint32_t part = 0;       // id
    std::uint32_t collider = 0;   // id
    std::uint32_t particle = 0;   // id, of the part's: the fastest of those that touch first
    Vec3 place = Vec3::Zero();    // m, of it, where it touches
    Vec3 velocity = Vec3::Zero(); // m/s, of it, a step earlier: contact has taken it since

    double speed() const { return velocity.norm(); } // m/s
};

class LandingWatch
{
public:
    void begin(); // before the first step that is looked at

    void beforeStep(const Simulation& simulation);
    void afterStep(const Simulation& simulation);

    // The first of each part on each collider, in order of time. What touches from the first step
    // on rests there and lands when it has been off.
    std::span<const Landing> all() const { return m_landings; }

private:
    bool isKnown(const RunEvent& contact) const;
    void add(const Simulation& simulation, const RunEvent& contact);

    TouchWatch m_touches;
    std::vector<PaddedVec3> m_velocity; // [particles] m/s, before the step
    std::vector<RunEvent> m_events;
    std::vector<Landing> m_landings;
};

} // namespace ripstop
