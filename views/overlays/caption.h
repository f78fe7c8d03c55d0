// What tools write and draw over the picture beside the cursor.
//
// Tools call these from their paint function, with the painter of the surface that lies over the
// view; places are pixels of that surface. Legend and bars lie over it, so that words beside the
// cursor have to keep out of their way. Nothing is kept between two pictures.
#pragma once

#include "look/theme.h"

#include <QPointF>
#include <QRect>
#include <QString>

#include <span>

class QPainter;

namespace ripstop {

// Where a card of this size stands beside a place: to its lower right, or at the next of its other
// sides where the card is in the picture and touches nothing that is covered. Where all four sides
// are taken, it is as at the first one, inside the picture.
QRectF captionPlace(const QSizeF& size, QPointF place, const QRectF& picture,
                    std::span<const QRect> covered);

// Writes the text on a card beside a place.
void paintCaption(QPainter& painter, const Theme& theme, QPointF place, const QString& text,
                  std::span<const QRect> covered);

// Draws a coil from one place to another, with a ring at its first end.
void paintSpring(QPainter& painter, const Theme& theme, QPointF from, QPointF to);

} // namespace ripstop
