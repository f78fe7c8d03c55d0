#pragma once

#include "run/frame.h"
#include "scene/scene.h"

#include <vector>

namespace ripstop {

// Where the elements of these ids are now, m: particles, both ends of links, corners of panels.
// Items stand for their elements.
std::vector<Vec3> placesOf(const Frame& frame, const Scene& scene, const std::vector<Id>& ids);

} // namespace ripstop
