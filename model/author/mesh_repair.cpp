// Repairs a mesh by eight stages, listed in make(): points that lie on each other are joined,
// faces without area and then double faces are left out, then points that no face uses any more;
// points on sides of faces become corners of these (mesh_hanging.h), windings are made alike
// (mesh_winding.h), corners of the texture become points of it, and
// polygons become triangles. Each stage relies on those before it and reports what it did; between
// stages the import may be cancelled. byObject() cuts a mesh into one for each object beforehand.
#include "author/mesh_repair.h"

#include "author/mesh_hanging.h"
#include "author/mesh_winding.h"
#include "shapes/lines_within.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ripstop {
namespace {

// A face is none when its area is below this share of the square of its longest side.
constexpr double noArea = 1e-9;

// A polygon is flat when its corners are this near to its plane, as a share of a side of a square
// of twice its area: nearer than fabric or a figure of it could tell.
constexpr double flatWithin = 1e-3;

Vec3 middleOf(std::span<const int> corners, const std::vector<Vec3>& points)
{
    Vec3 sum = Vec3::Zero();
    for (const int corner : corners)
        sum += points[std::size_t(corner)];
    return sum / double(corners.size());
}

bool hasArea(std::span<const int> corners, const std::vector<Vec3>& points)
{
    double longest = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& a = points[std::size_t(corners[i])];
        const Vec3& b = points[std::size_t(corners[(i + 1) % corners.size()])];
        longest = std::max(longest, (b - a).squaredNorm());
    }
    return 0.5 * doubleArea(corners, points).norm() > noArea * longest;
}

class Repair
{
public:
    Repair(PolygonMesh mesh, double tolerance)
        : m_tolerance(tolerance)
    {
        m_result.mesh = std::move(mesh);
    }

    Result<RepairedMesh> make(const Progress& progress)
    {
        using Stage = void (Repair::*)();
        constexpr Stage stages[]{
            &Repair::joinPoints, &Repair::keepSoundFaces,  &Repair::dropDuplicates,
            &Repair::dropLines,  &Repair::dropLoosePoints, &Repair::joinHanging,
            &Repair::windAlike,  &Repair::placeTexture,    &Repair::split};
        double done = 0.0;
        for (const Stage stage : stages) {
            if (!goesOn(progress, done / double(std::size(stages))))
                return Failure{"The import was cancelled."};
            (this->*stage)();
            ++done;
            if (m_result.mesh.faceCount() == 0)
                return Failure{"No face of the mesh has an area; lower the weld tolerance, or "
                               "check the mesh in a mesh program."};
        }
        if (m_result.mesh.strayElements > 0)
            report().add(MeshFault::StrayElements, m_result.mesh.strayElements);
        return std::move(m_result);
    }

private:
    PolygonMesh& mesh() { return m_result.mesh; }
    MeshReport& report() { return m_result.report; }

    // Points that no face uses are reported and left out first, so that nothing is joined with
    // them.
    void joinPoints()
    {
        std::vector<std::uint8_t> isUsed(mesh().points.size());
        for (const int corner : mesh().corners)
            isUsed[std::size_t(corner)] = 1;
        for (const auto& [a, b] : mesh().lines)
            isUsed[std::size_t(a)] = isUsed[std::size_t(b)] = 1;
        std::vector<Vec3> used;
        std::vector<double> mass;
        std::vector<int> placeOf(mesh().points.size(), -1);
        for (std::size_t i = 0; i < isUsed.size(); ++i) {
            if (!isUsed[i]) {
                report().add(MeshFault::LooseVertices, mesh().points[i]);
                continue;
            }
            placeOf[i] = int(used.size());
            used.push_back(mesh().points[i]);
            if (!mesh().mass.empty())
                mass.push_back(mesh().mass[i]);
        }
        mesh().points = std::move(used);
        mesh().mass = std::move(mass);
        const std::vector<int> target = welded(mesh().points, m_tolerance);
        for (std::size_t i = 0; i < target.size(); ++i)
            if (target[i] != int(i))
                report().add(MeshFault::DuplicateVertices, mesh().points[i]);
        const auto joined = [&](int point) {
            return target[std::size_t(placeOf[std::size_t(point)])];
        };
        for (int& corner : mesh().corners)
            corner = joined(corner);
        for (auto& [a, b] : mesh().lines) {
            a = joined(a);
            b = joined(b);
        }
        std::erase_if(mesh().lines, [](const auto& ends) { return ends[0] == ends[1]; });
        for (std::size_t i = 0; i < mesh().mass.size(); ++i)
            if (target[i] != int(i)) // what is joined weighs what it did
                mesh().mass[std::size_t(target[i])] += mesh().mass[i];
    }

    // Keeps faces for which `keep(i, corners)` says so; it may take corners away.
    template <typename Keep>
    void filterFaces(Keep keep)
    {
        PolygonMesh kept;
        std::vector<int> places; // of the corners of a face in the old mesh
        for (std::size_t i = 0; i < mesh().faceCount(); ++i) {
            places.clear();
            for (int c = mesh().first[i]; c < mesh().first[i + 1]; ++c)
                places.push_back(c);
            if (!keep(i, places))
                continue;
            for (const int c : places) {
                kept.corners.push_back(mesh().corners[std::size_t(c)]);
                if (!mesh().texture.empty())
                    kept.texture.push_back(mesh().texture[std::size_t(c)]);
            }
            kept.endFace(mesh().object[i], mesh().material[i]);
        }
        mesh().first = std::move(kept.first);
        mesh().corners = std::move(kept.corners);
        mesh().texture = std::move(kept.texture);
        mesh().object = std::move(kept.object);
        mesh().material = std::move(kept.material);
    }

    void keepSoundFaces()
    {
        std::vector<int> corners;
        filterFaces([&](std::size_t i, std::vector<int>& places) {
            const auto point = [&](int place) { return mesh().corners[std::size_t(place)]; };
            // Corners that joining has put on the one before are left out.
            const Vec3 place = middleOf(mesh().face(i), mesh().points);
            const auto same = [&](int a, int b) { return point(a) == point(b); };
            places.erase(std::unique(places.begin(), places.end(), same), places.end());
            while (places.size() > 1 && same(places.front(), places.back()))
                places.pop_back();
            corners.clear();
            for (const int one : places)
                corners.push_back(point(one));
            bool isSound = corners.size() >= 3 && hasArea(corners, mesh().points);
            std::ranges::sort(corners);
            isSound = isSound && std::ranges::adjacent_find(corners) == corners.end();
            if (!isSound)
                report().add(MeshFault::DegenerateFaces, place);
            return isSound;
        });
    }

    // Two faces are the same when their corners are, whichever way they are wound.
    void dropDuplicates()
    {
        const std::size_t count = mesh().faceCount();
        std::vector<int> sorted = mesh().corners;
        for (std::size_t i = 0; i < count; ++i)
            std::sort(sorted.begin() + mesh().first[i], sorted.begin() + mesh().first[i + 1]);
        const auto corners = [&](int i) {
            return std::span<const int>(sorted).subspan(std::size_t(mesh().first[std::size_t(i)]),
                                                        mesh().face(std::size_t(i)).size());
        };
        std::vector<int> order(count);
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, [&](int a, int b) {
            return std::ranges::lexicographical_compare(corners(a), corners(b));
        });
        std::vector<std::uint8_t> isDouble(count);
        for (std::size_t i = 1; i < count; ++i)
            isDouble[std::size_t(order[i])] =
                std::ranges::equal(corners(order[i - 1]), corners(order[i])) ? 1 : 0;
        if (std::ranges::find(isDouble, 1) == isDouble.end())
            return;
        filterFaces([&](std::size_t i, const std::vector<int>&) {
            if (isDouble[i])
                report().add(MeshFault::DuplicateFaces, middleOf(mesh().face(i), mesh().points));
            return !isDouble[i];
        });
    }

    // Leaves out lines that joining points has laid along faces.
    void dropLines()
    {
        const std::vector<std::uint8_t> within = linesWithinFaces(mesh());
        std::vector<std::array<int, 2>> kept;
        for (std::size_t i = 0; i < within.size(); ++i)
            if (!within[i])
                kept.push_back(mesh().lines[i]);
        mesh().strayElements += within.size() - kept.size();
        mesh().lines = std::move(kept);
    }

    // Leaves out the points that joining and leaving out faces have left without a face.
    void dropLoosePoints()
    {
        std::vector<int> placeOf(mesh().points.size(), -1);
        for (const int corner : mesh().corners)
            placeOf[std::size_t(corner)] = 0;
        for (const auto& [a, b] : mesh().lines)
            placeOf[std::size_t(a)] = placeOf[std::size_t(b)] = 0;
        std::vector<Vec3> used;
        std::vector<double> mass;
        for (std::size_t i = 0; i < placeOf.size(); ++i)
            if (placeOf[i] == 0) {
                placeOf[i] = int(used.size());
                used.push_back(mesh().points[i]);
                if (!mesh().mass.empty())
                    mass.push_back(mesh().mass[i]);
            }
        mesh().points = std::move(used);
        mesh().mass = std::move(mass);
        for (int& corner : mesh().corners)
            corner = placeOf[std::size_t(corner)];
        for (auto& [a, b] : mesh().lines) {
            a = placeOf[std::size_t(a)];
            b = placeOf[std::size_t(b)];
        }
    }

    void joinHanging() { joinHangingPoints(mesh(), m_tolerance, report()); }

    void windAlike()
    {
        m_result.edges = edgesOf(mesh());
        unifyWindings(mesh(), m_result.edges, report());
    }

    void placeTexture()
    {
        if (mesh().texture.empty())
            return;
        std::vector<std::uint8_t> has(mesh().points.size()); // 1: a texture point, 2: several
        m_result.texture.resize(mesh().points.size());
        for (std::size_t i = 0; i < mesh().corners.size(); ++i) {
            const std::size_t point = std::size_t(mesh().corners[i]);
            if (std::isnan(mesh().texture[i][0]))
                continue;
            if (has[point] == 0) {
                m_result.texture[point] = mesh().texture[i];
                has[point] = 1;
            } else if (has[point] == 1 && m_result.texture[point] != mesh().texture[i]) {
                has[point] = 2;
                report().add(MeshFault::TextureSeams, mesh().points[point]);
            }
        }
    }

    void split()
    {
        for (std::size_t i = 0; i < mesh().faceCount(); ++i) {
            const std::span<const int> corners = mesh().face(i);
            splitPolygon(corners, mesh().points, m_result.triangles);
            m_result.faceOf.resize(m_result.triangles.size(), int(i));
            if (corners.size() <= 3)
                continue;
            const Vec3 middle = middleOf(corners, mesh().points);
            report().add(MeshFault::SplitPolygons, middle);
            const double size = std::sqrt(doubleArea(corners, mesh().points).norm()); // m
            const double off = distanceFromPlane(corners, mesh().points);
            if (off > std::max(m_tolerance, flatWithin * size))
                report().addWarped(middle, off);
        }
    }

    double m_tolerance; // m
    RepairedMesh m_result;
};

} // namespace

Result<RepairedMesh> repaired(PolygonMesh mesh, double weldTolerance, const Progress& progress)
{
    return Repair(std::move(mesh), weldTolerance).make(progress);
}

std::vector<PolygonMesh> byObject(const PolygonMesh& mesh)
{
    if (mesh.objects.size() == 1)
        return {mesh};
    std::vector<PolygonMesh> meshes(mesh.objects.size());
    std::vector<std::vector<int>> facesOf(mesh.objects.size());
    for (std::size_t i = 0; i < mesh.faceCount(); ++i)
        facesOf[std::size_t(mesh.object[i])].push_back(int(i));
    std::vector<int> placeOf(mesh.points.size(), -1);
    for (std::size_t object = 0; object < meshes.size(); ++object) {
        PolygonMesh& one = meshes[object];
        one.objects = {mesh.objects[object]};
        one.materials = mesh.materials;
        std::vector<int> used;
        for (const int face : facesOf[object])
            for (const int corner : mesh.face(std::size_t(face)))
                if (std::exchange(placeOf[std::size_t(corner)], 0) < 0)
                    used.push_back(corner);
        std::ranges::sort(used);
        for (const int point : used) {
            placeOf[std::size_t(point)] = int(one.points.size());
            one.points.push_back(mesh.points[std::size_t(point)]);
        }
        for (const int face : facesOf[object]) {
            const int begin = mesh.first[std::size_t(face)];
            for (int c = begin; c < mesh.first[std::size_t(face) + 1]; ++c) {
                one.corners.push_back(placeOf[std::size_t(mesh.corners[std::size_t(c)])]);
                if (!mesh.texture.empty())
                    one.texture.push_back(mesh.texture[std::size_t(c)]);
            }
            one.endFace(0, mesh.material[std::size_t(face)]);
        }
        for (const int point : used)
            placeOf[std::size_t(point)] = -1;
    }
    std::erase_if(meshes, [](const PolygonMesh& one) { return one.faceCount() == 0; });
    return meshes;
}

} // namespace ripstop
