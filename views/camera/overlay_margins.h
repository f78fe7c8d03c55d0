// How much of a view the widgets over it cover.
//
// The camera fits a design into the part of the picture that is free (Camera::fit()), so it has to
// know what tools and legend take away; and what tools write into the picture has to stand beside
// them. Both are read from the children of the view as they lie at the moment; nothing is kept.
// It is called in the thread of the window, as all that reads widgets.
#pragma once

#include "camera/camera.h"

#include <QRect>

#include <vector>

class QWidget;

namespace ripstop {

// Where the visible children of the view stand over the picture, pixels: all but those that fill
// the view, which are the picture and what is drawn on it.
std::vector<QRect> overlaysOf(const QWidget& view);

// Shares of the width and the height of the view, 0 .. 0.3 each, that visible children cover on its
// left and right side and at its lower edge. At the sides count tall, narrow children: from the top
// third of the view on, no wider than a third of it, and higher than that or than they are wide, as
// the legend of colours is, which is no higher in a large view. Below count
// bars: in the lower third, wider than a third of the view and than twice their height. The margin
// at the top is always 0.
OverlayMargins overlayMarginsOf(const QWidget& view);

} // namespace ripstop
