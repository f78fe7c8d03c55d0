#pragma once

#include "run/frame.h"
#include "scene/scene.h"

#include <memory>

namespace ripstop {

// The design itself as a frame at rest, for a scene that has not been compiled yet or cannot be:
// a half-finished network without masses must be visible too. Links strain as they are drawn;
// nothing moves, pulls or is loaded.
std::shared_ptr<const Frame> sceneFrame(const Scene& scene);

} // namespace ripstop
