// The letters that choose an entry of an open menu.
//
// The menus call this once for the menu bar; it changes the texts of actions only, and has to run
// on the thread of the window.
#pragma once

#include <QList>

class QAction;

namespace ripstop {

// Each entry gets a letter of its own. One that its text asks for ("&Open") is kept by the first
// entry that does; the others get the first letter of a word that is free, or any letter of theirs
// that is, or none. Translations and names of files need not agree on letters, therefore.
void giveMnemonics(const QList<QAction*>& entries);

// Does so for the menus among the entries, and for those in them, whenever one opens, after what
// was connected earlier has filled it.
void keepMnemonics(const QList<QAction*>& entries);

} // namespace ripstop
