// take() decides by what is under the cursor: controls that have it as a target are steered; a
// collider is carried from where hands have brought it before; all else is gripped, by the
// particles around the place and their shares in it (gripOf()).
//
// move() begins to pull only when the cursor has gone farther than a hand trembles, so that a click
// stays a click. pull() turns the cursor in the plane of the picture through the gripped place into
// commands of controls or notes of the hand, which the player hands to the simulation.
//
// letGo() ends a pull; cancel() also puts a carried collider back. paint() shows spring and force
// as the frame says them, which may be less than what was asked for.
#include "tools/grab_tool.h"

#include "document/document.h"
#include "document/player.h"
#include "document/spoken.h"
#include "document/words.h"
#include "overlays/caption.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

constexpr double depthPerNotch = 0.04; // of the distance to the eye

// Shares of the three corners in a place of their plane (barycentric coordinates, none below 0);
// equal shares for corners in one line.
Vec3 sharesOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& place)
{
    const Vec3 normal = (b - a).cross(c - a);
    const double square = normal.squaredNorm();
    if (!(square > 0.0))
        return Vec3::Constant(1.0 / 3.0);
    Vec3 share((b - place).cross(c - place).dot(normal), (c - place).cross(a - place).dot(normal),
               (a - place).cross(b - place).dot(normal));
    share = (share / square).cwiseMax(0.0);
    return share / share.sum();
}

Grip gripOf(const Frame& frame, const Picked& picked)
{
    const Layout& layout = *frame.layout;
    Grip grip;
    const auto key = [&](int particle) { return layout.keyOf(std::size_t(particle)); };
    const auto at = [&](int particle) { return frame.position[std::size_t(particle)]; };
    if (picked.sort == Picked::Sort::Particle) {
        grip.particle = {layout.keyOf(picked.element), 0, 0};
    } else if (picked.sort == Picked::Sort::Link) {
        const auto& link = layout.links[picked.element];
        const Vec3 way = at(link.b) - at(link.a);
        const double square = way.squaredNorm();
        const double share = square > 0.0 ? (picked.place - at(link.a)).dot(way) / square : 0.0;
        grip.particle = {key(link.a), key(link.b), 0};
        grip.share = {1.0 - share, share, 0.0};
    } else {
        const auto [a, b, c] = layout.panelCorners[picked.element];
        grip.particle = {key(a), key(b), key(c)};
        grip.share = sharesOf(at(a), at(b), at(c), picked.place);
    }
    return grip;
}

// The cursor in the plane parallel to the picture through a place, m.
Vec3 cursorIn(const CameraView& view, const Vec3& plane, QPointF cursor)
{
    const CameraProjection::Ray ray = CameraProjection(view).rayAt(cursor.x(), cursor.y());
    const Vec3 back = view.camera.back();
    const double along = (plane - ray.origin).dot(back) / ray.direction.dot(back);
    return ray.origin + along * ray.direction;
}

} // namespace

GrabTool::GrabTool(const Document& document, Player& player, const HandSettings& settings,
                   std::function<Pickable()> pickable)
    : m_document(document)
    , m_player(player)
    , m_settings(settings)
    , m_pickable(std::move(pickable))
{}

GrabTool::~GrabTool()
{
    if (m_held)
        letGo();
}

std::optional<GrabTool::Held> GrabTool::take(QPointF cursor, const CameraView& view) const
{
    Pickable pickable = m_pickable();
    pickable.drawn.particles = true; // a corner is held by its particle, with a dot or without
    const Picked picked = Picker{view, pickable}.under(cursor.x(), cursor.y());
    if (picked.sort == Picked::Sort::Nothing)
        return std::nullopt;
    Held held{Pulled{}, picked.place, picked.place, picked.place, cursor, cursor};
    if (Hand hand(m_document.scene(), picked.id, picked.place); !hand.isEmpty()) {
        Steered steered{std::move(hand), {}};
        for (const Id control : steered.hand.controls())
            steered.from.push_back(m_player.commandOf(control));
        held.what = std::move(steered);
    } else if (picked.sort == Picked::Sort::Collider) {
        Carried carried{picked.id, Vec3::Zero()};
        for (const Carry& carry : m_player.hands().hands.carries)
            if (carry.collider == std::uint32_t(picked.id))
                carried.from = carry.way;
        held.what = carried;
    } else {
        held.what = Pulled{gripOf(view.frame, picked)};
    }
    return held;
}

bool GrabTool::press(const QMouseEvent& event, const CameraView& view)
{
    if (event.button() != Qt::LeftButton)
        return m_held.has_value();
    m_drags = m_givenUp = false;
    m_held = take(event.position(), view);
    return m_held.has_value();
}

// A hand trembles while it clicks, so a drag begins only after some pixels.
bool GrabTool::move(const QMouseEvent& event, const CameraView& view)
{
    if (!m_held)
        return m_givenUp;
    m_held->at = event.position();
    m_drags = m_drags
              || (m_held->at - m_held->from).manhattanLength() >= QApplication::startDragDistance();
    if (m_drags)
        pull(view);
    return true;
}

bool GrabTool::release(const QMouseEvent& event, const CameraView&)
{
    if (event.button() != Qt::LeftButton)
        return false;
    if (!m_held)
        return std::exchange(m_givenUp, false);
    const bool dragged = m_drags;
    letGo();
    return dragged; // a click is the view's
}

void GrabTool::pull(const CameraView& view)
{
    Held& held = *m_held;
    held.to = cursorIn(view, held.plane, held.at);
    if (const auto* steered = std::get_if<Steered>(&held.what)) {
        const QPointF way = held.at - held.from;
        const std::vector<double> values =
            steered->hand.pull(view.camera, view.height, way.x(), way.y());
        for (std::size_t i = 0; i < values.size(); ++i)
            m_player.steer(steered->hand.controls()[i], steered->from[i] + values[i]);
        return;
    }
    HandNote::What what;
    if (const auto* carried = std::get_if<Carried>(&held.what)) {
        what = Carry{std::uint32_t(carried->collider), carried->from + held.to - held.place};
    } else {
        HandPull pull;
        pull.grip = std::get<Pulled>(held.what).grip;
        pull.to = held.to;
        pull.stiffness = m_settings.stiffnessIn(m_document.scene());
        pull.most = m_settings.mostIn(m_document.scene());
        what = pull;
    }
    m_player.handle(what);
}

void GrabTool::letGo()
{
    if (m_drags && std::holds_alternative<Pulled>(m_held->what))
        m_player.handle(HandNote::LetGo{});
    m_held.reset();
    m_drags = false;
}

bool GrabTool::wheel(const QWheelEvent& event, const CameraView& view)
{
    if (!holds())
        return false;
    const double notches = event.angleDelta().y() / 120.0;
    const Vec3 back = view.camera.back();
    const double distance = (view.camera.eye() - m_held->plane).dot(back);
    m_held->plane -= depthPerNotch * notches * std::max(distance, 1e-3) * back;
    pull(view);
    return true;
}

bool GrabTool::takesKey(const QKeyEvent& event) const
{
    return holds() && event.key() == Qt::Key_P && std::holds_alternative<Pulled>(m_held->what);
}

bool GrabTool::isPinned(const Grip& grip) const
{
    const auto& pins = m_player.hands().hands.pins;
    for (int i = 0; i < 3; ++i)
        if (grip.share[i] > 0.0
            && std::find(pins.begin(), pins.end(), grip.particle[std::size_t(i)]) != pins.end())
            return true;
    return false;
}

void GrabTool::key(const QKeyEvent& event, const CameraView&)
{
    if (event.isAutoRepeat())
        return;
    const Grip& grip = std::get<Pulled>(m_held->what).grip;
    const bool pins = !isPinned(grip);
    for (int i = 0; i < 3; ++i)
        if (grip.share[i] > 0.0)
            m_player.handle(HandNote::Pin{grip.particle[std::size_t(i)], pins});
}

bool GrabTool::cancel()
{
    if (!m_held)
        return false;
    m_givenUp = true;
    if (const auto* carried = std::get_if<Carried>(&m_held->what); carried && m_drags)
        m_player.handle(Carry{std::uint32_t(carried->collider), carried->from});
    letGo();
    return true;
}

Qt::CursorShape GrabTool::cursor() const
{
    return holds() ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
}

// --- what is seen of it ------------------------------------------------------------------------

void GrabTool::paint(QPainter& painter, const Theme& theme, const CameraView& view)
{
    if (!holds())
        return;
    if (std::holds_alternative<Pulled>(m_held->what))
        paintPull(painter, theme, view);
    else if (std::holds_alternative<Carried>(m_held->what))
        paintCarry(painter, theme, view);
}

// Paints the spring from where the fabric is to where the hand is, and the force beside it.
void GrabTool::paintPull(QPainter& painter, const Theme& theme, const CameraView& view) const
{
    const CameraProjection projection(view);
    const auto& now = view.frame.held;
    const Grip& grip = std::get<Pulled>(m_held->what).grip;
    const OnScreen from = projection(now ? now->point : m_held->place);
    const OnScreen to = projection(m_held->to);
    if (!from.isSeen() || !to.isSeen())
        return;
    paintSpring(painter, theme, {from.x, from.y}, {to.x, to.y});
    const bool pinned = isPinned(grip);
    QStringList said;
    if (now) {
        said << spokenText(now->force, "N", 3);
        const double asked = m_settings.stiffnessIn(m_document.scene());
        if (now->force >= 0.999 * m_settings.mostIn(m_document.scene()))
            said << words("the most it may");
        else if (now->stiffness < 0.999 * asked)
            said << words("%1, all that the time step allows")
                        .arg(spokenText(now->stiffness, "N/m", 3));
    }
    said << (pinned ? words("pinned, P lets go") : words("P pins"));
    paintCaption(painter, theme, {to.x, to.y}, said.join(QStringLiteral(" · ")), view.covered);
}

void GrabTool::paintCarry(QPainter& painter, const Theme& theme, const CameraView& view) const
{
    const CameraProjection projection(view);
    const OnScreen from = projection(m_held->place);
    const OnScreen to = projection(m_held->to);
    if (!from.isSeen() || !to.isSeen())
        return;
    painter.setPen(QPen(theme.card, 4.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(from.x, from.y), QPointF(to.x, to.y));
    painter.setPen(QPen(theme.accent, 2.0, Qt::DashLine, Qt::RoundCap));
    painter.drawLine(QPointF(from.x, from.y), QPointF(to.x, to.y));
    const double way = (m_held->to - m_held->place).norm();
    QString said = words("%1 m").arg(QLocale().toString(way, 'f', 2));
    if (!m_player.isPlaying())
        said = words("%1, when it runs").arg(said);
    paintCaption(painter, theme, {to.x, to.y}, said, view.covered);
}

} // namespace ripstop
