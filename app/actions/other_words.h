// What people who come from other programs call an action, so that the search finds it by their
// words, too: who knows Blender or ParaView looks for a zoom or a screenshot.
//
// They are no names: nothing shows them. The table is in the source, by the ids of the actions and,
// with "dock." before it, by the name of a panel's dock.
#pragma once

#include <QString>

namespace ripstop {

// In the language of the window, with blanks between them; empty where there are none.
QString otherWords(const QString& id);

} // namespace ripstop
