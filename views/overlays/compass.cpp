// Directions become pixels by onScreen(), without perspective, along the axes of the camera. The
// ring is painted first; the axes follow from back to front; the wind lies over both. A wind that
// is seen end on has no length to draw and becomes a circle, with a dot when it comes towards the
// eye. Its words and those of the squares stand below.
#include "overlays/compass.h"

#include "document/spoken.h"

#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr int side = 132;      // pixels
constexpr double reach = 46.0; // pixels, radius of the ring
constexpr int textHeight = 20; // pixels, of each line below the ring

struct Axis
{
    Vec3 direction;
    const char* name;
    QColor color;
};

} // namespace

Compass::Compass(QWidget* parent)
    : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    resize(side, side + 2 * textHeight - 4);
}

void Compass::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void Compass::setCamera(const Camera& camera)
{
    if (camera.azimuth != m_camera.azimuth || camera.elevation != m_camera.elevation)
        update();
    m_camera = camera;
}

void Compass::setWind(const Vec3& velocity)
{
    if (velocity != m_wind)
        update();
    m_wind = velocity;
}

void Compass::setWindShown(bool shown)
{
    m_windShown = shown;
    update();
}

void Compass::setSquares(double metres)
{
    if (metres != m_squares)
        update();
    m_squares = metres;
}

QPointF Compass::onScreen(const Vec3& direction) const
{
    return QPointF(0.5 * side, 0.5 * side)
           + reach * QPointF(direction.dot(m_camera.right()), -direction.dot(m_camera.up()));
}

void Compass::paintRing(QPainter& painter) const
{
    QPainterPath ring;
    constexpr int points = 72;
    for (int i = 0; i <= points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points;
        const QPointF at = onScreen(Vec3(std::cos(angle), 0.0, std::sin(angle)));
        i == 0 ? ring.moveTo(at) : ring.lineTo(at);
    }
    QColor fill = m_theme.card;
    painter.setPen(QPen(m_theme.groundLine, 1.2));
    painter.setBrush(fill);
    painter.drawPath(ring);
}

void Compass::paintAxes(QPainter& painter) const
{
    std::array axes{Axis{Vec3::UnitX(), "x", m_theme.axis(0)},
                    Axis{Vec3::UnitY(), "y", m_theme.axis(1)},
                    Axis{Vec3::UnitZ(), "z", m_theme.axis(2)}};
    std::ranges::sort(axes, {}, [this](const Axis& a) { return a.direction.dot(m_camera.back()); });
    for (const Axis& axis : axes) {
        const QPointF tip = onScreen(0.72 * axis.direction);
        painter.setPen(QPen(axis.color, 2.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(onScreen(Vec3::Zero()), tip);
        const QPointF label = onScreen(0.92 * axis.direction);
        painter.drawText(QRectF(label.x() - 8, label.y() - 8, 16, 16), Qt::AlignCenter, axis.name);
    }
}

void Compass::paintWind(QPainter& painter) const
{
    const double speed = m_wind.norm();
    if (speed == 0.0)
        return;

    // The arrow runs from the upwind edge of the ring to the lee edge.
    const Vec3 direction = m_wind / speed;
    const QPointF tail = onScreen(-0.98 * direction), tip = onScreen(0.98 * direction);
    const QPointF along = tip - tail;
    const double length = std::hypot(along.x(), along.y());
    if (length < 6.0) { // seen end on: a circle, with a dot when the wind comes
        painter.setPen(QPen(m_theme.wind, 3.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(onScreen(Vec3::Zero()), 9.0, 9.0);
        if (direction.dot(m_camera.back()) > 0.0)
            painter.drawPoint(onScreen(Vec3::Zero()));
        return;
    }
    const QPointF unit = along / length, normal(-unit.y(), unit.x());
    const double head = std::min(16.0, 0.45 * length);
    const QPointF neck = tip - head * unit;
    painter.setPen(QPen(m_theme.wind, 4.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(tail, neck);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.wind);
    painter.drawPolygon(QPolygonF{tip, neck + 0.5 * head * normal, neck - 0.5 * head * normal});
}

QString Compass::windWords() const
{
    const double speed = m_wind.norm();
    return speed > 0.0 ? tr("Wind %1 m/s").arg(locale().toString(speed, 'f', 1)) : tr("No wind");
}

// They lie on a card, since what flies behind them may be as dark as they are.
void Compass::paintWords(QPainter& painter) const
{
    constexpr int pitch = textHeight - 4, margin = 4; // px
    QStringList lines{m_windShown ? windWords() : QString()};
    if (m_squares > 0.0)
        lines << tr("Squares of %1").arg(spokenText(m_squares, "m", 2));
    QList<QRect> places;
    QRect card;
    for (int i = 0; i < lines.size(); ++i) {
        lines[i] = fontMetrics().elidedText(lines[i], Qt::ElideRight, side - 2 * margin);
        places << QRect(0, side - 4 + i * pitch, side, textHeight);
        if (!lines[i].isEmpty())
            card |= fontMetrics().boundingRect(places[i], Qt::AlignCenter, lines[i]);
    }
    if (card.isEmpty())
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.card);
    painter.drawRoundedRect(card.adjusted(-margin, -1, margin, 1), margin, margin);
    painter.setPen(m_theme.text);
    for (int i = 0; i < lines.size(); ++i)
        painter.drawText(places[i], Qt::AlignCenter, lines[i]);
}

void Compass::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintRing(painter);
    paintAxes(painter);
    if (m_windShown)
        paintWind(painter);
    paintWords(painter);
}

} // namespace ripstop
