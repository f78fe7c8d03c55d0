// A recording of what a pilot and hands did: a CSV file of "time (s),control,value (m)". It names
// controls, so that it flies other designs that have them as well. Rows whose control begins with
// "@" are those of hands (hand_rows.h); files without them are what earlier versions wrote and
// read.
#pragma once

#include "base/hands.h"
#include "base/result.h"
#include "scene/scene.h"
#include "simulation/frame.h"

#include <filesystem>
#include <vector>

namespace ripstop {

class Simulation;

struct ControlTrack // both in order of time
{
    std::vector<ControlCommand> commands;
    std::vector<HandNote> hands;
};

// Controls are named by name or as #id. A first line whose time is no number is
// taken for a heading.
Result<ControlTrack> readControlTrack(const std::filesystem::path& file, const Scene& scene);

// What is read again is the same to the bit.
std::optional<Failure> writeControlTrack(const Scene& scene, const ControlTrack& track,
                                         const std::filesystem::path& file);

ControlTrack trackOf(const Frame& frame); // of the run up to then

// Does to a simulation what is in a track, as the times come.
class ControlPlayer
{
public:
    explicit ControlPlayer(ControlTrack track)
        : m_track(std::move(track))
    {}

    // Call before each step.
    void giveTo(Simulation& simulation);

private:
    ControlTrack m_track;
    std::size_t m_nextCommand = 0;
    std::size_t m_nextHand = 0;
    HandCommands m_hands; // told so far
};

} // namespace ripstop
