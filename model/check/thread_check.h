// Looks for threads of a fabric whose cells are so long that the diagonals alone resist stretching
// along them by more than the material's membrane stiffness (derived/link_stiffness.h), and for
// those of a fabric whose weft is not as stiff as its warp, which threads do not know.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkThreads(const Scene& scene, const AddFinding& add);

} // namespace ripstop
