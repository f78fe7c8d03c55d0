// press() begins a path, follow() makes a box or a lasso of it, and release() takes what lies
// inside and changes the selection as the keys say; a drag that is no longer than a click is left
// to the view. cancel() empties the path while the button is still down, so that the release after
// it does nothing. paint() draws the outline and a plus or minus sign for the keys.
#include "tools/region_tool.h"

#include "document/selection.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace ripstop {
namespace {

constexpr double lassoStride = 2.0; // pixels, between corners of a lasso

} // namespace

RegionTool::RegionTool(Shape shape, Selection& selection, std::function<Options()> options)
    : m_shape(shape)
    , m_selection(selection)
    , m_options(std::move(options))
{}

bool RegionTool::press(const QMouseEvent& event, const CameraView&)
{
    if (event.button() != Qt::LeftButton)
        return false;
    m_path = {event.position()};
    m_keys = event.modifiers();
    m_far = m_givenUp = false;
    return true;
}

void RegionTool::follow(const QMouseEvent& event)
{
    m_keys = event.modifiers();
    const QPointF place = event.position();
    m_far =
        m_far || (place - m_path.front()).manhattanLength() >= QApplication::startDragDistance();
    if (m_shape == Shape::Box) {
        m_path.resize(1);
        m_path.push_back(place);
    } else if ((place - m_path.back()).manhattanLength() >= lassoStride) {
        m_path.push_back(place);
    }
}

bool RegionTool::move(const QMouseEvent& event, const CameraView&)
{
    if (!m_path.empty())
        follow(event);
    return event.buttons().testFlag(Qt::LeftButton);
}

// A click without a drag is the view's: it takes what is under the cursor.
bool RegionTool::release(const QMouseEvent& event, const CameraView& view)
{
    if (event.button() != Qt::LeftButton)
        return false;
    if (m_path.empty())
        return std::exchange(m_givenUp, false);
    follow(event);
    std::vector<Eigen::Vector2d> corners;
    for (const QPointF& corner : outline())
        corners.emplace_back(corner.x(), corner.y());
    m_path.clear();
    if (!m_far)
        return false;
    const Options options = m_options();
    const std::vector<Id> ids =
        elementsIn(view, options.pickable, Region(std::move(corners)), options.depth);
    if (m_keys & Qt::ControlModifier)
        m_selection.remove(ids);
    else if (m_keys & Qt::ShiftModifier)
        m_selection.add(ids);
    else
        m_selection.set(ids);
    return true;
}

bool RegionTool::cancel()
{
    m_givenUp = !m_path.empty();
    m_path.clear();
    return m_givenUp;
}

std::vector<QPointF> RegionTool::outline() const
{
    if (m_shape == Shape::Lasso || m_path.size() < 2)
        return m_path;
    const QPointF a = m_path.front(), b = m_path.back();
    return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
}

void RegionTool::paint(QPainter& painter, const Theme& theme, const CameraView&)
{
    if (m_path.empty() || !m_far)
        return;
    const bool adds = m_keys & Qt::ShiftModifier, removes = m_keys & Qt::ControlModifier;
    const QColor ink = removes ? theme.pin : theme.accent;
    QColor veil = ink;
    veil.setAlphaF(0.15F);
    QPolygonF polygon;
    for (const QPointF& corner : outline())
        polygon << corner;
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    path.setFillRule(Qt::WindingFill);
    painter.fillPath(path, veil);
    painter.strokePath(path, QPen(theme.card, 3.0));
    painter.strokePath(path, QPen(ink, 1.5, Qt::DashLine));
    if (adds || removes) {
        const QPointF sign = m_path.back() + QPointF(16.0, 20.0);
        painter.setPen(QPen(theme.card, 6.0, Qt::SolidLine, Qt::RoundCap));
        for (int pass = 0; pass < 2; ++pass) {
            painter.drawLine(sign - QPointF(5, 0), sign + QPointF(5, 0));
            if (!removes)
                painter.drawLine(sign - QPointF(0, 5), sign + QPointF(0, 5));
            painter.setPen(QPen(ink, 2.5, Qt::SolidLine, Qt::RoundCap));
        }
    }
}

} // namespace ripstop
