// Holds particles in place, or lets them go.
#pragma once

#include "scene/edit.h"

namespace ripstop {

// True when all particles that are meant (see movable.h) are pinned.
bool allPinned(const Scene& scene, const std::vector<Id>& ids);

Edit pinning(const Scene& scene, const std::vector<Id>& ids, bool pinned);

} // namespace ripstop
