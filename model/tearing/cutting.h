// Cuts through links and fabric along a stroke, between two steps.
//
// Between two points of its stroke the knife is flat. A link that it crosses breaks, unless it is
// the edge of panels. Through those the cut follows the mesh: a panel that the knife crosses goes
// with the side that its middle lies on, so that one stroke goes on where another ended; particles
// where panels of both sides meet are parted (mesh_parting.h). So every panel stays whole, and
// mass, its centre and momentum do not change. Where tears make panels vanish (TearMesh::Vanish),
// the links break and the panels beside them go, as by a tear. Every link that is crossed is noted
// in State::tears.
#pragma once

#include "system/system.h"

namespace ripstop {

// Says whether the mesh has parted: State::splits has grown then, and splitSystem() and carryOver()
// make the system and the state to go on with.
[[nodiscard]] bool cutAlong(const System& system, State& state, const Cut& cut);

} // namespace ripstop
