// Parts the mesh where links or panels have torn, so that each panel stays whole on its side.
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
// A panel that carries the pull of a fabric tears across the threads that are overloaded in it: at
// one of its corners, in a plane through the particle at right angles to where these threads run
// now. The panels on its own side take the twin. The corner is chosen as the end of a link is, and
// of corners of one kind it is the one from which the panel lies most along the threads. The panel
// stays whole and holds what it held.
//
// mesh_parting.h says what becomes of what ends at the particle.
#pragma once

#include "system/system.h"

namespace ripstop {

// Adds what parts to State::splits and says whether anything does; splitSystem() and carryOver()
// then make the system and the state to go on with. For the links that tearOverloaded() has just
// noted in State::tearHolds and the panels that it has in State::panelHold; those at the particles
// that part are noted there as well.
[[nodiscard]] bool openTears(const System& system, State& state);

} // namespace ripstop
