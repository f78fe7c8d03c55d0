#pragma once

#include "camera/camera.h"

class QWidget;

namespace ripstop {

// What its tools and its legend cover of a view: children that hang along its left or right side
// from near the top, over more than a third of its height.
OverlayMargins overlayMarginsOf(const QWidget& view);

} // namespace ripstop
