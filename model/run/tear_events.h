// The breaks of a run as events: breaks that are neighbours in the mesh and in time are one.
//
// Two breaks are neighbours when their links or panels share a particle or one link or panel is
// between them, wherever they have flown since: a mesh that splits opens at every second panel.
// And the later one comes within `pause` of the earlier one: a tear that rests longer has stopped,
// and what goes on there is another event. So a seam that opens panel by panel is one
// event, and so is a line that parts in several links at once; what tears at the other end of a
// craft is another. Computed of what a frame has, on any thread.
#pragma once

#include "simulation/frame.h"

#include <span>
#include <vector>

namespace ripstop {

struct TearEvent
{
    static constexpr double pause = 0.1; // s

    double begin = 0.0; // s
    double end = 0.0;   // s, of its last break
    int count = 0;
    double energy = 0.0;       // J, released by all of them
    std::uint32_t first = 0;   // element that broke first
    Vec3 place = Vec3::Zero(); // m, where that was

    friend bool operator==(const TearEvent&, const TearEvent&) = default;
};

struct TearEvents
{
    std::vector<TearEvent> all;  // in order of their begin
    std::vector<std::size_t> of; // [tears] index of the event of each break
};

// `tears` in order of time, of the run that the layout is of. What an edit has taken out of the
// design since is next to nothing.
TearEvents tearEvents(std::span<const Tear> tears, const Layout& layout);

} // namespace ripstop
