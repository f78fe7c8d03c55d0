// The parts of the Select menu that depend on the groups of the scene. The menus put them below
// the rows of that menu, one of which groups the selection.
//
// Both functions belong to the thread of the window. Changes of groups are edits of the document
// and can be undone.
#pragma once

class QMenu;

namespace ripstop {

struct Workbench;

// The menus that list the groups: select one, add to one, take away from one. They are filled when
// they open.
void addGroupMenus(QMenu& menu, const Workbench& bench);

// Asks for a name and makes a group of the selection, in one step of the history.
void groupSelection(const Workbench& bench);

} // namespace ripstop
