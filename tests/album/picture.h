#pragma once

#include <QImage>

class QWidget;

namespace ripstop {

// The window with what is open over it, as it lies on the screen. A thin line is where a desktop
// would draw a frame.
QImage pictureOf(QWidget& window);

} // namespace ripstop
