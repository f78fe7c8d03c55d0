// press(), move() and release() collect the stroke in pixels; a stroke no longer than a click is
// left to the view.
//
// cutUnder() makes a cut of it: points at even distances along the stroke (so that a slow hand cuts
// no finer than a quick one), for each point how deep the cut reaches (behind the first fabric, or
// behind everything), and for each the piece of the ray down to there. Where the stroke runs beside
// the fabric, the depth is that of the nearest point that has some.
#include "tools/cut_tool.h"

#include "camera/occlusion.h"
#include "document/player.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double stride = 3.0;    // pixels, between points of the stroke as it is drawn
constexpr double spacing = 8.0;   // pixels, about, between points that it is cut with
constexpr std::size_t most = 200; // points of a cut; those of a longer stroke lie farther apart
constexpr double none = std::numeric_limits<double>::infinity();

// Points at even distances along a stroke.
std::vector<QPointF> evenly(const std::vector<QPointF>& stroke)
{
    std::vector<double> along{0.0};
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        const QPointF way = stroke[i] - stroke[i - 1];
        along.push_back(along.back() + std::hypot(way.x(), way.y()));
    }
    const auto count = std::clamp<std::size_t>(std::size_t(along.back() / spacing) + 2, 2, most);
    std::vector<QPointF> points;
    std::size_t next = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double place = along.back() * double(i) / double(count - 1);
        while (next + 1 < stroke.size() && along[next] < place)
            ++next;
        const double length = along[next] - along[next - 1];
        const double share = length > 0.0 ? (place - along[next - 1]) / length : 0.0;
        points.push_back(stroke[next - 1]
                         + std::min(share, 1.0) * (stroke[next] - stroke[next - 1]));
    }
    return points;
}

// How far away the first fabric under each point lies, and a little behind it, m; infinite where
// there is none.
std::vector<double> depthsOf(const CameraView& view, const std::vector<QPointF>& points)
{
    const std::vector<OnScreen> particles = projected(view);
    Eigen::AlignedBox2d box;
    for (const QPointF& point : points)
        box.extend(Eigen::Vector2d(point.x(), point.y()));
    const Occlusion occlusion(view, particles, box, true);
    std::vector<double> depths;
    for (const QPointF& point : points) {
        const Occlusion::Met met = occlusion.firstPanel(point.x(), point.y());
        if (met.panel < 0) {
            depths.push_back(none);
            continue;
        }
        const auto& corner = view.frame.layout->panelCorners[std::size_t(met.panel)];
        const Vec3& a = view.frame.position[std::size_t(corner[0])];
        const Vec3 ab = view.frame.position[std::size_t(corner[1])] - a;
        const Vec3 ac = view.frame.position[std::size_t(corner[2])] - a;
        depths.push_back(met.distance + std::max(ab.norm(), ac.norm()));
    }
    return depths;
}

// Gives points without fabric the depth of the nearest point that has some, or `otherwise` when
// none has.
void fillGaps(std::vector<double>& depths, double otherwise)
{
    const std::vector<double> found = depths;
    const auto at = [&](std::ptrdiff_t i) {
        return i >= 0 && i < std::ptrdiff_t(found.size()) ? found[std::size_t(i)] : none;
    };
    for (std::size_t i = 0; i < depths.size(); ++i)
        for (std::ptrdiff_t away = 0; depths[i] == none; ++away) {
            if (away > std::ptrdiff_t(found.size())) {
                depths[i] = otherwise;
                break;
            }
            depths[i] = std::min(at(std::ptrdiff_t(i) - away), at(std::ptrdiff_t(i) + away));
        }
}

} // namespace

Cut cutUnder(const CameraView& view, const std::vector<QPointF>& stroke, Depth depth)
{
    const std::vector<QPointF> points = evenly(stroke);
    const CameraProjection projection(view);
    const Vec3 origin = projection.rayAt(0.5 * view.width, 0.5 * view.height).origin;
    double behindAll = 0.0; // m, from any origin
    for (const Vec3& place : view.frame.position)
        behindAll = std::max(behindAll, (place - origin).norm());
    behindAll *= 1.1;
    std::vector<double> depths =
        depth == Depth::Visible ? depthsOf(view, points) : std::vector<double>(points.size(), none);
    fillGaps(depths, behindAll);
    Cut cut;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CameraProjection::Ray ray = projection.rayAt(points[i].x(), points[i].y());
        cut.edges.push_back({ray.origin, ray.origin + depths[i] * ray.direction});
    }
    return cut;
}

CutTool::CutTool(Player& player, std::function<Depth()> depth)
    : m_player(player)
    , m_depth(std::move(depth))
{}

bool CutTool::press(const QMouseEvent& event, const CameraView&)
{
    if (event.button() != Qt::LeftButton)
        return false;
    m_stroke = {event.position()};
    m_givenUp = false;
    return true;
}

bool CutTool::move(const QMouseEvent& event, const CameraView&)
{
    if (!m_stroke.empty() && (event.position() - m_stroke.back()).manhattanLength() >= stride)
        m_stroke.push_back(event.position());
    return event.buttons().testFlag(Qt::LeftButton);
}

bool CutTool::release(const QMouseEvent& event, const CameraView& view)
{
    if (event.button() != Qt::LeftButton)
        return false;
    if (m_stroke.empty())
        return std::exchange(m_givenUp, false);
    m_stroke.push_back(event.position());
    const std::vector<QPointF> stroke = std::exchange(m_stroke, {});
    double length = 0.0;
    for (std::size_t i = 1; i < stroke.size(); ++i)
        length += (stroke[i] - stroke[i - 1]).manhattanLength();
    if (length < QApplication::startDragDistance())
        return false; // this was a click
    m_player.handle(std::make_shared<const Cut>(cutUnder(view, stroke, m_depth())));
    return true;
}

bool CutTool::cancel()
{
    m_givenUp = !m_stroke.empty();
    m_stroke.clear();
    return m_givenUp;
}

void CutTool::paint(QPainter& painter, const Theme& theme, const CameraView&)
{
    if (m_stroke.size() < 2)
        return;
    QPainterPath path(m_stroke.front());
    for (const QPointF& point : m_stroke)
        path.lineTo(point);
    painter.setBrush(Qt::NoBrush);
    painter.strokePath(path, QPen(theme.card, 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(theme.pin, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

} // namespace ripstop
