// What carries a load and has no strength to compare it with, so that it has no margin
// (laws/load_margin.h) and nobody can say how near to breaking it is; and what has one and holds
// beyond it, since nothing says that it tears. And whether margins are known to be too good.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace ripstop {

// Materials of lines without line strength and breaking moment that do not tear by a force either,
// and of threads or elastic panels without warp and weft strength that do not by a tension, in the
// order of the scene; at the end noId where there are such
// elements without a material.
std::vector<Id> materialsWithoutStrength(const Scene& scene);

// Materials that are used, have a strength for what they carry and no rule by which they tear, in
// the order of the scene.
std::vector<Id> materialsThatNeverTear(const Scene& scene);

// A canopy that the air opens (canopyPressure) has opening loads of 0.6 to 0.7 of those measured:
// 0.67 of what drag area over time gives for a C-9 with 100 kg at 60 m/s, and 1.05 of the steady
// load where it does not slow down, of 1.7 (Knacke 1991, table 5-1). This safety factor makes up
// for it.
inline constexpr double openingSafetyFactor = 1.7;

// Whether margins of the scene are of such loads, and of a lower factor.
bool understatesOpening(const Scene& scene);

} // namespace ripstop
