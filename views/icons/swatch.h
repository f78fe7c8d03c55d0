// A small square of one colour, for materials and curves in lists.
//
// Icons are made once per colour and kept for the life of the program. As all painting of pixmaps
// it belongs to the thread of the window.
#pragma once

#include <QColor>
#include <QIcon>

namespace ripstop {

// The square in this colour, which it also keeps in a selected row.
QIcon swatch(const QColor& color);

} // namespace ripstop
