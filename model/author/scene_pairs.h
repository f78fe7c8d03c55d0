// Which thing of one scene stands for which of another.
//
// Two states of one design share their ids. Designs that were made apart share names at most, and
// rows of tables that are as long are paired in their order.
#pragma once

#include "scene/scene.h"

#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace ripstop {

struct ScenePairs
{
    std::vector<std::pair<const Entry*, const Entry*>> items; // of one type; in the first's order
    std::vector<const Entry*> onlyFirst;
    std::vector<const Entry*> onlySecond;
    std::unordered_map<Id, Id> secondOf; // [items and elements of the first that have one]
    std::unordered_set<Id> unknown; // rows of the first of whose table nothing tells who is who
};

// Points into both scenes, which have to stay as they are meanwhile.
ScenePairs pairsOf(const Scene& first, const Scene& second);

} // namespace ripstop
