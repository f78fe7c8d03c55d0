// Forces of bending (laws/bend.h): the slope of its energy, to the bit of rounding. As that does
// not change where all moves or turns together, the forces have neither a sum nor a torque.
#pragma once

#include "laws/fabric_bending.h"
#include "parallel/thread_pool.h"
#include "system/system.h"

#include <array>
#include <vector>

namespace ripstop {

// What the bends that are forces are between; all of it is filled anew each time.
struct BendScratch
{
    FabricBending fabric;
    std::vector<PaddedVec3> load; // [BendLists::pullingPanels(), then spars()] N, three each

    void size(const BendLists& bends);
};

// From the particle of a spar to the outer ends of its links, m.
std::array<Vec3, 2> waysOf(const Bend& spar, const State& state);

// Whether one of the two links has torn, so that nothing bends there any more.
bool isCut(const System& system, const State& state, const Bend& spar);

// Fills `bends`, sized for the system, for the positions of the state. Loads are zero where a
// panel, or a link of the spar, is gone.
void fillBends(const System& system, const State& state, ThreadPool& pool, BendScratch& bends);

// N, on the particle of a spar and on the outer ends of its links; 0 where one of these has torn.
std::array<Vec3, 3> pullsOfSpar(const System& system, const State& state, const Bend& spar);

// N m, of a spar at the particle that its two links share; 0 where one of them has torn.
double bendingMoment(const System& system, const State& state, const Bend& spar);

double bendingEnergy(const System& system, const State& state); // J, of all bends

// [particles] N, of all bends: also of those of spars that are solved with their rods.
std::vector<Vec3> pullsOfBends(const System& system, const State& state);

} // namespace ripstop
