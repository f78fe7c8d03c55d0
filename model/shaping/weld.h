// Makes one particle of several.
//
// The one with the lowest number stays. It gets the mass of all, is pinned when one of them was,
// keeps to the first guide among them, and takes over their links, panels, groups, controls and
// probes. Links between two that become one go, and panels that lose a corner; of links that become
// alike (the same ends, kind and material) and of panels with the same corners the first stays.
#pragma once

#include "scene/edit.h"

namespace ripstop {

enum class WeldAt { Middle, First };

struct Weld
{
    Edit edit;              // empty when nothing is near enough
    std::vector<Id> kept;   // what others were welded into, ascending
    std::size_t merged = 0; // particles that went
    std::size_t links = 0;  // that went with them
    std::size_t panels = 0; // that went with them
};

// All particles that are meant (see movable.h) become one.
Weld welded(const Scene& scene, const std::vector<Id>& ids, WeldAt at);

// Those become one that are nearer to each other than `distance` m, also by a chain of others.
Weld weldedWithin(const Scene& scene, const std::vector<Id>& ids, double distance, WeldAt at);

} // namespace ripstop
