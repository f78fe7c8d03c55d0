// Contact of particles with planes and spheres.
//
// A particle that is inside is put back on the surface by the shortest way; the responses differ in
// what is left of its velocity:
//     stop     nothing
//     slide    all but the part that goes inwards
//     contact  the inward part comes back times the restitution, and Coulomb friction takes from
//              the rest up to friction x (normal impulse)
#pragma once

#include "sim/crew.h"
#include "sim/system.h"

#include <span>

namespace ripstop {

// `h` is the substep, s: an impact that is slower than what gravity adds in two substeps counts as
// rest and does not bounce.
//   before  [particles]  m, position at the start of the substep
void resolveContacts(const System& system, State& state, std::span<const PaddedVec3> before,
                     double h, Crew& crew);

} // namespace ripstop
