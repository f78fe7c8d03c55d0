// A recording of what a pilot did: a CSV file of "time (s), control, value (m)".
#pragma once

#include "base/result.h"
#include "run/simulation.h"
#include "scene/scene.h"

#include <filesystem>
#include <vector>

namespace ripstop {

struct ControlCommand
{
    double time;           // s
    std::uint32_t control; // id
    double value;          // m, where the control is told to go
};

// In order of time. Controls are named by name or as #id. A first line whose time is no number is
// taken for a heading.
Result<std::vector<ControlCommand>> readControlTrack(const std::filesystem::path& file,
                                                     const Scene& scene);

// Gives a simulation its commands as their times come.
class ControlPlayer
{
public:
    explicit ControlPlayer(std::vector<ControlCommand> track)
        : m_track(std::move(track))
    {}

    // Call before each step.
    void giveTo(Simulation& simulation);

private:
    std::vector<ControlCommand> m_track;
    std::size_t m_next = 0;
};

} // namespace ripstop
