// Which designs and moments the window is shown in for the album, and what can be wrong with a
// window by rule (text that is cut off, inputs without a name, dialogs larger than 1280 x 800).
//
// album.cpp is built on this. All of it runs on the thread of the window.
#pragma once

#include "album/window_walk.h"

namespace ripstop {

void prepareViews(); // has to be called before the application exists

// Everything that the window can show: the start page, an empty scene, a kite at rest and in
// flight, a scene with faults, each with every panel; all menus, actions and tools; and what comes
// by itself.
void showEverything(WindowShop& shop, const WindowWalk::Look& look);

// All that the panel of studies shows, of a kite in gusts.
void showStudies(WindowShop& shop, const WindowWalk::Look& look);

// Says what is cut off, has no name for those who do not see it, or does not fit on the screen.
QStringList faultsOf(const QWidget& window);

} // namespace ripstop
