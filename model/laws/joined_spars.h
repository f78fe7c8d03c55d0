// Which links of spars go on into each other, and how stiffly they bend there.
//
// At each particle links of one material are paired first, the straightest pair first, and then
// those that none of their own material continues: a tapered spar, or one with a ferrule, is a row
// of links of several materials, and spars that cross stay free of each other. Of links of EI and
// EI' the halves l / 2 and l' / 2 turn by theta under the moment M:
//
//     theta = M (l / (2 EI) + l' / (2 EI'))
//
// The weaker of the two snaps.
#pragma once

#include "laws/bend.h"

#include <vector>

namespace ripstop {

// The cosine of the angle by which spars turn at most where they go on into each other, 60 degrees.
inline constexpr double leastAlongOfSpars = 0.5 - 1e-9;

// Adds the bends of spars, in ascending order of the particles that they are at.
void addSparBends(const BendingNet& net, std::vector<Bend>& bends);

} // namespace ripstop
