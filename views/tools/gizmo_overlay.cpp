// GizmoDrawing paints one gizmo: the far halves of the rings first and faintly, then each handle
// that can be seen, in the colour of its axis or, when it is held or under the cursor, in a colour
// of its own. Axes and rings have a rim, so that they can be seen before any ground; arrows end in
// heads, scale handles in boxes.
//
// label() writes what the drag comes to on a card beside the centre. paintEvent() asks the tool for
// its gizmo and paints nothing when there is none.
#include "tools/gizmo_overlay.h"

#include "tools/transform_tool.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double head = 13.0; // pixels, length of an arrow head
constexpr double box = 9.0;   // pixels, edge of the box of a scale handle

QPointF unitOf(QPointF way)
{
    const double length = std::hypot(way.x(), way.y());
    return length > 0.0 ? way / length : QPointF(1.0, 0.0);
}

class GizmoDrawing
{
public:
    GizmoDrawing(QPainter& painter, const Gizmo& gizmo, const Theme& theme, Handle active)
        : m_painter(painter)
        , m_gizmo(gizmo)
        , m_theme(theme)
        , m_active(active)
    {}

    void draw()
    {
        if (m_gizmo.shaping == Shaping::Turn)
            for (int axis = 0; axis < 3; ++axis)
                line(m_gizmo.behindShape(axis), faint(m_theme.axis(axis)), 1.5);
        for (const Handle& handle : m_gizmo.handles())
            draw(handle);
    }

private:
    static QColor faint(QColor color)
    {
        color.setAlphaF(0.35F);
        return color;
    }

    QColor colorOf(Handle handle) const
    {
        if (handle == m_active)
            return m_theme.isDark() ? QColor(0xff, 0xd6, 0x4a) : QColor(0xf0, 0x94, 0x00);
        return handle.sort == Handle::Sort::Free ? m_theme.text : m_theme.axis(handle.axis);
    }

    // A light or dark rim keeps the line visible before any colour.
    void line(const QPolygonF& shape, const QColor& color, double width)
    {
        QColor rim = m_theme.card;
        rim.setAlphaF(0.7F * float(color.alphaF()));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(rim, width + 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        m_painter.drawPolyline(shape);
        m_painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        m_painter.drawPolyline(shape);
    }

    void draw(Handle handle)
    {
        const QPolygonF shape = m_gizmo.shape(handle);
        if (shape.size() < 2)
            return;
        const QColor color = colorOf(handle);
        const double width = handle == m_active ? 3.5 : 2.5;
        if (handle.sort == Handle::Sort::Plane) {
            QColor fill = color;
            fill.setAlphaF(handle == m_active ? 0.6F : 0.3F);
            m_painter.setPen(QPen(color, 1.5));
            m_painter.setBrush(fill);
            m_painter.drawPolygon(shape);
        } else if (m_gizmo.shaping == Shaping::Turn) {
            line(shape, color, width);
        } else if (handle.sort == Handle::Sort::Free) {
            m_painter.setPen(QPen(color, 2.0));
            m_painter.setBrush(m_theme.card);
            if (m_gizmo.shaping == Shaping::Move)
                m_painter.drawPolygon(shape);
            else
                m_painter.drawRect(shape.boundingRect());
        } else {
            line(shape, color, width);
            tip(shape, color);
        }
    }

    void tip(const QPolygonF& shape, const QColor& color)
    {
        const QPointF end = shape.last();
        const QPointF along = unitOf(end - shape.first());
        const QPointF across(-along.y(), along.x());
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(color);
        if (m_gizmo.shaping == Shaping::Scale)
            m_painter.drawRect(QRectF(end.x() - 0.5 * box, end.y() - 0.5 * box, box, box));
        else
            m_painter.drawPolygon(QPolygonF{end + 0.6 * head * along,
                                            end - 0.4 * head * along + 0.4 * head * across,
                                            end - 0.4 * head * along - 0.4 * head * across});
    }

    QPainter& m_painter;
    const Gizmo& m_gizmo;
    const Theme& m_theme;
    Handle m_active;
};

void label(QPainter& painter, const Theme& theme, QPointF beside, const QString& text,
           const QRect& within)
{
    QRectF card = painter.fontMetrics().boundingRect(text).adjusted(-8, -4, 8, 4);
    card.moveTopLeft(beside + QPointF(Gizmo::viewReach, -Gizmo::viewReach));
    card.moveLeft(std::min(card.left(), within.right() - card.width() - 4.0));
    card.moveTop(std::max(card.top(), 4.0));
    QColor fill = theme.card;
    fill.setAlphaF(0.9F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(card, 4.0, 4.0);
    painter.setPen(theme.text);
    painter.drawText(card, Qt::AlignCenter, text);
}

} // namespace

GizmoOverlay::GizmoOverlay(TransformTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_tool(tool)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    connect(&tool, &TransformTool::changed, this, &GizmoOverlay::refresh);
}

void GizmoOverlay::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void GizmoOverlay::refresh()
{
    const bool shown = m_tool.acts();
    setVisible(shown);
    if (!shown)
        return;
    setGeometry(parentWidget()->rect());
    update();
}

void GizmoOverlay::paintEvent(QPaintEvent*)
{
    const auto gizmo = m_tool.gizmo();
    const auto centre = gizmo ? gizmo->centre() : std::nullopt;
    if (!centre)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    GizmoDrawing(painter, *gizmo, m_theme, m_tool.active()).draw();
    if (const QString told = m_tool.told(); !told.isEmpty())
        label(painter, m_theme, *centre, told, rect());
}

} // namespace ripstop
