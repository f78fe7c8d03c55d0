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

QRectF captionPlace(const QSizeF& size, QPointF place, const QRectF& picture,
                    std::span<const QRect> covered)
{
    const QRectF first(place + QPointF(offset, offset), size);
    for (const bool isAbove : {false, true})
        for (const bool isLeft : {false, true}) {
            QRectF card = first;
            if (isLeft)
                card.moveRight(place.x() - offset);
            if (isAbove)
                card.moveBottom(place.y() - offset);
            if (picture.contains(card) && std::ranges::none_of(covered, [&](const QRect& other) {
                    return card.intersects(other);
                }))
                return card;
        }
    QRectF card = first;
    card.moveLeft(std::max(std::min(card.left(), picture.right() - card.width()), picture.left()));
    card.moveTop(std::max(std::min(card.top(), picture.bottom() - card.height()), picture.top()));
    return card;
}

void paintCaption(QPainter& painter, const Theme& theme, QPointF place, const QString& text,
                  std::span<const QRect> covered)
{
    const QSizeF inset(2.0 * cardInset, 2.0 * cardInset);
    const QRectF picture = QRectF(painter.window()).adjusted(4.0, 4.0, -4.0, -4.0);
    const QRectF card = captionPlace(painter.fontMetrics().boundingRect(text).size() + inset, place,
                                     picture, covered);
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
