#include "overlays/caption.h"

#include <QPaintDevice>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double offset = 18.0;   // pixels, from the cursor
constexpr double cardInset = 6.0; // pixels, of the text on its card
constexpr double coil = 5.0;      // pixels, half the width of the spring
constexpr int turns = 12;

} // namespace

void paintCaption(QPainter& painter, const Theme& theme, QPointF place, const QString& text)
{
    const QRectF words = painter.fontMetrics().boundingRect(text);
    QRectF card(place.x() + offset, place.y() + offset, words.width() + 2.0 * cardInset,
                words.height() + 2.0 * cardInset);
    const QRectF picture = QRectF(painter.window()).adjusted(4.0, 4.0, -4.0, -4.0);
    if (card.right() > picture.right())
        card.moveRight(place.x() - offset);
    if (card.bottom() > picture.bottom())
        card.moveBottom(place.y() - offset);
    card.moveLeft(std::max(card.left(), picture.left()));
    card.moveTop(std::max(card.top(), picture.top()));
    QColor ground = theme.card;
    ground.setAlphaF(0.9F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(card, 5.0, 5.0);
    painter.setPen(theme.text);
    painter.drawText(card, Qt::AlignCenter, text);
}

void paintSpring(QPainter& painter, const Theme& theme, QPointF from, QPointF to)
{
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    QPainterPath path(from);
    if (length > 4.0 * coil) {
        const QPointF along = way / length, across(-along.y(), along.x());
        for (int i = 0; i < turns; ++i)
            path.lineTo(from + along * (length * (i + 1.5) / (turns + 2))
                        + across * (i % 2 == 0 ? coil : -coil));
    }
    path.lineTo(to);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(theme.card, 4.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
                            QPen(theme.accent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)}) {
        painter.setPen(pen);
        painter.drawPath(path);
        painter.drawEllipse(from, 5.0, 5.0);
    }
}

} // namespace ripstop
