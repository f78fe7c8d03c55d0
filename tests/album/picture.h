// The picture of a window together with everything that is open over it, placed as it lies on the
// screen. A thin line stands where a desktop would draw a frame. It grabs widgets, so it needs a
// window that is shown, and runs on the thread of the window. The album and the pictures of the
// manual are made by it.
#pragma once

#include <QImage>

class QWidget;

namespace ripstop {

// The window with what is open over it, as it lies on the screen. A thin line is where a desktop
// would draw a frame.
QImage pictureOf(QWidget& window);

} // namespace ripstop
