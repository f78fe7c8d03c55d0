// The mass of particles from the densities of materials.
//
// A panel gives a third of its mass to each corner, a link half of its own to each end. Particles
// carry the mass of a scene, whoever put it there; the density of a material says what of it they
// were given. So another density takes the old share off and puts the new one on, and what else a
// particle carries stays. A material of unknown density has given nothing that could be taken off.
// Where a frame weighs less than its spars, as others of its part carry some of it, these get their
// share of the change.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

namespace ripstop {

// Whether it is a density, so that another value of it weighs particles anew.
bool weighs(const Property& property);

// The edit, and with it the masses that follow from the densities that it changes from a known one
// to another. Fails where a particle would be left without mass.
Result<Edit> weighed(const Scene& scene, Edit edit);

// Weighs all that is made of materials of known density: their particles get the mass that the
// densities say in place of the one that they have. Particles of nothing else keep theirs.
Edit weighing(const Scene& scene);

} // namespace ripstop
