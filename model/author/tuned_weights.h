// Masses of what a builder makes, of the densities that its materials have by now.
//
// A builder weighs its particles by the materials that it was told. When a material of the part has
// been exchanged since, for a heavier line of the library, say, the particles of the scene weigh
// what that one does, and a part that is built again shall, too: an exchanged material is neither
// work of hands that is lost nor taken back in silence.
#pragma once

#include "author/counterparts.h"

namespace ripstop {

// `before` is as the builder made the part, with its counterparts in the scene. `built` is that, or
// as the builder makes it now: where the scene has another density than `before`, it gets this one
// and the masses that follow, unless the builder itself has another one now.
void weighAsTuned(const Scene& scene, const Counterparts& counterparts, const Scene& before,
                  Scene& built);

} // namespace ripstop
