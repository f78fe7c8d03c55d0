// What stands in the tool bar of the window and in the strip of tools over the view. Both are
// tables of actions by their ids; a new button is a word there.
#pragma once

class QToolBar;

namespace ripstop {

class Actions;
class Viewport;

void fillToolBar(QToolBar& bar, const Actions& actions);

void addToolStrip(Viewport& viewport, const Actions& actions); // the view owns it

} // namespace ripstop
