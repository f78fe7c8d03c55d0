// Paints widgets that lie over a view into a picture of it.
//
// A picture that is saved has another size than the view, so the overlays are scaled with its
// height and those on the right are moved to its right edge. It is for the thread of the window, as
// it renders widgets.
#pragma once

#include <QSize>

#include <initializer_list>

class QPainter;
class QWidget;

namespace ripstop {

// Paints the overlays that are not hidden over a picture of a view of this size (pixels of the
// view). They are as large in it as they are for the height of the view; those of its right half
// keep their distance from the right edge. On pages that hold text they stay text.
void paintOver(QPainter& painter, QSize picture, std::initializer_list<QWidget*> overlays,
               QSize view);

} // namespace ripstop
