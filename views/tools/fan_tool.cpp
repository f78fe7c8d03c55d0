// fanAt() makes the jet: its target is what the cursor is on, or the plane of the focus beside it;
// its nozzle is as wide as a share of the picture there and stands a few radii before the target.
//
// While the left button is down, blow() hands the jet to the player whenever cursor, camera or
// settings have changed it. The wheel changes the settings, within their limits. Release, Escape
// and the end of the tool all go through cancel(), so that no jet is left blowing.
#include "tools/fan_tool.h"

#include "document/player.h"
#include "document/words.h"
#include "overlays/caption.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

constexpr double nozzle = 0.1;    // of half the height of the picture, radius
constexpr double standOff = 4.0;  // radii, from the nozzle to what it blows at
constexpr double perNotch = 1.15; // times as fast or wide

// Any two directions across an axis.
std::pair<Vec3, Vec3> across(const Vec3& axis)
{
    const Vec3 one = axis.unitOrthogonal();
    return {one, axis.cross(one)};
}

} // namespace

std::pair<Airflow, double> fanAt(const CameraView& view, QPointF cursor,
                                 const HandSettings& settings)
{
    const Picked picked = Picker{view, {}}.under(cursor.x(), cursor.y());
    const CameraProjection::Ray ray = CameraProjection(view).rayAt(cursor.x(), cursor.y());
    const Vec3 target =
        picked.sort != Picked::Sort::Nothing
            ? picked.place
            : Vec3(ray.origin
                   + (view.camera.focus - ray.origin).dot(ray.direction) * ray.direction);
    const double depth = (view.camera.eye() - target).dot(view.camera.back());
    const double half =
        view.camera.halfHeight() * (view.camera.orthographic ? 1.0 : depth / view.camera.distance);
    Airflow jet;
    jet.kind = WindKind::Jet;
    jet.radius = std::max(nozzle * half, 1e-3);
    const double reach = std::min(standOff * jet.radius, (target - ray.origin).norm());
    jet.origin = target - reach * ray.direction;
    jet.velocity = settings.fanSpeed * ray.direction;
    jet.widening = settings.fanWidening;
    return {jet, reach};
}

FanTool::FanTool(Player& player, HandSettings& settings, std::function<void()> changed)
    : m_player(player)
    , m_settings(settings)
    , m_changed(std::move(changed))
{}

FanTool::~FanTool() { cancel(); }

void FanTool::blow(const CameraView& view)
{
    const auto [jet, reach] = fanAt(view, m_cursor, m_settings);
    m_reach = reach;
    if (m_jet == jet)
        return;
    m_jet = jet;
    m_player.handle(jet);
}

bool FanTool::press(const QMouseEvent& event, const CameraView& view)
{
    if (event.button() != Qt::LeftButton)
        return m_jet.has_value();
    m_cursor = event.position();
    m_isDown = true;
    blow(view);
    return true;
}

bool FanTool::move(const QMouseEvent& event, const CameraView& view)
{
    m_cursor = event.position();
    if (m_jet)
        blow(view);
    return m_isDown;
}

bool FanTool::release(const QMouseEvent& event, const CameraView&)
{
    if (event.button() != Qt::LeftButton)
        return false;
    cancel();
    return std::exchange(m_isDown, false);
}

bool FanTool::wheel(const QWheelEvent& event, const CameraView& view)
{
    if (!m_jet)
        return false;
    const double factor = std::pow(perNotch, event.angleDelta().y() / 120.0);
    if (event.modifiers() & Qt::ControlModifier)
        m_settings.fanWidening = std::clamp(m_settings.fanWidening * factor,
                                            HandSettings::narrowestFan, HandSettings::widestFan);
    else
        m_settings.fanSpeed = std::clamp(m_settings.fanSpeed * factor, HandSettings::slowestFan,
                                         HandSettings::fastestFan);
    blow(view);
    m_changed();
    return true;
}

// What the jet blows at may move away under the cursor, so the jet is aimed again.
void FanTool::moved(const CameraView& view)
{
    if (m_jet)
        blow(view);
}

bool FanTool::cancel()
{
    if (!m_jet)
        return false;
    m_jet.reset();
    m_player.handle(HandNote::FanOff{});
    return true;
}

// Paints the nozzle, the edge of the jet where it meets what it blows at, and lines between them.
void FanTool::paint(QPainter& painter, const Theme& theme, const CameraView& view)
{
    if (!m_jet)
        return;
    const CameraProjection projection(view);
    const Vec3 axis = m_jet->velocity.normalized();
    const auto [one, other] = across(axis);
    constexpr int corners = 40;
    QPolygonF rings[2];
    for (int ring = 0; ring < 2; ++ring) {
        const double along = ring * m_reach;
        const double radius = m_jet->radius + along * m_jet->widening;
        for (int i = 0; i <= corners; ++i) {
            const double angle = 2.0 * M_PI * i / corners;
            const Vec3 place = m_jet->origin + along * axis
                               + radius * (std::cos(angle) * one + std::sin(angle) * other);
            if (const OnScreen seen = projection(place); seen.isSeen())
                rings[ring] << QPointF(seen.x, seen.y);
        }
    }
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(theme.card, 4.0), QPen(theme.wind, 2.0)}) {
        painter.setPen(pen);
        for (const QPolygonF& ring : rings)
            painter.drawPolyline(ring);
        for (int i = 0; i < corners; i += corners / 8)
            if (i < rings[0].size() && i < rings[1].size())
                painter.drawLine(rings[0][i], rings[1][i]);
    }
    const QLocale locale;
    paintCaption(painter, theme, m_cursor,
                 words("%1 m/s · wheel: strength · Ctrl + wheel: spread %2°")
                     .arg(locale.toString(m_settings.fanSpeed, 'f', 1))
                     .arg(qRound(std::atan(m_settings.fanWidening) * 180.0 / M_PI)),
                 view.covered);
}

} // namespace ripstop
