// Points are sorted along each axis, and each side of a face looks at those beside it along the
// axis on which they are fewest: sides on a rim at all points, others at points on a rim, since
// what lies on neither touches nothing open. What is found is kept by side; then each face takes it
// over, in the order in which it goes along the side.
#include "author/mesh_hanging.h"

#include "author/mesh_winding.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ripstop {
namespace {

struct Hanging
{
    double share; // of the way from the lower corner of the side to the higher one
    int point;
};

struct Along // an axis, m
{
    const std::vector<Vec3>& points;
    int axis;
    double operator()(int point) const { return points[std::size_t(point)][axis]; }
};

// Points in ascending order along each axis.
class SortedPoints
{
public:
    SortedPoints(const std::vector<Vec3>& points, const std::vector<int>& which)
        : m_points(points)
    {
        for (int axis = 0; axis < 3; ++axis) {
            m_order[std::size_t(axis)] = which;
            std::ranges::stable_sort(m_order[std::size_t(axis)], {}, Along{points, axis});
        }
    }

    // Those that lie between two corners of a box as one axis sees it, and more.
    std::span<const int> near(const Vec3& low, const Vec3& high) const
    {
        std::span<const int> fewest = m_order[0];
        for (int axis = 0; axis < 3; ++axis) {
            const std::vector<int>& order = m_order[std::size_t(axis)];
            const Along along{m_points, axis};
            const auto first = std::ranges::lower_bound(order, low[axis], {}, along);
            const auto last = std::ranges::upper_bound(first, order.end(), high[axis], {}, along);
            if (std::size_t(last - first) < fewest.size())
                fewest = std::span<const int>(first, last);
        }
        return fewest;
    }

private:
    const std::vector<Vec3>& m_points;
    std::array<std::vector<int>, 3> m_order;
};

class HangingPoints
{
public:
    HangingPoints(const PolygonMesh& mesh, double tolerance)
        : m_mesh(mesh)
        , m_tolerance(tolerance)
    {
        const std::vector<MeshEdge> edges = edgesOf(mesh);
        std::vector<std::uint8_t> isOnRim(mesh.points.size());
        for (const MeshEdge& edge : edges)
            if (edge.faceCount == 1)
                isOnRim[std::size_t(edge.a)] = isOnRim[std::size_t(edge.b)] = 1;
        std::vector<int> all, rim;
        for (int i = 0; i < int(mesh.points.size()); ++i) {
            all.push_back(i);
            if (isOnRim[std::size_t(i)])
                rim.push_back(i);
        }
        const SortedPoints everywhere(mesh.points, all);
        const SortedPoints onRim(mesh.points, rim);
        for (const MeshEdge& edge : edges)
            find(edge, edge.faceCount == 1 ? everywhere : onRim);
    }

    bool empty() const { return m_bySide.empty(); }

    // In the order from `from` to `to`; nothing where nothing hangs.
    std::vector<Hanging> on(int from, int to) const
    {
        const auto found = m_bySide.find(keyOf(from, to));
        if (found == m_bySide.end())
            return {};
        std::vector<Hanging> hanging = found->second;
        if (from > to)
            std::ranges::reverse(hanging);
        return hanging;
    }

private:
    static std::uint64_t keyOf(int a, int b)
    {
        return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
    }

    void find(const MeshEdge& edge, const SortedPoints& points)
    {
        const Vec3& a = m_mesh.points[std::size_t(edge.a)];
        const Vec3& b = m_mesh.points[std::size_t(edge.b)];
        const Vec3 side = b - a;
        const double length = side.norm();
        if (!(length > 2.0 * m_tolerance))
            return;
        std::vector<Hanging> found;
        const Vec3 reach = Vec3::Constant(m_tolerance);
        for (const int point : points.near(a.cwiseMin(b) - reach, a.cwiseMax(b) + reach)) {
            const Vec3 from = m_mesh.points[std::size_t(point)] - a;
            const double along = from.dot(side) / length;
            if (point != edge.a && point != edge.b && along > m_tolerance
                && along < length - m_tolerance
                && (from - along / length * side).norm() <= m_tolerance)
                found.push_back({along / length, point});
        }
        std::ranges::stable_sort(found, {}, &Hanging::share);
        if (!found.empty())
            m_bySide.emplace(keyOf(edge.a, edge.b), std::move(found));
    }

    const PolygonMesh& m_mesh;
    double m_tolerance; // m
    std::unordered_map<std::uint64_t, std::vector<Hanging>> m_bySide;
};

} // namespace

void joinHangingPoints(PolygonMesh& mesh, double tolerance, MeshReport& report)
{
    if (!(tolerance > 0.0) || mesh.points.empty())
        return;
    const HangingPoints hanging(mesh, tolerance);
    if (hanging.empty())
        return;
    PolygonMesh made;
    std::vector<std::uint8_t> isJoined(mesh.points.size());
    for (std::size_t i = 0; i < mesh.faceCount(); ++i) {
        const std::span<const int> face = mesh.face(i);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const std::size_t next = (k + 1) % face.size();
            const auto texture = [&](std::size_t corner) {
                return mesh.texture[std::size_t(mesh.first[i]) + corner];
            };
            made.corners.push_back(face[k]);
            if (!mesh.texture.empty())
                made.texture.push_back(texture(k));
            for (const Hanging& one : hanging.on(face[k], face[next])) {
                if (std::ranges::find(face, one.point) != face.end())
                    continue; // a face that is folded onto its own side
                isJoined[std::size_t(one.point)] = 1;
                made.corners.push_back(one.point);
                if (mesh.texture.empty())
                    continue;
                const double share = face[k] < face[next] ? one.share : 1.0 - one.share;
                const auto [u, v] = texture(k);
                const auto [nextU, nextV] = texture(next);
                made.texture.push_back({u + share * (nextU - u), v + share * (nextV - v)});
            }
        }
        made.endFace(mesh.object[i], mesh.material[i]);
    }
    mesh.first = std::move(made.first);
    mesh.corners = std::move(made.corners);
    mesh.texture = std::move(made.texture);
    for (std::size_t i = 0; i < isJoined.size(); ++i)
        if (isJoined[i])
            report.add(MeshFault::HangingVertices, mesh.points[i]);
}

} // namespace ripstop
