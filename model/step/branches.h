// Rods as branches of trees, and what hangs beyond each: a bound for how slowly a network swings.
//
// A tree spans what rods join, rods that never stretch before others, so that those that give way
// are left over where a loop closes. It grows from what bears, which is one for all, or where
// nothing does, from the particle with the lowest number. Whatever is left over stiffens the
// network: it swings no more slowly than its trees.
#pragma once

#include "system/system.h"

#include <vector>

namespace ripstop {

// Pinned, or on a guide, which bears a load as a pin does.
bool bears(const System& system, int particle);

struct Branch
{
    int rod = 0;
    int tree = 0;            // the particle where it begins, the first beyond what bears
    double massBeyond = 0.0; // kg, of the particles that it joins to the root
};

// In the order from roots to tips.
std::vector<Branch> branchesOf(const System& system);

} // namespace ripstop
