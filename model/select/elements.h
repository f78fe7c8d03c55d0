// Which elements a selection means.
//
// A selection is a list of ids of items and elements. An item stands for its elements: a part for
// its rows, a material for what is made of it, a group for its members, a control or a probe for
// its targets.
#pragma once

#include "scene/property.h"

#include <vector>

namespace ripstop {

// The ids of the elements that a selection means, ascending and each once; colliders and the like
// that are named by a group or a control are among them.
std::vector<Id> elementsOf(const Scene& scene, const std::vector<Id>& selected);

// Elements by kind, in ascending order of id.
struct Elements
{
    std::vector<const Particle*> particles;
    std::vector<const Link*> links;
    std::vector<const Panel*> panels;

    bool empty() const { return particles.empty() && links.empty() && panels.empty(); }
    std::vector<Id> ids() const; // ascending
};

// The references hold until the scene changes.
Elements sortedElements(const Scene& scene, const std::vector<Id>& selected);
Elements everyElement(const Scene& scene);

} // namespace ripstop
