// The pictures of words.h: files where they exist, painted glyphs where they do not.
#include "document/words.h"

#include <QFile>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace ripstop {
namespace {

constexpr double size = 16.0; // px, of the grid that glyphs are drawn on

// Middle tones that stand out on light and on dark.
const QColor blue(0x3d, 0x8b, 0xd4);
const QColor orange(0xd9, 0x7b, 0x2c);
const QColor green(0x4c, 0xa8, 0x5a);
const QColor violet(0x92, 0x6d, 0xc9);
const QColor grey(0x8a, 0x90, 0x96);

void paintSettings(QPainter& p)
{
    p.setPen(QPen(grey, 1.6));
    for (const double y : {4.0, 8.0, 12.0})
        p.drawLine(QPointF(2, y), QPointF(14, y));
    p.setPen(Qt::NoPen);
    p.setBrush(grey);
    p.drawEllipse(QPointF(10.5, 4), 2, 2);
    p.drawEllipse(QPointF(5.5, 8), 2, 2);
    p.drawEllipse(QPointF(9, 12), 2, 2);
}

void paintParticle(QPainter& p)
{
    p.setPen(Qt::NoPen);
    p.setBrush(blue);
    p.drawEllipse(QPointF(8, 8), 3.5, 3.5);
}

void paintLink(QPainter& p)
{
    p.setPen(QPen(orange, 1.8));
    p.drawLine(QPointF(4, 12), QPointF(12, 4));
    p.setPen(Qt::NoPen);
    p.setBrush(orange);
    p.drawEllipse(QPointF(3.5, 12.5), 2.2, 2.2);
    p.drawEllipse(QPointF(12.5, 3.5), 2.2, 2.2);
}

void paintPanel(QPainter& p)
{
    p.setPen(Qt::NoPen);
    p.setBrush(green);
    p.drawPolygon(QPolygonF({{2, 13}, {8, 2.5}, {14, 13}}));
}

void paintPart(QPainter& p)
{
    // a kite
    p.setPen(QPen(blue, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.setBrush(QColor(blue.red(), blue.green(), blue.blue(), 90));
    p.drawPolygon(QPolygonF({{8, 1.5}, {13, 6.5}, {8, 14.5}, {3, 6.5}}));
    p.drawLine(QPointF(8, 1.5), QPointF(8, 14.5));
    p.drawLine(QPointF(3, 6.5), QPointF(13, 6.5));
}

void paintMaterial(QPainter& p)
{
    p.setPen(Qt::NoPen);
    p.setBrush(orange);
    p.drawRoundedRect(QRectF(2, 2, 12, 12), 2.5, 2.5);
    p.setBrush(QColor(255, 255, 255, 90));
    p.drawRect(QRectF(2, 5, 12, 2));
    p.drawRect(QRectF(2, 9.5, 12, 2));
}

void paintGroup(QPainter& p)
{
    p.setPen(QPen(violet, 1.4, Qt::DashLine));
    p.drawRoundedRect(QRectF(1.5, 1.5, 13, 13), 3, 3);
    p.setPen(Qt::NoPen);
    p.setBrush(violet);
    p.drawEllipse(QPointF(5.5, 10), 1.8, 1.8);
    p.drawEllipse(QPointF(10.5, 10), 1.8, 1.8);
    p.drawEllipse(QPointF(8, 5.5), 1.8, 1.8);
}

void paintCollider(QPainter& p)
{
    p.setPen(QPen(grey, 1.6));
    p.drawLine(QPointF(1, 13.5), QPointF(15, 13.5));
    p.setPen(Qt::NoPen);
    p.setBrush(grey);
    p.drawEllipse(QPointF(8, 8), 4.5, 4.5);
}

void paintWind(QPainter& p)
{
    p.setPen(QPen(blue, 1.6, Qt::SolidLine, Qt::RoundCap));
    QPainterPath path(QPointF(1.5, 6.5));
    path.lineTo(9.5, 6.5);
    path.cubicTo(13, 6.5, 13, 2, 10, 2);
    path.moveTo(1.5, 9.5);
    path.lineTo(11.5, 9.5);
    path.cubicTo(15, 9.5, 15, 14, 12, 14);
    path.moveTo(3, 12.5);
    path.lineTo(7.5, 12.5);
    p.drawPath(path);
}

void paintControl(QPainter& p)
{
    p.setPen(QPen(green, 1.4));
    p.drawRoundedRect(QRectF(1.5, 4, 13, 9), 2, 2);
    p.setPen(Qt::NoPen);
    p.setBrush(green);
    p.drawPolygon(QPolygonF({{3.5, 8.5}, {6.5, 6}, {6.5, 11}}));
    p.drawPolygon(QPolygonF({{12.5, 8.5}, {9.5, 6}, {9.5, 11}}));
}

void paintProbe(QPainter& p)
{
    p.setPen(QPen(grey, 1.2));
    p.drawPolyline(QPolygonF({{1.5, 1.5}, {1.5, 14.5}, {14.5, 14.5}}));
    p.setPen(QPen(violet, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.drawPolyline(QPolygonF({{3.5, 11}, {6.5, 6}, {9.5, 9}, {13.5, 3}}));
}

using Paint = void (*)(QPainter&);
constexpr std::array<Paint, kindCount> glyphs{
    paintSettings, paintParticle, paintLink, paintPanel,   paintPart, paintMaterial,
    paintGroup,    paintCollider, paintWind, paintControl, paintProbe};

template <typename Painting>
QIcon painted(Painting painting)
{
    constexpr double scale = 2.0; // sharp on dense screens
    QPixmap pixmap(int(size * scale), int(size * scale));
    pixmap.fill(Qt::transparent);
    pixmap.setDevicePixelRatio(scale);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painting(painter);
    painter.end();
    return QIcon(pixmap);
}

} // namespace

QIcon iconOf(Kind kind)
{
    const QString name = QString::fromUtf8(kindName(kind).data());
    const QString file = QStringLiteral(":/icons/%1.svg").arg(name);
    return QFile::exists(file) ? QIcon(file) : painted(glyphs[std::size_t(kind)]);
}

QIcon colorIcon(const QString& color)
{
    return painted([&](QPainter& painter) {
        painter.setPen(QPen(QColor(128, 128, 128, 160), 1.0));
        painter.setBrush(QColor(color));
        painter.drawRoundedRect(QRectF(2, 2, 12, 12), 2.5, 2.5);
    });
}

} // namespace ripstop
