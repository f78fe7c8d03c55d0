// How much of a view the widgets over it cover.
//
// The camera fits a design into the part of the picture that is free (Camera::fit()), so it has to
// know what tools and legend take away. The margins are read from the children of the view as they
// lie at the moment; nothing is kept. It is called in the thread of the window, as all that reads
// widgets.
#pragma once

#include "camera/camera.h"

class QWidget;

namespace ripstop {

// Shares of the width and the height of the view, 0 .. 0.3 each, that visible children cover on its
// left and right side and at its lower edge. At the sides count tall, narrow children: from the top
// third of the view on, no wider than a third of it, and higher than that or than they are wide, as
// the legend of colours is, which is no higher in a large view. Below count
// bars: in the lower third, wider than a third of the view and than twice their height. The margin
// at the top is always 0.
OverlayMargins overlayMarginsOf(const QWidget& view);

} // namespace ripstop
