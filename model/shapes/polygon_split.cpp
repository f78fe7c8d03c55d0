// Splits polygons: a triangle stays, a convex quad is cut along its shorter diagonal, and any
// other polygon is seen along its area vector and loses one ear after the other. An ear is no
// sliver, as the corner of a side that another point lies on would be, where there is another one.
// A polygon that rounding or a crossing leaves without an ear loses its widest corner, so that the
// loop always ends.
// The joining of points, which the header has too, stands in weld.cpp.
#include "shapes/polygon_split.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// A polygon seen along its area vector, where it goes counter-clockwise but for hollow corners.
class FlatPolygon
{
public:
    FlatPolygon(std::span<const int> corners, const std::vector<Vec3>& points)
        : m_normal(doubleArea(corners, points))
    {
        // two axes across the normal
        const Vec3 aside =
            m_normal.cwiseAbs().x() > m_normal.cwiseAbs().y() ? Vec3::UnitY() : Vec3::UnitX();
        const Vec3 u = aside.cross(m_normal).normalized();
        const Vec3 v = m_normal.normalized().cross(u);
        for (const int corner : corners) {
            const Vec3 from = points[std::size_t(corner)] - points[std::size_t(corners[0])];
            m_flat.emplace_back(from.dot(u), from.dot(v));
        }
    }

    // Twice the signed area of a triangle of corners, by their places in the polygon.
    double turn(int a, int b, int c) const
    {
        const Eigen::Vector2d ab = at(b) - at(a);
        const Eigen::Vector2d ac = at(c) - at(a);
        return ab.x() * ac.y() - ab.y() * ac.x();
    }

    // Whether it lies within the triangle, or beside it by less than `margin` (as an area).
    bool isInside(int p, int a, int b, int c, double margin) const
    {
        return at(p) != at(a) && at(p) != at(b) && at(p) != at(c) && turn(a, b, p) >= -margin
               && turn(b, c, p) >= -margin && turn(c, a, p) >= -margin;
    }

    // Twice the area of what is still a triangle and no sliver.
    double sliver() const { return sliverOfArea * m_normal.norm(); }

private:
    static constexpr double sliverOfArea = 1e-3;

    const Eigen::Vector2d& at(int i) const { return m_flat[std::size_t(i)]; }

    Vec3 m_normal;
    std::vector<Eigen::Vector2d> m_flat;
};

// The place in `ring` of the ear to cut: the one with the best shape would be dearer to find.
// Where rounding or a polygon that crosses itself leaves no ear, the widest corner will do.
std::size_t earOf(const std::vector<int>& ring, const FlatPolygon& polygon)
{
    const std::size_t n = ring.size();
    std::size_t widest = 0;
    double most = -1e300;
    for (const double margin : {polygon.sliver(), 0.0})
        for (std::size_t i = 0; i < n; ++i) {
            const int a = ring[(i + n - 1) % n];
            const int b = ring[i];
            const int c = ring[(i + 1) % n];
            const double turn = polygon.turn(a, b, c);
            if (turn > most) {
                most = turn;
                widest = i;
            }
            if (turn <= margin)
                continue;
            bool isEar = true;
            for (std::size_t k = 0; k < n && isEar; ++k)
                isEar = ring[k] == a || ring[k] == b || ring[k] == c
                        || !polygon.isInside(ring[k], a, b, c, margin);
            if (isEar)
                return i;
        }
    return widest;
}

} // namespace

Vec3 doubleArea(std::span<const int> corners, const std::vector<Vec3>& points)
{
    Vec3 sum = Vec3::Zero();
    const Vec3& origin = points[std::size_t(corners[0])];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += (points[std::size_t(corners[i])] - origin)
                   .cross(points[std::size_t(corners[i + 1])] - origin);
    return sum;
}

double distanceFromPlane(std::span<const int> corners, const std::vector<Vec3>& points)
{
    if (corners.size() <= 3)
        return 0.0;
    const Vec3 normal = doubleArea(corners, points).normalized();
    Vec3 middle = Vec3::Zero();
    for (const int corner : corners)
        middle += points[std::size_t(corner)] / double(corners.size());
    double farthest = 0.0;
    for (const int corner : corners)
        farthest = std::max(farthest, std::abs(normal.dot(points[std::size_t(corner)] - middle)));
    return farthest;
}

bool isConvexQuad(std::span<const int> corners, const std::vector<Vec3>& points)
{
    if (corners.size() != 4)
        return false;
    const FlatPolygon polygon(corners, points);
    const double least = polygon.sliver();
    return polygon.turn(0, 1, 2) > least && polygon.turn(1, 2, 3) > least
           && polygon.turn(2, 3, 0) > least && polygon.turn(3, 0, 1) > least;
}

void splitPolygon(std::span<const int> corners, const std::vector<Vec3>& points,
                  std::vector<std::array<int, 3>>& triangles)
{
    const auto at = [&](int i) -> const Vec3& { return points[std::size_t(corners[i])]; };
    if (corners.size() == 3) {
        triangles.push_back({corners[0], corners[1], corners[2]});
        return;
    }
    if (isConvexQuad(corners, points)) {
        const bool byFirst = (at(2) - at(0)).norm() <= (at(3) - at(1)).norm();
        const int s = byFirst ? 0 : 1;
        triangles.push_back({corners[s], corners[s + 1], corners[s + 2]});
        triangles.push_back({corners[s], corners[s + 2], corners[(s + 3) % 4]});
        return;
    }
    const FlatPolygon polygon(corners, points);
    std::vector<int> ring(corners.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
        ring[i] = int(i);
    while (ring.size() >= 3) {
        const std::size_t ear = ring.size() == 3 ? 1 : earOf(ring, polygon);
        const std::size_t n = ring.size();
        triangles.push_back({corners[std::size_t(ring[(ear + n - 1) % n])],
                             corners[std::size_t(ring[ear])],
                             corners[std::size_t(ring[(ear + 1) % n])]});
        ring.erase(ring.begin() + std::ptrdiff_t(ear));
    }
}

} // namespace ripstop
