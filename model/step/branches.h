// Rods as branches of trees, and what hangs beyond each: a bound for how slowly a network swings.
//
// A tree spans what rods and panels that carry a pull join, rods that never stretch before others
// and panels last, so that what gives way is left over where a loop closes. It grows from what
// bears, which is one for all, or where nothing does, from the particle with the lowest number.
// Whatever is left over stiffens the network: it swings no more slowly than its trees.
#pragma once

#include "system/system.h"

#include <vector>

namespace ripstop {

// Pinned, or on a guide, which bears a load as a pin does.
bool bears(const System& system, int particle);

constexpr int noRod = -1; // the side of a panel

struct Branch
{
    int rod = noRod;
    int tree = 0;            // the particle where it begins, the first beyond what bears
    double massBeyond = 0.0; // kg, of the particles that it joins to the root
};

// In the order from roots to tips.
std::vector<Branch> branchesOf(const System& system);

} // namespace ripstop
