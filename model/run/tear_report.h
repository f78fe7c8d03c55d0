// What a run tore, in short: how often, with how much energy, and how its front went on. Computed
// of what a frame has, on any thread.
//
// The front is measured in the design, where nothing has moved yet: it says how far the damage
// spreads on the cloth, however far that has flown or folded between two breaks.
#pragma once

#include "scene/scene.h"
#include "simulation/frame.h"

#include <functional>
#include <optional>
#include <span>

namespace ripstop {

struct TearReport
{
    struct Front
    {
        double time;     // s
        double distance; // m, in the design, between the middles of what broke first and of this
    };

    int count = 0;
    double energy = 0.0;      // J, released by all breaks
    std::vector<Front> front; // each break that was farther off than all before it, the first too
};

// Where a particle is in the design, by its id; nothing where that has none of this id any more.
using PlaceInDesign = std::function<std::optional<Vec3>(std::uint32_t)>;

PlaceInDesign placesIn(const Scene& scene); // which has to outlive it

// `tears` in order of time, of the run that the layout is of. What an edit has taken out of the
// design since takes the front no farther.
TearReport tearReport(std::span<const Tear> tears, const Layout& layout,
                      const PlaceInDesign& place);

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
