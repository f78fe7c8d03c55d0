// What a run tore, in short: how often, with how much energy, and how its front went on. Computed
// of what a frame has, on any thread.
#pragma once

#include "simulation/frame.h"

#include <span>

namespace ripstop {

struct TearReport
{
    struct Front
    {
        double time;     // s
        double distance; // m, from the place of the first break
    };

    int count = 0;
    double energy = 0.0;      // J, released by all breaks
    std::vector<Front> front; // each break that was farther off than all before it, the first too
};

// `tears` in order of time. Places are where the links were when they broke, so that the front of
// a sheet that flies away moves with it.
TearReport tearReport(std::span<const Tear> tears);

// Links and panels that have torn by their own load. Those at which the mesh has parted are whole
// again, and have torn all the same.
std::size_t tornElements(const Frame& frame);

// Whether a tear is of a panel, and not of a link.
bool isOfPanel(const Tear& tear, const Layout& layout);

// Whether it is of a spar that was bent too far, whose load is a moment.
bool isSnap(const Tear& tear);

// Of the load that it tore at: "N" of a link, "N/m" of a panel, "N m" of a spar that snapped.
const char* loadUnit(const Tear& tear, const Layout& layout);

} // namespace ripstop
