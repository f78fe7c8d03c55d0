#pragma once

#include "viewport/turntable.h"

class QWidget;

namespace ripstop {

// What its tools and its legend cover of a view: children that hang along its left or right side
// from near the top, over more than a third of its height.
Covered coveredOf(const QWidget& view);

} // namespace ripstop
