// Where things of a scene are in a frame.
//
// The camera fits them into the picture, and cards of probes stand beside them. A search through
// the layout costs time in proportion to its size, so this is for single questions and not for
// drawing.
#pragma once

#include "scene/scene.h"
#include "simulation/frame.h"

#include <vector>

namespace ripstop {

// Places of the elements with these ids now, m: of particles, both ends of links, all corners of
// panels. Items stand for their elements. A place comes once for each element that has it; what the
// frame does not know is left out.
std::vector<Vec3> placesOf(const Frame& frame, const Scene& scene, const std::vector<Id>& ids);

} // namespace ripstop
