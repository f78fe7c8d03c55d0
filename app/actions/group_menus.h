#pragma once

#include "actions/actions.h"

namespace ripstop {

// The parts of the Select menu that list the groups of the scene: select one, add to one, take away
// from one. They are filled when they open.
void addGroupMenus(QMenu& menu, const Workbench& bench);

// Asks for a name and makes a group of the selection, in one step of the history.
void groupSelection(const Workbench& bench);

} // namespace ripstop
