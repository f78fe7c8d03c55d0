// The tree over a mesh and the questions to it:
// 1. The constructor leaves out triangles without area and halves the faces at the middle of the
//    longest axis until four or fewer are left; equal middles are ordered by corner, so that the
//    tree does not depend on the sort.
// 2. findNormals() sums the normals at edges and corners, and sees whether each edge is gone once
//    each way, which makes the mesh closed.
// 3. firstHit() and nearest() walk the tree with a stack of fixed size.
// 4. touchMesh() brings a way back to the side it came from, face by face, at most four times;
//    then it keeps the margin; then, if asked, it brings a point that is inside a closed mesh out.
#include "shapes/triangle_tree.h"

#include "shapes/triangle_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ripstop {
namespace {

constexpr int mostInLeaf = 4;
constexpr int deepest = 64; // of the tree: halving at each level, it cannot be exceeded

Vec3 middle(const std::vector<Vec3>& points, const TriangleTree::Face& face)
{
    return (points[std::size_t(face.corner[0])] + points[std::size_t(face.corner[1])]
            + points[std::size_t(face.corner[2])])
           / 3.0;
}

// The square of the distance to a box.
double squaredDistance(const Vec3& low, const Vec3& high, const Vec3& point)
{
    return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
}

// Whether a way meets a box before `share` of it (slabs).
bool meets(const Vec3& low, const Vec3& high, const Vec3& from, const Vec3& way, double share)
{
    double in = 0.0, out = share;
    for (int i = 0; i < 3; ++i) {
        if (way[i] == 0.0) {
            if (from[i] < low[i] || from[i] > high[i])
                return false;
            continue;
        }
        const double a = (low[i] - from[i]) / way[i], b = (high[i] - from[i]) / way[i];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    return in <= out * (1.0 + 1e-12) + 1e-12;
}

// Share of the way where it meets the triangle (Moeller and Trumbore 1997), or nothing. Edges are
// a little wide, so that nothing slips through between two triangles.
std::optional<double> meeting(const std::array<Vec3, 3>& x, const Vec3& from, const Vec3& way)
{
    constexpr double wide = 1e-9;
    const Vec3 e1 = x[1] - x[0], e2 = x[2] - x[0];
    const Vec3 p = way.cross(e2);
    const double determinant = e1.dot(p);
    if (determinant == 0.0)
        return std::nullopt;
    const Vec3 s = from - x[0];
    const double u = s.dot(p) / determinant;
    const Vec3 q = s.cross(e1);
    const double v = way.dot(q) / determinant;
    const double share = e2.dot(q) / determinant;
    if (u < -wide || v < -wide || u + v > 1.0 + wide || !(share >= 0.0 && share <= 1.0))
        return std::nullopt;
    return share;
}

} // namespace

TriangleTree::TriangleTree(std::vector<Vec3> points,
                           const std::vector<std::array<int, 3>>& triangles)
    : m_points(std::move(points))
{
    m_faces.reserve(triangles.size());
    for (const std::array<int, 3>& corner : triangles) {
        const Vec3& a = m_points[std::size_t(corner[0])];
        const Vec3 area =
            (m_points[std::size_t(corner[1])] - a).cross(m_points[std::size_t(corner[2])] - a);
        if (area.norm() > 0.0)
            m_faces.push_back({corner, area.normalized()});
    }
    if (m_faces.empty())
        return;
    m_nodes.reserve(m_faces.size());
    grow(0, int(m_faces.size()));
    findNormals();
}

int TriangleTree::grow(int first, int last)
{
    const int place = int(m_nodes.size());
    Node node;
    node.low.setConstant(std::numeric_limits<double>::infinity());
    node.high = -node.low;
    Vec3 low = node.low, high = node.high; // of the middles
    for (int i = first; i < last; ++i) {
        const Face& face = m_faces[std::size_t(i)];
        for (const int corner : face.corner) {
            node.low = node.low.cwiseMin(m_points[std::size_t(corner)]);
            node.high = node.high.cwiseMax(m_points[std::size_t(corner)]);
        }
        low = low.cwiseMin(middle(m_points, face));
        high = high.cwiseMax(middle(m_points, face));
    }
    node.first = first;
    node.last = last;
    m_nodes.push_back(node);
    if (last - first <= mostInLeaf)
        return place;

    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const int half = first + (last - first) / 2;
    const auto begin = m_faces.begin();
    std::sort(begin + first, begin + last, [&](const Face& a, const Face& b) {
        const double x = middle(m_points, a)[axis], y = middle(m_points, b)[axis];
        return x != y ? x < y : a.corner < b.corner;
    });
    grow(first, half);
    const int second = grow(half, last);
    m_nodes[std::size_t(place)].second = second;
    return place;
}

void TriangleTree::findNormals()
{
    m_cornerNormal.assign(m_points.size(), Vec3::Zero());
    m_edgeNormal.resize(m_faces.size());
    struct Edge
    {
        Vec3 normal = Vec3::Zero();
        int there = 0; // times that it is gone from its lower to its higher end
        int back = 0;
    };
    std::map<std::pair<int, int>, Edge> edges;
    const auto edgeOf = [&](const Face& face, int k) -> Edge& {
        return edges[std::minmax(face.corner[std::size_t(k)],
                                 face.corner[std::size_t((k + 1) % 3)])];
    };
    for (const Face& face : m_faces)
        for (int k = 0; k < 3; ++k) {
            const Vec3& here = m_points[std::size_t(face.corner[std::size_t(k)])];
            const Vec3 next = m_points[std::size_t(face.corner[std::size_t((k + 1) % 3)])] - here;
            const Vec3 last = m_points[std::size_t(face.corner[std::size_t((k + 2) % 3)])] - here;
            const double angle = std::atan2(next.cross(last).norm(), next.dot(last));
            m_cornerNormal[std::size_t(face.corner[std::size_t(k)])] += angle * face.normal;
            Edge& edge = edgeOf(face, k);
            edge.normal += face.normal;
            const bool there = face.corner[std::size_t(k)] < face.corner[std::size_t((k + 1) % 3)];
            ++(there ? edge.there : edge.back);
        }
    for (std::size_t i = 0; i < m_faces.size(); ++i)
        for (int k = 0; k < 3; ++k)
            m_edgeNormal[i][std::size_t(k)] = edgeOf(m_faces[i], k).normal.normalized();
    for (Vec3& normal : m_cornerNormal)
        normal.normalize();
    m_closed = std::all_of(edges.begin(), edges.end(), [](const auto& edge) {
        return edge.second.there == 1 && edge.second.back == 1;
    });
}

std::optional<TriangleTree::Hit> TriangleTree::firstHit(const Vec3& from, const Vec3& to) const
{
    if (m_nodes.empty())
        return std::nullopt;
    const Vec3 way = to - from;
    std::optional<Hit> best;
    double share = 1.0;
    std::array<int, deepest> waiting;
    int count = 0;
    waiting[std::size_t(count++)] = 0;
    while (count > 0) {
        const int place = waiting[std::size_t(--count)];
        const Node& node = m_nodes[std::size_t(place)];
        if (!meets(node.low, node.high, from, way, share))
            continue;
        if (node.second > 0) {
            waiting[std::size_t(count++)] = node.second;
            waiting[std::size_t(count++)] = place + 1;
            continue;
        }
        for (int i = node.first; i < node.last; ++i) {
            const auto& corner = m_faces[std::size_t(i)].corner;
            const std::optional<double> at =
                meeting({m_points[std::size_t(corner[0])], m_points[std::size_t(corner[1])],
                         m_points[std::size_t(corner[2])]},
                        from, way);
            if (at && (*at < share || !best)) {
                share = *at;
                best = Hit{i, *at};
            }
        }
    }
    return best;
}

TriangleTree::Near TriangleTree::nearOn(int index, const Vec3& point) const
{
    const auto i = std::size_t(index);
    const Face& face = m_faces[i];
    const auto corner = [&](int k) { return std::size_t(face.corner[std::size_t(k)]); };
    const Corners x = {m_points[corner(0)], m_points[corner(1)], m_points[corner(2)]};
    const Vec3 share = nearestShares(x, point);
    const Vec3 place = atShares(x, share);
    const auto normal = [&]() -> Vec3 {
        for (int k = 0; k < 3; ++k)
            if (share[k] == 1.0)
                return m_cornerNormal[corner(k)];
        for (int k = 0; k < 3; ++k) // the edge from corner k + 1 to k + 2
            if (share[k] == 0.0)
                return m_edgeNormal[i][std::size_t(k + 1) % 3];
        return face.normal;
    };
    return Near{index, place, normal(), (point - place).norm()};
}

std::optional<TriangleTree::Near> TriangleTree::nearest(const Vec3& point, double within) const
{
    if (m_nodes.empty())
        return std::nullopt;
    std::optional<Near> best;
    double squared = within * within;
    std::array<int, deepest> waiting;
    int count = 0;
    waiting[std::size_t(count++)] = 0;
    while (count > 0) {
        const int place = waiting[std::size_t(--count)];
        const Node& node = m_nodes[std::size_t(place)];
        if (squaredDistance(node.low, node.high, point) >= squared)
            continue;
        if (node.second > 0) {
            int near = place + 1, far = node.second;
            const Node &one = m_nodes[std::size_t(near)], &other = m_nodes[std::size_t(far)];
            if (squaredDistance(other.low, other.high, point)
                < squaredDistance(one.low, one.high, point))
                std::swap(near, far);
            waiting[std::size_t(count++)] = far;
            waiting[std::size_t(count++)] = near;
            continue;
        }
        for (int i = node.first; i < node.last; ++i) {
            const Near found = nearOn(i, point);
            if (found.distance * found.distance < squared) {
                squared = found.distance * found.distance;
                best = found;
            }
        }
    }
    return best;
}

bool operator==(const TriangleTree& a, const TriangleTree& b)
{
    const auto same = [](const TriangleTree::Face& f, const TriangleTree::Face& g) {
        return f.corner == g.corner;
    };
    return a.m_points == b.m_points
           && std::equal(a.m_faces.begin(), a.m_faces.end(), b.m_faces.begin(), b.m_faces.end(),
                         same);
}

std::optional<Touch> touchMesh(const TriangleTree& mesh, double margin, const Vec3& from,
                               const Vec3& to, bool inside)
{
    constexpr int tries = 4;
    const double gap = std::max(margin, leastMargin * (mesh.high() - mesh.low()).norm());
    std::optional<Touch> touch;
    Vec3 place = to;
    int tried = 0;
    for (; tried < tries; ++tried) {
        const std::optional<TriangleTree::Hit> hit = mesh.firstHit(from, place);
        if (!hit)
            break;
        const TriangleTree::Face& face = mesh.faces()[std::size_t(hit->face)];
        const Vec3& onFace = mesh.points()[std::size_t(face.corner[0])];
        const double side = (from - onFace).dot(face.normal) < 0.0 ? -1.0 : 1.0;
        const Vec3 normal = side * face.normal;
        place -= ((place - onFace).dot(normal) - gap) * normal;
        touch = Touch{place, normal};
    }
    if (tried == tries) // wedged between faces
        return Touch{from, touch->normal};
    const auto near = mesh.nearest(place, gap);
    if (near && near->distance > 0.0 && !(inside && mesh.isClosed())) {
        const Vec3 normal = (place - near->place) / near->distance;
        const Vec3 moved = near->place + gap * normal;
        if (!mesh.firstHit(place, moved)) // not through a face on the other side of a gap
            touch = Touch{moved, normal};
    }
    if (!inside || !mesh.isClosed())
        return touch;
    const auto out = mesh.nearest(place, std::numeric_limits<double>::infinity());
    if (!out) // the place is not a number
        return touch;
    const double depth = (place - out->place).dot(out->normal);
    if (depth >= 0.0 && (depth > 0.0 && out->distance >= gap))
        return touch;
    const Vec3 normal = depth > 0.0 ? Vec3((place - out->place) / out->distance) : out->normal;
    return Touch{out->place + gap * normal, normal};
}

} // namespace ripstop
