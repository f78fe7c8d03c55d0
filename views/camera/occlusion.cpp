// Stages of the constructor: panels that are shown and lie over the box are collected with their
// bounds in the picture; the bounds are divided into cells, about two panels to a cell; each panel
// is entered in all cells that it touches, counted first and filled in then, so that all lists
// share one array.
//
// A question (hides(), firstPanel()) takes the panels of one cell and meets each with the exact
// ray. Colliders are few and are asked one by one.
//
// Panels that reach behind the near plane are cut there, as the projection of a place behind the
// eye means nothing.
#include "camera/occlusion.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double seam = 1e-9;      // 1, no ray slips through where panels meet
constexpr double nearPlane = 0.02; // over the distance of the focus: nothing nearer is drawn
constexpr double touching = 1e-5;  // over the distance from the eye: lies on it, not behind it

struct Cells
{
    int left, right, top, bottom;
};

} // namespace

Occlusion::Occlusion(const CameraView& view, std::span<const OnScreen> points,
                     const Eigen::AlignedBox2d& box, bool panelsHide)
    : m_view(view)
    , m_projection(view)
    , m_box(box)
{
    const Layout& layout = *view.frame.layout;
    std::vector<int> met;                  // panels over the box
    std::vector<Eigen::AlignedBox2d> over; // [met]
    for (std::size_t i = 0; panelsHide && i < layout.panelId.size(); ++i) {
        if (view.frame.gone[i] || !view.look.panelShown[i])
            continue;
        const Eigen::AlignedBox2d bounds = boundsOf(int(i), points);
        if (bounds.intersects(box)) {
            met.push_back(int(i));
            over.push_back(bounds.intersection(box));
        }
    }
    m_box.setEmpty(); // cells are for where panels are
    for (const Eigen::AlignedBox2d& bounds : over)
        m_box.extend(bounds);

    m_side = std::clamp(int(std::sqrt(0.5 * double(met.size()))), 1, 512);
    const auto cellsOf = [&](const Eigen::AlignedBox2d& bounds) {
        const auto cell = [&](int axis, double place) {
            const double share =
                (place - m_box.min()[axis]) / std::max(m_box.sizes()[axis], 1e-300);
            return std::clamp(int(share * m_side), 0, m_side - 1);
        };
        return Cells{cell(0, bounds.min().x()), cell(0, bounds.max().x()),
                     cell(1, bounds.min().y()), cell(1, bounds.max().y())};
    };
    const auto forEachCell = [&](std::size_t panel, auto visit) {
        const Cells cells = cellsOf(over[panel]);
        for (int row = cells.top; row <= cells.bottom; ++row)
            for (int column = cells.left; column <= cells.right; ++column)
                visit(std::size_t(row * m_side + column));
    };
    m_first.assign(std::size_t(m_side * m_side) + 1, 0);
    for (std::size_t i = 0; i < met.size(); ++i)
        forEachCell(i, [&](std::size_t cell) { ++m_first[cell + 1]; });
    for (std::size_t i = 1; i < m_first.size(); ++i)
        m_first[i] += m_first[i - 1];
    m_panels.resize(std::size_t(m_first.back()));
    std::vector<int> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t i = 0; i < met.size(); ++i)
        forEachCell(i, [&](std::size_t cell) { m_panels[std::size_t(next[cell]++)] = met[i]; });
}

// Bounds of the part of a panel that is in front of the near plane of the picture, pixels.
Eigen::AlignedBox2d Occlusion::boundsOf(int panel, std::span<const OnScreen> points) const
{
    const auto& corners = m_view.frame.layout->panelCorners[std::size_t(panel)];
    const double near = nearPlane * m_view.camera.distance;
    const bool flat = m_view.camera.orthographic;
    Eigen::AlignedBox2d bounds;
    bool whole = true;
    for (const int corner : corners) {
        const OnScreen& at = points[std::size_t(corner)];
        if (at.isSeen() && (flat || at.depth >= near))
            bounds.extend(Eigen::Vector2d(at.x, at.y));
        else
            whole = false;
    }
    if (whole || flat || bounds.isEmpty())
        return bounds;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& a = m_view.frame.position[std::size_t(corners[i])];
        const Vec3& b = m_view.frame.position[std::size_t(corners[(i + 1) % 3])];
        const double from = m_projection.depthOf(a) - near, to = m_projection.depthOf(b) - near;
        if ((from < 0.0) == (to < 0.0))
            continue;
        const OnScreen cut = m_projection(a + from / (from - to) * (b - a));
        bounds.extend(Eigen::Vector2d(cut.x, cut.y));
    }
    return bounds;
}

std::span<const int> Occlusion::panelsAt(double x, double y) const
{
    if (m_panels.empty())
        return {};
    const auto cell = [&](int axis, double place) {
        const double share = (place - m_box.min()[axis]) / std::max(m_box.sizes()[axis], 1e-300);
        return std::size_t(std::clamp(int(share * m_side), 0, m_side - 1));
    };
    const std::size_t at = cell(1, y) * std::size_t(m_side) + cell(0, x);
    return std::span(m_panels).subspan(std::size_t(m_first[at]),
                                       std::size_t(m_first[at + 1] - m_first[at]));
}

// Moeller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
double Occlusion::distanceToPanel(const CameraProjection::Ray& ray, int panel) const
{
    const auto [i, j, k] = m_view.frame.layout->panelCorners[std::size_t(panel)];
    const auto& x = m_view.frame.position;
    const Vec3& a = x[std::size_t(i)];
    const Vec3 e1 = x[std::size_t(j)] - a, e2 = x[std::size_t(k)] - a;
    const Vec3 p = ray.direction.cross(e2);
    const double determinant = e1.dot(p);
    if (determinant == 0.0)
        return never;
    const Vec3 s = ray.origin - a;
    const double u = s.dot(p) / determinant;
    const Vec3 q = s.cross(e1);
    const double v = ray.direction.dot(q) / determinant;
    const double t = e2.dot(q) / determinant;
    return u >= -seam && v >= -seam && u + v <= 1.0 + seam && t > 0.0 ? t : never;
}

bool Occlusion::hides(const Spot& spot) const
{
    const CameraProjection::Ray ray = m_projection.rayThrough(spot.place);
    const double far = (spot.place - ray.origin).norm();
    // A view without perspective looks from a made-up place far away, so its own distance counts.
    const double eye = m_view.camera.orthographic ? m_view.camera.distance : far;
    const double before = far - touching * eye;
    const OnScreen at = m_projection(spot.place);
    const auto shared = [&](int panel) {
        const auto& corners = m_view.frame.layout->panelCorners[std::size_t(panel)];
        return std::ranges::count_if(spot.particles, [&](int particle) {
            return std::ranges::find(corners, particle) != corners.end();
        });
    };
    for (const int panel : panelsAt(at.x, at.y)) {
        const auto common = shared(panel);
        if (common == std::ptrdiff_t(spot.particles.size()))
            continue;
        if (distanceToPanel(ray, panel) < before - (common > 0 ? spot.slack : 0.0))
            return true;
    }
    return std::ranges::any_of(m_view.colliders, [&](const ColliderBody& body) {
        return body.collider.shown
               && distanceTo(body, placeOf(m_view.frame, body.id, body.collider), ray.origin,
                             ray.direction)
                      < before;
    });
}

Occlusion::Met Occlusion::firstPanel(double x, double y) const
{
    const CameraProjection::Ray ray = m_projection.rayAt(x, y);
    Met met{-1, never};
    for (const int panel : panelsAt(x, y))
        if (const double distance = distanceToPanel(ray, panel); distance < met.distance)
            met = {panel, distance};
    return met;
}

} // namespace ripstop
