// Forces of bending (base/bend.h): a bend with the turn y = sum of w x has the moment
// z = sum of C y over the bends of its panels, and each of its particles is pulled by -w z. As
// C is symmetric and the weights sum to zero, the forces have neither a sum nor a torque.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>

namespace ripstop {

// Fills `turn`, m, and `moment`, N, for the bends that are forces; both are zero where a panel or
// link of the bend is gone.
//   turn, moment  [BendLists::forces()]
void fillBends(const System& system, const State& state, ThreadPool& pool,
               std::span<PaddedVec3> turn, std::span<PaddedVec3> moment);

double bendingEnergy(const System& system, const State& state); // J, of all bends

} // namespace ripstop
