// What tools write and draw over the picture beside the cursor.
#pragma once

#include "look/theme.h"

#include <QPointF>
#include <QString>

class QPainter;

namespace ripstop {

// On a card to the lower right of a place, kept inside the picture.
void paintCaption(QPainter& painter, const Theme& theme, QPointF place, const QString& text);

// A coil from one place to another, with a ring at its first end.
void paintSpring(QPainter& painter, const Theme& theme, QPointF from, QPointF to);

} // namespace ripstop
