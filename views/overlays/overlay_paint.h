#pragma once

#include <QImage>
#include <QSize>

#include <initializer_list>

class QWidget;

namespace ripstop {

// Paints the overlays that are not hidden over a picture of a view of this size, as large as they
// are for the height of the picture; those of its right half keep their distance from the right
// edge.
void paintOver(QImage& picture, std::initializer_list<QWidget*> overlays, QSize view);

} // namespace ripstop
