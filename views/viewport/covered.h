#pragma once

#include "viewport/turntable.h"

class QWidget;

namespace ripstop {

// What its tools and its legend cover of a view: children that stand along its left or right side
// over more than a third of its height.
Covered coveredOf(const QWidget& view);

} // namespace ripstop
