// Makes several links of one.
//
// The pieces together are what the link was: as long, and as stiff, because springs and rods in a
// row share the stretch (n springs of n k in a row are one of k; n rods of compliance c / n are one
// of c). A tear limit that is a length or an elongation is shared out too; strain and force are
// not. Where the material tells its linear density, the mass of the line moves from its ends to the
// new particles and the total stays.
#pragma once

#include "scene/edit.h"

namespace ripstop {

struct LinksSplit
{
    Edit edit;
    std::vector<Id> made;  // the new particles, ascending
    std::size_t links = 0; // that were split
};

// Each selected link becomes `count`, 2 or more. A panel that has it as a side is split with it,
// into a fan from the opposite corner. `mass` kg is that of each new particle of other materials.
LinksSplit linksSplit(const Scene& scene, const std::vector<Id>& ids, int count, double mass);

} // namespace ripstop
