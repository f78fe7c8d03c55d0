// Holds particles in place, along a line or in a plane, or lets them go. The operation "guide" and
// the design menu make their edits here. Axes may have any length but 0 and lie in the frame of
// the scene.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

namespace ripstop {

// True when all particles that are meant (see movable.h) are pinned.
bool allPinned(const Scene& scene, const std::vector<Id>& ids);

// Pins the particles that are meant, or unpins them; empty where there are none.
Edit pinning(const Scene& scene, const std::vector<Id>& ids, bool pinned);

// Frees the particles along a line through each of them, or in a plane; pins go. With Guide::None
// nothing holds them any more.
Edit guiding(const Scene& scene, const std::vector<Id>& ids, Guide guide, const Vec3& axis);

// The direction of the line that fits the places of what is selected best, as that through two
// particles, or the one across the plane that does, as that through three. Fails with a sentence
// that says what to select.
Result<Vec3> axisThrough(const Scene& scene, const std::vector<Id>& ids, Guide guide);

} // namespace ripstop
