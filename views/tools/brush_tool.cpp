// press() starts a stroke with the scene as it is, and move() paints from where the cursor was on
// the fabric to where it is now; beside the fabric the way is interrupted. Each time that something
// changes, the step of the history is replaced by one with all that the stroke has painted.
#include "tools/brush_tool.h"

#include "document/document.h"
#include "document/words.h"
#include "overlays/caption.h"
#include "tools/picker.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace ripstop {
namespace {

constexpr double widerPerNotch = 1.15; // times as wide

// Where the fabric is under a place of the picture, m: on a panel exactly there, and on a link
// where there is no panel.
std::optional<Vec3> fabricAt(const CameraView& view, QPointF cursor)
{
    for (const ElementKinds& wanted : {ElementKinds{false, false, true}, ElementKinds()}) {
        const Picked picked = Picker{view, {{}, wanted}}.under(cursor.x(), cursor.y());
        if (picked.sort != Picked::Sort::Nothing && picked.sort != Picked::Sort::Collider)
            return picked.place;
    }
    return std::nullopt;
}

void paintRing(QPainter& painter, const Theme& theme, QPointF middle, double radius, bool isOn)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.card, 4.0));
    painter.drawEllipse(middle, radius, radius);
    painter.setPen(QPen(theme.text, 2.0, isOn ? Qt::SolidLine : Qt::DotLine));
    painter.drawEllipse(middle, radius, radius);
}

} // namespace

QString whyNothingToPaint(const Scene& scene, const Brush& brush)
{
    if (!BrushStroke(scene, brush).hasNothing())
        return {};
    return brush.what == Painted::Grain
               ? words("No panels here to paint: only parts whose panels carry the pull of the "
                       "fabric have a grain.")
               : words("No panels and no links here to paint.");
}

QString brushText(const Brush& brush)
{
    const QString number = compactNumber(brush.value());
    switch (brush.what) {
    case Painted::Strength:
        return words("strength × %1").arg(number);
    case Painted::Stiffness:
        return words("stiffness × %1").arg(number);
    case Painted::Grain:
        return words("grain %1°").arg(number);
    }
    return {};
}

BrushTool::BrushTool(Document& document, Brush& brush, Calls calls)
    : m_document(document)
    , m_brush(brush)
    , m_calls(std::move(calls))
{
    const auto forget = [this] {
        if (!m_stroke)
            m_planes.clear();
    };
    QObject::connect(&document, &Document::changed, &m_listener, forget);
    QObject::connect(&document, &Document::replaced, &m_listener, forget);
}

bool BrushTool::press(const QMouseEvent& event, const CameraView& view)
{
    if (event.button() != Qt::LeftButton)
        return m_stroke.has_value();
    m_isDown = true;
    // what is seen is where a run had it; the stroke would miss what it is drawn over
    if (!m_calls.begin())
        return true;
    m_stroke.emplace(m_document.scene(), m_brush);
    if (m_stroke->hasNothing()) {
        m_calls.said(whyNothingToPaint(m_document.scene(), m_brush));
        m_stroke.reset();
        return true;
    }
    m_gesture = m_document.beginGesture();
    m_place.reset();
    paintTo(event, view);
    return true;
}

bool BrushTool::move(const QMouseEvent& event, const CameraView& view)
{
    paintTo(event, view);
    return m_isDown && event.buttons().testFlag(Qt::LeftButton);
}

bool BrushTool::release(const QMouseEvent& event, const CameraView& view)
{
    if (event.button() != Qt::LeftButton)
        return false;
    paintTo(event, view);
    m_stroke.reset();
    return std::exchange(m_isDown, false);
}

void BrushTool::paintTo(const QMouseEvent& event, const CameraView& view)
{
    m_cursor = event.position();
    const std::optional<Vec3> before = std::exchange(m_place, fabricAt(view, *m_cursor));
    m_image = m_place && m_brush.mirrors ? imageOf(*m_place) : std::nullopt;
    if (!m_stroke || !m_place || !m_stroke->paint(before.value_or(*m_place), *m_place))
        return;
    m_document.cancel(m_gesture); // the stroke so far
    m_document.drag(m_stroke->edit(), m_gesture);
}

std::optional<Vec3> BrushTool::imageOf(const Vec3& place)
{
    const Id id = partNearest(m_document.scene(), place);
    if (id == noId)
        return std::nullopt;
    const auto [plane, isNew] = m_planes.try_emplace(id);
    if (isNew)
        plane->second = mirrorPlaneOf(*findItem<Part>(m_document.scene(), id));
    return plane->second.mirrored(place);
}

bool BrushTool::wheel(const QWheelEvent& event, const CameraView&)
{
    if (!(event.modifiers() & Qt::ControlModifier) || m_stroke)
        return m_stroke.has_value();
    m_brush.widen(std::pow(widerPerNotch, event.angleDelta().y() / 120.0));
    m_calls.changed();
    return true;
}

bool BrushTool::cancel()
{
    if (!m_stroke)
        return false;
    m_document.cancel(m_gesture);
    m_stroke.reset();
    return true;
}

void BrushTool::paint(QPainter& painter, const Theme& theme, const CameraView& view)
{
    if (!m_cursor)
        return;
    const CameraProjection projection(view);
    const Vec3 middle = m_place.value_or(view.camera.focus);
    const double radius = m_brush.radius / projection.metresPerPixel(middle);
    paintRing(painter, theme, *m_cursor, radius, m_place.has_value());
    if (m_image)
        if (const std::optional<QPointF> pixel = projection.pixel(*m_image))
            paintRing(painter, theme, *pixel, m_brush.radius / projection.metresPerPixel(*m_image),
                      false);
    paintCaption(painter, theme, *m_cursor,
                 words("%1 · radius %2 m").arg(brushText(m_brush), compactNumber(m_brush.radius)),
                 view.covered);
}

} // namespace ripstop
