// Weaves links into a mesh:
// 1. findThreads() sums, for each edge, the area that it stands for: half a cell from either side,
//    or whole triangles; sides are sorted so that an edge is found once.
// 2. Particles, threads along edges, diagonals of cells and links across pairs of triangles
//    follow, each with the width of its strip; two points are tied only once.
// 3. Bend links join ends of edges that go on into each other, the straightestBend pairs first.
// 4. Panels and the mass of the fabric come last. A cancelled import stops between stages.
#include "author/mesh_network.h"

#include "base/angle.h"
#include "derived/flat_panel.h"
#include "derived/link_stiffness.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace ripstop {
namespace {

constexpr double straightestBend = 0.70710678; // cosine of the turn over which a bend link goes
constexpr std::size_t mostEdges = 64;          // of a particle whose edges are looked at in pairs
constexpr int betweenReports = 8192;

struct Thread
{
    int a; // point indices, a < b
    int b;
    double area;                 // m^2, that it stands for
    double squaredAspects;       // m^2, of the cells beside it (FabricStrip), times their areas
    std::array<int, 2> opposite; // corners of the triangles beside it; -1 for those of cells
    int sides;                   // faces beside it
    int material;                // of the file, of the first of these faces
};

class Weaver
{
public:
    Weaver(Network& network, const RepairedMesh& mesh, const Progress& progress)
        : m_network(network)
        , m_mesh(mesh)
        , m_progress(progress)
    {
        for (std::size_t i = 0; i < mesh.mesh.faceCount(); ++i)
            m_isCell.push_back(isCell(mesh.mesh, i) ? 1 : 0);
        findThreads();
    }

    bool weave(const Weave& styles, const WeaveMaterials& materials, double density)
    {
        addParticles();
        const bool isDone =
            (styles.structural == LinkStyle::None || addThreads(styles, materials))
            && (styles.shear == LinkStyle::None
                || (addDiagonals(styles.shear, materials) && addAcross(styles.shear, materials)))
            && (styles.bend == LinkStyle::None || addBends(styles.bend, materials.bend));
        if (!isDone || !goesOn(m_progress, 0.8))
            return false;
        addLines(materials.line);
        for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i) {
            const auto& [a, b, c] = m_mesh.triangles[i];
            m_network.panel(particle(a), particle(b), particle(c),
                            materials.of(materialOf(m_mesh.faceOf[i])));
        }
        addMass(density, materials);
        return goesOn(m_progress, 1.0);
    }

private:
    const Vec3& at(int point) const { return m_mesh.mesh.points[std::size_t(point)]; }
    int materialOf(int face) const { return m_mesh.mesh.material[std::size_t(face)]; }
    Id particle(int point) const { return m_particles[std::size_t(point)]; }

    // m, of a cell as if it were a rectangle: the first and the third side, the two others.
    std::pair<double, double> sidesOfCell(std::size_t face) const
    {
        const std::span<const int> corner = m_mesh.mesh.face(face);
        const auto side = [&](std::size_t k) {
            return (at(corner[(k + 1) % 4]) - at(corner[k])).norm();
        };
        return {0.5 * (side(0) + side(2)), 0.5 * (side(1) + side(3))};
    }

    void addParticles()
    {
        for (std::size_t i = 0; i < m_mesh.mesh.points.size(); ++i) {
            m_particles.push_back(m_network.particle(m_mesh.mesh.points[i]));
            if (!m_mesh.texture.empty())
                m_network.texture(m_particles.back(), m_mesh.texture[i][0], m_mesh.texture[i][1]);
        }
    }

    void findThreads()
    {
        std::vector<Thread> sides;
        const auto add = [&](int a, int b, double area, double aspect, int opposite, int face) {
            sides.push_back({std::min(a, b),
                             std::max(a, b),
                             area,
                             area * aspect * aspect,
                             {opposite, -1},
                             1,
                             materialOf(face)});
        };
        for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t) {
            if (m_isCell[std::size_t(m_mesh.faceOf[t])])
                continue;
            const auto& [a, b, c] = m_mesh.triangles[t];
            const double area = 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).norm();
            const int face = m_mesh.faceOf[t];
            add(a, b, area, 1.0, c, face);
            add(b, c, area, 1.0, a, face);
            add(c, a, area, 1.0, b, face);
        }
        for (std::size_t i = 0; i < m_isCell.size(); ++i) {
            if (!m_isCell[i])
                continue;
            const std::span<const int> corners = m_mesh.mesh.face(i);
            const double half = 0.25 * doubleArea(corners, m_mesh.mesh.points).norm();
            const auto [p, q] = sidesOfCell(i);
            for (std::size_t c = 0; c < 4; ++c)
                add(corners[c], corners[(c + 1) % 4], half, c % 2 == 0 ? p / q : q / p, -1, int(i));
        }
        std::ranges::stable_sort(sides, [](const Thread& s, const Thread& t) {
            return std::pair(s.a, s.b) < std::pair(t.a, t.b);
        });
        for (const Thread& side : sides) {
            if (m_threads.empty() || m_threads.back().a != side.a || m_threads.back().b != side.b) {
                m_threads.push_back(side);
                continue;
            }
            Thread& thread = m_threads.back();
            thread.area += side.area;
            thread.squaredAspects += side.squaredAspects;
            if (thread.sides++ == 1)
                thread.opposite[1] = side.opposite[0];
        }
    }

    // Ties two points; false when they are tied already.
    bool tie(int a, int b, LinkStyle style, Id material, Resists resists = Resists::Both)
    {
        const std::uint64_t key =
            std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
        if (a == b || !m_tied.insert(key).second)
            return false;
        if (style == LinkStyle::Rods)
            m_network.rod(particle(a), particle(b), material, resists);
        else
            m_network.spring(particle(a), particle(b), material);
        return true;
    }

    bool addThreads(const Weave& styles, const WeaveMaterials& materials)
    {
        const bool hasDiagonals = styles.shear != LinkStyle::None; // which resist along threads
        for (std::size_t i = 0; i < m_threads.size(); ++i) {
            if (i % betweenReports == 0
                && !goesOn(m_progress, 0.3 * double(i) / double(m_threads.size())))
                return false;
            const Thread& thread = m_threads[i];
            if (tie(thread.a, thread.b, styles.structural, materials.of(thread.material)))
                m_network.asFabric(
                    {LinkRole::Thread, thread.area / (at(thread.b) - at(thread.a)).norm(),
                     hasDiagonals
                         ? aspectOfCells(std::sqrt(thread.squaredAspects), std::sqrt(thread.area))
                         : 1.0});
        }
        return true;
    }

    bool addDiagonals(LinkStyle style, const WeaveMaterials& materials)
    {
        for (std::size_t i = 0; i < m_isCell.size(); ++i) {
            if (!m_isCell[i])
                continue;
            const std::span<const int> corner = m_mesh.mesh.face(i);
            const auto [p, q] = sidesOfCell(i);
            const double width = biasWidth(p, q);
            for (const std::size_t from : {0u, 1u})
                if (tie(corner[from], corner[from + 2], style, materials.of(materialOf(int(i)))))
                    m_network.asFabric({LinkRole::Bias, width});
        }
        return goesOn(m_progress, 0.4);
    }

    bool addAcross(LinkStyle style, const WeaveMaterials& materials)
    {
        for (std::size_t i = 0; i < m_threads.size(); ++i) {
            if (i % betweenReports == 0
                && !goesOn(m_progress, 0.4 + 0.2 * double(i) / double(m_threads.size())))
                return false;
            const Thread& thread = m_threads[i];
            const auto [from, to] = thread.opposite;
            if (thread.sides != 2 || from < 0 || to < 0
                || !tie(from, to, style, materials.of(thread.material)))
                continue;
            m_network.asFabric(
                {LinkRole::Bias, 8.0 / 3.0 * thread.area / (at(to) - at(from)).norm()});
        }
        return true;
    }

    bool addBends(LinkStyle style, Id material)
    {
        std::vector<std::vector<int>> beside(m_mesh.mesh.points.size());
        for (const Thread& thread : m_threads) {
            beside[std::size_t(thread.a)].push_back(thread.b);
            beside[std::size_t(thread.b)].push_back(thread.a);
        }
        for (std::size_t i = 0; i < beside.size(); ++i) {
            if (i % betweenReports == 0
                && !goesOn(m_progress, 0.6 + 0.2 * double(i) / double(beside.size())))
                return false;
            if (beside[i].size() <= mostEdges)
                addBendsAt(int(i), beside[i], style, material);
        }
        return true;
    }

    void addLines(Id material)
    {
        for (const auto& [a, b] : m_mesh.mesh.lines)
            tie(a, b, LinkStyle::Rods, material, Resists::Tension);
    }

    void addMass(double density, const WeaveMaterials& materials)
    {
        m_network.addFabricMass(density);
        if (materials.line != noId)
            m_network.addLinkMass(materials.line, materials.lineDensity);
        const std::vector<double>& said = m_mesh.mesh.mass;
        for (std::size_t i = 0; i < said.size(); ++i)
            if (said[i] > 0.0)
                m_network.row(particle(int(i))).mass = said[i];
    }

    void addBendsAt(int middle, const std::vector<int>& ends, LinkStyle style, Id material)
    {
        struct Pair
        {
            double cosine;
            std::size_t i;
            std::size_t k;
        };
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t k = i + 1; k < ends.size(); ++k) {
                const Vec3 in = (at(middle) - at(ends[i])).normalized();
                const Vec3 out = (at(ends[k]) - at(middle)).normalized();
                if (in.dot(out) > straightestBend)
                    pairs.push_back({in.dot(out), i, k});
            }
        std::ranges::stable_sort(pairs, std::greater(), &Pair::cosine);
        std::vector<std::uint8_t> isTaken(ends.size());
        for (const Pair& pair : pairs) {
            if (isTaken[pair.i] || isTaken[pair.k])
                continue;
            isTaken[pair.i] = isTaken[pair.k] = 1;
            tie(ends[pair.i], ends[pair.k], style, material);
        }
    }

    Network& m_network;
    const RepairedMesh& m_mesh;
    const Progress& m_progress;
    std::vector<std::uint8_t> m_isCell; // [faces]
    std::vector<Thread> m_threads;      // ascending by a, then b
    std::vector<Id> m_particles;        // [points]
    std::unordered_set<std::uint64_t> m_tied;
};

} // namespace

std::string_view linkStyleName(LinkStyle style)
{
    constexpr std::array<std::string_view, 3> names{"none", "springs", "rods"};
    return names[std::size_t(style)];
}

bool isCell(const PolygonMesh& mesh, std::size_t face)
{
    return isConvexQuad(mesh.face(face), mesh.points);
}

std::vector<Vec3> warpsOf(const RepairedMesh& mesh)
{
    const PolygonMesh& faces = mesh.mesh;
    std::vector<Vec3> warps;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto face = std::size_t(mesh.faceOf[i]);
        const std::span<const int> corners = faces.face(face);
        std::array<Vec3, 3> places;
        std::array<PolygonMesh::TexturePoint, 3> texture{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int point = mesh.triangles[i][k];
            places[k] = faces.points[std::size_t(point)];
            const auto corner = std::ranges::find(corners, point) - corners.begin();
            if (!faces.texture.empty())
                texture[k] = faces.texture[std::size_t(faces.first[face] + corner)];
        }
        warps.push_back(uprightWarp(places, texture));
    }
    return warps;
}

double warpsOffThreads(const RepairedMesh& mesh)
{
    const PolygonMesh& faces = mesh.mesh;
    if (faces.texture.empty() || mesh.triangles.empty())
        return 0.0;
    const std::vector<Vec3> warps = warpsOf(mesh);
    double sum = 0.0;
    for (std::size_t i = 0; i < warps.size(); ++i) {
        const std::span<const int> corners = faces.face(std::size_t(mesh.faceOf[i]));
        double along = 0.0; // cosine of the angle to the nearest edge
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec3 edge = faces.points[std::size_t(corners[(k + 1) % corners.size()])]
                              - faces.points[std::size_t(corners[k])];
            const double size = edge.norm() * warps[i].norm();
            along = std::max(along, size > 0.0 ? std::abs(edge.dot(warps[i])) / size : 1.0);
        }
        sum += std::acos(std::min(1.0, along)) / degrees;
    }
    return sum / double(warps.size());
}

bool weaveInto(Network& network, const RepairedMesh& mesh, const Weave& weave,
               const WeaveMaterials& materials, double density, const Progress& progress)
{
    return Weaver(network, mesh, progress).weave(weave, materials, density);
}

} // namespace ripstop
