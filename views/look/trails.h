// The ways that some particles have come lately.
//
// It collects places from frames as they are shown, at most one every 0.02 s of simulated time, and
// forgets what is older than 5 s. The trail layer draws the lines. A particle that begins to be
// followed has no past: its places before are not a number.
#pragma once

#include "scene/scene.h"
#include "simulation/frame.h"

#include <deque>
#include <vector>

namespace ripstop {

class Trails
{
public:
    static constexpr double length = 5.0;   // s, simulated
    static constexpr std::size_t most = 64; // particles
    static constexpr double closest = 0.02; // s, between points

    void follow(std::vector<std::uint32_t> particles); // ids; those that stay keep their trails
    const std::vector<std::uint32_t>& followed() const { return m_particles; }

    // Instants of one run come in order of time; an earlier one, or one of another run, begins
    // anew.
    void add(const Frame& frame);
    void clear();

    struct Point
    {
        double time;             // s
        std::vector<Vec3> place; // [followed] m, not a number where there is none
    };
    const std::deque<Point>& points() const { return m_points; }

private:
    std::vector<std::uint32_t> m_particles;
    std::deque<Point> m_points;
    std::uint64_t m_run = 0;
};

// Whose trails are wanted: the particles that are selected, or, when none is, those that probes
// look at.
std::vector<std::uint32_t> trailed(const Scene& scene, const std::vector<Id>& selected);

} // namespace ripstop
