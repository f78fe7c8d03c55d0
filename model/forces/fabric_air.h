// All that the air does to fabric: plates (panel_load.h), wings (wing_load.h) and air that is held
// (canopy_air.h).
#pragma once

#include "forces/wing_load.h"
#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>

namespace ripstop {

// Load of every panel, N, zero where it is gone.
//   wings  scratch
//   load   [panels]  N
void fillFabricLoads(const System& system, const State& state, ThreadPool& pool, WingLoads& wings,
                     std::span<PaddedVec3> load);

} // namespace ripstop
