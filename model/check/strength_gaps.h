// What carries a load and has no strength to compare it with, so that it has no margin
// (laws/load_margin.h) and nobody can say how near to breaking it is; and what has one and holds
// beyond it, since nothing says that it tears.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace ripstop {

// Materials of lines without line strength and breaking moment, and of threads or elastic panels
// without warp and weft strength, in the order of the scene; at the end noId where there are such
// elements without a material.
std::vector<Id> materialsWithoutStrength(const Scene& scene);

// Materials that are used, have a strength for what they carry and no rule by which they tear, in
// the order of the scene.
std::vector<Id> materialsThatNeverTear(const Scene& scene);

} // namespace ripstop
