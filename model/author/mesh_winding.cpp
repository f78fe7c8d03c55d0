// Winds faces alike, piece by piece:
// 1. FaceNeighbours lists the faces beside each face over edges of exactly two, and whether they
// are
//    wound against each other.
// 2. A walk over each piece notes which faces to turn; the smaller part by area is turned, and a
//    closed piece that can be oriented is turned outwards by the sign of its volume.
// 3. Edges and pieces are reported last: rims, edges of more than two faces, and edges that no
//    turning helps.
#include "author/mesh_winding.h"

#include "base/joined_sets.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

// Whether the face goes from a to b, and not from b to a.
bool goesAlong(std::span<const int> corners, int a, int b)
{
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i] == a && corners[(i + 1) % corners.size()] == b)
            return true;
    return false;
}

// The faces beside each face, over edges of exactly two.
class FaceNeighbours
{
public:
    struct Neighbour
    {
        int face;
        bool isAgainst; // wound against each other
    };

    FaceNeighbours(const PolygonMesh& mesh, const std::vector<MeshEdge>& edges)
        : m_begin(mesh.faceCount() + 1)
    {
        for (const MeshEdge& edge : edges)
            if (edge.faceCount == 2)
                for (const int face : edge.faces)
                    ++m_begin[std::size_t(face) + 1];
        std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
        m_sides.resize(std::size_t(m_begin.back()));
        std::vector<int> next(m_begin.begin(), m_begin.end() - 1);
        for (const MeshEdge& edge : edges) {
            if (edge.faceCount != 2)
                continue;
            const auto [f, g] = edge.faces;
            const bool isAgainst = goesAlong(mesh.face(std::size_t(f)), edge.a, edge.b)
                                   == goesAlong(mesh.face(std::size_t(g)), edge.a, edge.b);
            m_sides[std::size_t(next[std::size_t(f)]++)] = {g, isAgainst};
            m_sides[std::size_t(next[std::size_t(g)]++)] = {f, isAgainst};
        }
    }

    std::span<const Neighbour> of(int face) const
    {
        const auto begin = std::size_t(m_begin[std::size_t(face)]);
        return std::span(m_sides).subspan(begin,
                                          std::size_t(m_begin[std::size_t(face) + 1]) - begin);
    }

private:
    std::vector<int> m_begin; // [faces + 1]
    std::vector<Neighbour> m_sides;
};

Vec3 middleOf(const PolygonMesh& mesh, const MeshEdge& edge)
{
    return 0.5 * (mesh.points[std::size_t(edge.a)] + mesh.points[std::size_t(edge.b)]);
}

// Six times the volume between the face and the origin.
double volumeOf(const PolygonMesh& mesh, int face)
{
    const std::span<const int> corners = mesh.face(std::size_t(face));
    return mesh.points[std::size_t(corners[0])].dot(doubleArea(corners, mesh.points));
}

class Winding
{
public:
    Winding(PolygonMesh& mesh, const std::vector<MeshEdge>& edges, MeshReport& report)
        : m_mesh(mesh)
        , m_edges(edges)
        , m_report(report)
        , m_neighbours(mesh, edges)
        , m_turned(mesh.faceCount(), unseen)
        , m_isOpen(mesh.faceCount())
    {}

    void unify()
    {
        for (const MeshEdge& edge : m_edges)
            if (edge.faceCount != 2)
                for (const int face : edge.faces)
                    if (face >= 0)
                        m_isOpen[std::size_t(face)] = 1;
        for (int face = 0; face < int(m_turned.size()); ++face)
            if (m_turned[std::size_t(face)] == unseen)
                unifyPiece(face);
        for (std::size_t i = 0; i < m_turned.size(); ++i)
            if (m_turned[i])
                std::reverse(m_mesh.corners.begin() + m_mesh.first[i] + 1,
                             m_mesh.corners.begin() + m_mesh.first[i + 1]);
        if (!m_mesh.texture.empty())
            for (std::size_t i = 0; i < m_turned.size(); ++i)
                if (m_turned[i])
                    std::reverse(m_mesh.texture.begin() + m_mesh.first[i] + 1,
                                 m_mesh.texture.begin() + m_mesh.first[i + 1]);
    }

private:
    static constexpr std::uint8_t unseen = 2;

    // Winds all faces alike that edges of two faces connect with this one.
    void unifyPiece(int start)
    {
        std::vector<int> faces{start};
        m_turned[std::size_t(start)] = 0;
        bool isOriented = true;
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (const FaceNeighbours::Neighbour& side : m_neighbours.of(faces[i])) {
                const std::uint8_t wanted = m_turned[std::size_t(faces[i])] ^ int(side.isAgainst);
                std::uint8_t& turned = m_turned[std::size_t(side.face)];
                if (turned == unseen) {
                    turned = wanted;
                    faces.push_back(side.face);
                } else {
                    isOriented = isOriented && turned == wanted;
                }
            }
        turnSmallerPart(faces);
        const bool isClosed = isOriented && std::ranges::none_of(faces, [&](int face) {
                                  return m_isOpen[std::size_t(face)];
                              });
        if (isClosed)
            turnOutwards(faces);
    }

    void turnAll(const std::vector<int>& faces)
    {
        for (const int face : faces)
            m_turned[std::size_t(face)] ^= 1;
    }

    void turnSmallerPart(const std::vector<int>& faces)
    {
        double area[2]{};
        std::size_t count[2]{};
        for (const int face : faces) {
            const std::uint8_t turned = m_turned[std::size_t(face)];
            area[turned] += doubleArea(m_mesh.face(std::size_t(face)), m_mesh.points).norm();
            ++count[turned];
        }
        if (count[1] > 0 && area[1] > area[0])
            turnAll(faces);
        for (const int face : faces)
            if (m_turned[std::size_t(face)])
                m_report.add(MeshFault::FlippedFaces,
                             m_mesh.points[std::size_t(m_mesh.face(std::size_t(face))[0])]);
    }

    void turnOutwards(const std::vector<int>& faces)
    {
        double volume = 0.0;
        for (const int face : faces)
            volume += (m_turned[std::size_t(face)] ? -1.0 : 1.0) * volumeOf(m_mesh, face);
        if (volume >= 0.0)
            return;
        turnAll(faces);
        m_report.add(MeshFault::InsideOutShells,
                     m_mesh.points[std::size_t(m_mesh.face(std::size_t(faces[0]))[0])]);
    }

    PolygonMesh& m_mesh;
    const std::vector<MeshEdge>& m_edges;
    MeshReport& m_report;
    FaceNeighbours m_neighbours;
    std::vector<std::uint8_t> m_turned; // [faces]
    std::vector<std::uint8_t> m_isOpen; // [faces] has an edge that is not of two faces
};

void reportEdges(const PolygonMesh& mesh, const std::vector<MeshEdge>& edges, MeshReport& report)
{
    JoinedSets rims(mesh.points.size());
    std::vector<std::uint8_t> isOnRim(mesh.points.size());
    for (const MeshEdge& edge : edges) {
        if (edge.faceCount > 2)
            report.add(MeshFault::NonManifoldEdges, middleOf(mesh, edge));
        if (edge.faceCount == 2
            && goesAlong(mesh.face(std::size_t(edge.faces[0])), edge.a, edge.b)
                   == goesAlong(mesh.face(std::size_t(edge.faces[1])), edge.a, edge.b))
            report.add(MeshFault::OneSidedEdges, middleOf(mesh, edge));
        if (edge.faceCount != 1)
            continue;
        report.add(MeshFault::OpenEdges, middleOf(mesh, edge));
        rims.join(edge.a, edge.b);
        isOnRim[std::size_t(edge.a)] = isOnRim[std::size_t(edge.b)] = 1;
    }
    std::size_t count = 0;
    for (int i = 0; i < int(isOnRim.size()); ++i)
        count += isOnRim[std::size_t(i)] && rims.of(i) == i ? 1 : 0;
    report.setOf(MeshFault::OpenEdges, count);
}

void reportPieces(const PolygonMesh& mesh, MeshReport& report)
{
    JoinedSets pieces(mesh.points.size());
    for (std::size_t i = 0; i < mesh.faceCount(); ++i)
        for (const int corner : mesh.face(i))
            pieces.join(mesh.face(i)[0], corner);
    for (const auto& [a, b] : mesh.lines)
        pieces.join(a, b);
    for (int i = 0; i < int(mesh.points.size()); ++i)
        if (pieces.of(i) == i)
            report.add(MeshFault::SeveralShells, mesh.points[std::size_t(i)]);
}

} // namespace

std::vector<MeshEdge> edgesOf(const PolygonMesh& mesh)
{
    struct FaceSide
    {
        int a;
        int b;
        int face;
    };
    std::vector<FaceSide> sides;
    sides.reserve(mesh.corners.size());
    for (std::size_t i = 0; i < mesh.faceCount(); ++i) {
        const std::span<const int> corners = mesh.face(i);
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const int a = corners[c];
            const int b = corners[(c + 1) % corners.size()];
            sides.push_back({std::min(a, b), std::max(a, b), int(i)});
        }
    }
    std::ranges::sort(sides, [](const FaceSide& s, const FaceSide& t) {
        return std::tie(s.a, s.b, s.face) < std::tie(t.a, t.b, t.face);
    });
    std::vector<MeshEdge> edges;
    for (const FaceSide& side : sides) {
        if (edges.empty() || edges.back().a != side.a || edges.back().b != side.b)
            edges.push_back({side.a, side.b, {-1, -1}, 0});
        MeshEdge& edge = edges.back();
        if (edge.faceCount < 2)
            edge.faces[std::size_t(edge.faceCount)] = side.face;
        ++edge.faceCount;
    }
    return edges;
}

void unifyWindings(PolygonMesh& mesh, const std::vector<MeshEdge>& edges, MeshReport& report)
{
    Winding(mesh, edges, report).unify();
    reportEdges(mesh, edges, report);
    reportPieces(mesh, report);
}

} // namespace ripstop
