// A frame of a design that nobody has simulated.
//
// Views know nothing but frames. This makes one from a scene alone, for a scene that has not been
// compiled yet or cannot be: a half-finished network without masses must be visible too. The ghost
// of the design and dialogs use it as well.
#pragma once

#include "scene/scene.h"
#include "simulation/frame.h"

#include <memory>

namespace ripstop {

// The design as a frame at rest: everything is where the author put it, links strain as they are
// drawn, and tensions and loads are zero. Links and panels with ends that do not exist are left
// out. Time, step and run are 0; the wind is the mean wind at the middle of the design, m/s.
std::shared_ptr<const Frame> sceneFrame(const Scene& scene);

// Whether a scene has no part and no collider, so that there is nothing to be seen.
bool hasNothing(const Scene& scene);

} // namespace ripstop
