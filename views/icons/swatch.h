#pragma once

#include <QColor>
#include <QIcon>

namespace ripstop {

// A small square of one colour, for materials.
QIcon swatch(const QColor& color);

} // namespace ripstop
