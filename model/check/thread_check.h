// Looks for threads that are not the fabric that their material says: of cells so long that the
// diagonals alone resist stretching along them by more than the membrane stiffness
// (derived/link_stiffness.h), of a mesh whose threads are no lines along warp and weft
// (derived/lattice_stiffness.h), and of a fabric whose weft is not as stiff as its warp, which
// threads do not know.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkThreads(const Scene& scene, const AddFinding& add);

} // namespace ripstop
