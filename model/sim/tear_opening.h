// Parts the mesh where links have torn, so that each panel stays whole on its side.
//
// A link tears because it is pulled along its length, so the tear opens across it: at one of its
// ends, in a plane through the particle at right angles to the link, as Mueller, Heidelberger,
// Hennix and Ratcliff 2007 cut cloth in "Position based dynamics". The panels on the side of the
// link take a twin of the particle as their corner. The link goes with them and stays whole: it has
// let go of the other side. The plane is one in the fabric: the angle from the link to the middle
// of each panel is summed over the panels between them, so that folds and creases do not matter.
//
// Which end: one where something stays behind, of these one where a tear already ends or passes, so
// that tears run on; then one on the hem; then the link's first. Where nothing would stay behind at
// either end (a crumb), the link breaks for good and the panels beside it go.
//
// What ends at the particle:
//   - edges of panels on one side alone go with these; an edge between the two sides becomes two,
//   - other links go with the panel that they leave through, or else by their direction; those that
//     held two panels together across the tear and no longer have neighbours there break,
//   - pins and hands stay with the particle.
// The mass is shared by the areas of the panels at the start; a side without panels counts as a
// mean one. Place and velocity are those of the particle, so that mass, its centre, momentum and
// energy do not change.
#pragma once

#include "sim/system.h"

namespace ripstop {

// Adds what parts to State::splits and says whether anything does; splitSystem() and carryOver()
// then make the system and the state to go on with. For the links that tearLinks() has just noted
// in State::tearHolds; those at the particles that part are noted there as well.
[[nodiscard]] bool openTears(const System& system, State& state);

} // namespace ripstop
