// press() offers the event to the tool in use and then, with Ctrl, to the other tool; who takes it
// is busy until the buttons are up. move(), release() and wheel() go to the busy tool, or else to
// the one in use; keys go to the busy tool only. Each asks for a paint, so that the tool shows what
// it does.
//
// hover() notes the place of the mouse and starts a timer; when it runs out, lookUnderMouse() picks
// and announces another element. paintEvent() draws that element in the colour of text, and then
// the tool.
#include "tools/pointing.h"

#include "camera/camera_projection.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int hoverDelay = 30; // ms, between two looks at what is under the mouse

} // namespace

Pointing::Pointing(std::function<std::optional<CameraView>()> view, QWidget* parent)
    : QWidget(parent)
    , m_view(std::move(view))
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    m_soon.setSingleShot(true);
    m_soon.setInterval(hoverDelay);
    connect(&m_soon, &QTimer::timeout, this, &Pointing::lookUnderMouse);
}

Pointing::~Pointing() = default;

void Pointing::setTool(std::unique_ptr<Tool> tool)
{
    if (Tool* busy = active())
        busy->cancel();
    m_busy = nullptr;
    m_tool = std::move(tool);
    setHovered(noId);
    showCursor();
    update();
}

// The view has the cursor that the mouse shows, as this lets all events through.
void Pointing::showCursor()
{
    const Tool* tool = active();
    if (tool && tool->cursor() != Qt::ArrowCursor)
        parentWidget()->setCursor(tool->cursor());
    else
        parentWidget()->unsetCursor();
}

void Pointing::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

// An overlay with nothing to show must not cost a picture of the window, so it updates only when it
// has something.
void Pointing::moved()
{
    if (active() || m_hovered != noId)
        update();
    if (m_busy)
        if (const auto view = m_view())
            m_busy->moved(*view);
    if (m_mouse && !m_soon.isActive())
        m_soon.start();
}

Id Pointing::pick(QPointF place) const
{
    const auto view = m_view();
    return view ? Picker{*view, pickable}.at(place.x(), place.y()) : noId;
}

bool Pointing::press(const QMouseEvent& event)
{
    hover({});
    const bool byCtrl = event.button() == Qt::LeftButton && event.modifiers() == Qt::ControlModifier
                        && m_ctrlTool && !m_busy;
    const auto view = active() || byCtrl ? m_view() : std::nullopt;
    if (!view)
        return false;
    bool taken = active() && active()->press(event, *view);
    if (taken && !m_busy) {
        m_busy = m_tool.get();
    } else if (!taken && byCtrl) {
        taken = m_ctrlTool->press(event, *view);
        m_busy = taken ? m_ctrlTool.get() : nullptr;
    }
    showCursor();
    update();
    return taken;
}

bool Pointing::move(const QMouseEvent& event)
{
    const auto view = active() ? m_view() : std::nullopt;
    const bool taken = view && active()->move(event, *view);
    if (active()) {
        showCursor();
        update();
    }
    const bool picks = event.buttons() == Qt::NoButton && !taken && (!m_tool || m_tool->picks());
    hover(picks ? std::optional(event.position()) : std::nullopt);
    return taken;
}

bool Pointing::release(const QMouseEvent& event)
{
    const auto view = active() ? m_view() : std::nullopt;
    const bool taken = view && active()->release(event, *view);
    if (event.buttons() == Qt::NoButton)
        m_busy = nullptr;
    showCursor();
    update();
    return taken;
}

bool Pointing::wheel(const QWheelEvent& event)
{
    const auto view = active() ? m_view() : std::nullopt;
    const bool taken = view && active()->wheel(event, *view);
    if (taken)
        update();
    return taken;
}

bool Pointing::takesKey(const QKeyEvent& event) const { return m_busy && m_busy->takesKey(event); }

bool Pointing::key(const QKeyEvent& event)
{
    if (!takesKey(event))
        return false;
    if (const auto view = m_view())
        m_busy->key(event, *view);
    update();
    return true;
}

bool Pointing::escape()
{
    if (!active())
        return false;
    update();
    if (!active()->cancel() && m_tool) {
        setTool(nullptr);
        emit toolLeft();
    }
    return true;
}

void Pointing::hover(std::optional<QPointF> place)
{
    m_mouse = place;
    if (!place) {
        m_soon.stop();
        setHovered(noId);
    } else if (!m_soon.isActive()) {
        m_soon.start();
    }
}

void Pointing::lookUnderMouse() { setHovered(m_mouse ? pick(*m_mouse) : noId); }

void Pointing::setHovered(Id id)
{
    if (id == m_hovered)
        return;
    m_hovered = id;
    update();
    emit hoveredChanged(id);
}

void Pointing::paintEvent(QPaintEvent*)
{
    const auto view = active() || m_hovered != noId ? m_view() : std::nullopt;
    if (!view)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_hovered != noId)
        paintHovered(painter, *view);
    if (Tool* tool = active())
        tool->paint(painter, m_theme, *view);
}

// A ring, a line or a triangle where the element is now; a collider has its name only.
void Pointing::paintHovered(QPainter& painter, const CameraView& view) const
{
    const Layout& layout = *view.frame.layout;
    const auto id = std::uint32_t(m_hovered);
    const CameraProjection projection(view);
    const auto at = [&](int particle) {
        const OnScreen place = projection(view.frame.position[std::size_t(particle)]);
        return place.isSeen() ? QPointF(place.x, place.y) : QPointF(-1e4, -1e4);
    };
    const QColor ink = m_theme.text; // the accent is that of the selection
    QColor veil = ink;
    veil.setAlphaF(0.25F);
    painter.setPen(QPen(ink, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(veil);
    for (std::size_t i = 0; i < layout.particleId.size(); ++i)
        if (layout.particleId[i] == id)
            painter.drawEllipse(at(int(i)), 7.0, 7.0);
    painter.setPen(QPen(ink, 3.0, Qt::SolidLine, Qt::RoundCap));
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (layout.links[i].id == id && !view.frame.torn[i])
            painter.drawLine(at(layout.links[i].a), at(layout.links[i].b));
    painter.setPen(QPen(ink, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (std::size_t i = 0; i < layout.panelId.size(); ++i)
        if (layout.panelId[i] == id && !view.frame.gone[i]) {
            const auto [a, b, c] = layout.panelCorners[i];
            painter.drawPolygon(QPolygonF{QList<QPointF>{at(a), at(b), at(c)}});
        }
}

} // namespace ripstop
