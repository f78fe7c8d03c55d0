// What tools write and draw over the picture beside the cursor.
//
// Tools call these from their paint function, with the painter of the surface that lies over the
// view; places are pixels of that surface. Nothing is kept between two pictures.
#pragma once

#include "look/theme.h"

#include <QPointF>
#include <QString>

class QPainter;

namespace ripstop {

// Writes the text on a card to the lower right of a place, kept inside the picture.
void paintCaption(QPainter& painter, const Theme& theme, QPointF place, const QString& text);

// Draws a coil from one place to another, with a ring at its first end.
void paintSpring(QPainter& painter, const Theme& theme, QPointF from, QPointF to);

} // namespace ripstop
