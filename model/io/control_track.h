// A recording of what a pilot did: a CSV file of "time (s),control,value (m)". It names controls,
// so that it flies other designs that have them as well.
#pragma once

#include "base/result.h"
#include "run/simulation.h"
#include "scene/scene.h"

#include <filesystem>
#include <span>
#include <vector>

namespace ripstop {

// In order of time. Controls are named by name or as #id. A first line whose time is no number is
// taken for a heading.
Result<std::vector<ControlCommand>> readControlTrack(const std::filesystem::path& file,
                                                     const Scene& scene);

// What is read again is the same to the bit.
std::optional<Failure> writeControlTrack(const Scene& scene, std::span<const ControlCommand> track,
                                         const std::filesystem::path& file);

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
