// Where a dialog opens that one looks past: at the upper right of the window, below the tool bar,
// beside the design and not on it.
#pragma once

class QWidget;

namespace ripstop {

void moveBesideDesign(QWidget& dialog, const QWidget* window); // nothing without a window

} // namespace ripstop
