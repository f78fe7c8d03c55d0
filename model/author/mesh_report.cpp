// The words for each fault of a mesh are one table, in the order of MeshFault; the report counts
// faults, remembers the first places of each, and lists the grave ones first.
#include "author/mesh_report.h"

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

struct Words
{
    std::string_view name;
    MeshGravity gravity;
    Message one;
    Message many; // the gap is for their number
};

// clang-format off
const std::array<Words, meshFaultCount> table{{
    {"loose_vertices",     MeshGravity::Repaired, Message("1 vertex belongs to no face: left out."), Message("%1 vertices belong to no face: left out.")},
    {"duplicate_vertices", MeshGravity::Repaired, Message("1 vertex lies on another one: joined."), Message("%1 vertices lie on another one: joined.")},
    {"hanging_vertices",   MeshGravity::Repaired, Message("1 vertex lies on a side of a face: joined to it."), Message("%1 vertices lie on sides of faces: joined to them.")},
    {"degenerate_faces",   MeshGravity::Repaired, Message("1 face has no area: left out."), Message("%1 faces have no area: left out.")},
    {"duplicate_faces",    MeshGravity::Repaired, Message("1 face has the corners of another one: left out."), Message("%1 faces have the corners of another one: left out.")},
    {"non_manifold_edges", MeshGravity::Warning,  Message("1 edge belongs to more than two faces: kept. That is right where a keel or a rib meets a sail; fabric does not resist bending there."), Message("%1 edges belong to more than two faces: kept. That is right where a keel or a rib meets a sail; fabric does not resist bending there.")},
    {"flipped_faces",      MeshGravity::Repaired, Message("1 face was wound against its neighbours: turned over."), Message("%1 faces were wound against their neighbours: turned over.")},
    {"inside_out_shells",  MeshGravity::Repaired, Message("1 closed piece was inside out: turned over."), Message("%1 closed pieces were inside out: turned over.")},
    {"one_sided_edges",    MeshGravity::Warning,  Message("1 edge has no outside: the surface turns over itself like a Moebius strip."), Message("%1 edges have no outside: the surface turns over itself like a Moebius strip.")},
    {"several_shells",     MeshGravity::Note,     Message("The mesh is one piece."), Message("The mesh is %1 pieces that nothing joins. A larger weld tolerance may join those of one part; parts of their own stay apart.")},
    {"open_edges",         MeshGravity::Note,     Message("1 edge belongs to one face only: the rim of the fabric."), Message("%1 edges belong to one face only: the rim of the fabric.")},
    {"warped_polygons",    MeshGravity::Repaired, Message("1 polygon is not flat: a corner lies %1 mm off its plane. The triangles that it became fold it along a diagonal."), Message("%2 polygons are not flat: corners lie up to %1 mm off their planes. The triangles that they became fold them along diagonals.")},
    {"split_polygons",     MeshGravity::Repaired, Message("1 polygon of more than three corners became triangles."), Message("%1 polygons of more than three corners became triangles.")},
    {"texture_seams",      MeshGravity::Note,     Message("1 vertex lies on a seam of the texture: a picture is printed by the first of its texture points. The warp follows each face."), Message("%1 vertices lie on a seam of the texture: a picture is printed by the first of their texture points. The warp follows each face.")},
    {"empty_objects",      MeshGravity::Repaired, Message("1 object, %1, has no face with an area: left out."), Message("%2 objects, %1 the first, have no face with an area: left out.")},
    {"missing_files",      MeshGravity::Warning,  Message("1 file of colours or pictures that the mesh names, %1, was not found: the fabric goes without."), Message("%2 files of colours or pictures that the mesh names, %1 the first, were not found: the fabric goes without.")},
    {"stray_elements",     MeshGravity::Note,     Message("1 line or single point of the file was left out."), Message("%1 lines and single points of the file were left out.")},
    {"odd_size",           MeshGravity::Warning,  Message("The mesh is larger than 30 m or smaller than 5 cm: check its unit."), Message("The mesh is larger than 30 m or smaller than 5 cm: check its unit.")},
}};
// clang-format on

const Words& wordsOf(MeshFault fault) { return table[std::size_t(fault)]; }

// The grave ones first, then what was repaired, then notes.
int rank(const MeshFinding& finding) { return -int(gravityOf(finding.fault)); }

} // namespace

std::string_view meshFaultName(MeshFault fault) { return wordsOf(fault).name; }

MeshGravity gravityOf(MeshFault fault) { return wordsOf(fault).gravity; }

Message MeshFinding::text() const
{
    if (!told.empty())
        return told;
    if (!name.empty())
        return count == 1 ? wordsOf(fault).one.with(name) : wordsOf(fault).many.with(name, count);
    if (fault == MeshFault::WarpedPolygons) {
        const Message millimetres = Message::number("%.3g", 1e3 * farthest);
        return count == 1 ? wordsOf(fault).one.with(millimetres)
                          : wordsOf(fault).many.with(millimetres, count);
    }
    if (count == 1)
        return wordsOf(fault).one;
    if (fault == MeshFault::OpenEdges && of != 1)
        return Message("%1 edges belong to one face only: the rim of the fabric, in %2 rims.",
                       count, of);
    return wordsOf(fault).many.with(count);
}

std::vector<MeshFinding> MeshReport::none()
{
    std::vector<MeshFinding> findings;
    for (int i = 0; i < meshFaultCount; ++i)
        findings.push_back({MeshFault(i), 0, 0, {}, {}});
    return findings;
}

void MeshReport::add(MeshFault fault, const Vec3& place, std::size_t count)
{
    MeshFinding& finding = m_findings[std::size_t(fault)];
    finding.count += count;
    if (finding.places.size() < MeshFinding::mostPlaces)
        finding.places.push_back(place);
}

void MeshReport::add(MeshFault fault, std::size_t count)
{
    m_findings[std::size_t(fault)].count += count;
}

void MeshReport::tell(MeshFault fault, Message told)
{
    m_findings[std::size_t(fault)].count = 1;
    m_findings[std::size_t(fault)].told = std::move(told);
}

void MeshReport::addNamed(MeshFault fault, const std::string& name)
{
    MeshFinding& finding = m_findings[std::size_t(fault)];
    if (finding.count++ == 0)
        finding.name = name;
}

void MeshReport::addWarped(const Vec3& place, double distance)
{
    add(MeshFault::WarpedPolygons, place);
    double& farthest = m_findings[std::size_t(MeshFault::WarpedPolygons)].farthest;
    farthest = std::max(farthest, distance);
}

void MeshReport::add(const MeshReport& other)
{
    for (std::size_t i = 0; i < m_findings.size(); ++i) {
        MeshFinding& finding = m_findings[i];
        finding.count += other.m_findings[i].count;
        finding.of += other.m_findings[i].of;
        finding.farthest = std::max(finding.farthest, other.m_findings[i].farthest);
        for (const Vec3& place : other.m_findings[i].places)
            if (finding.places.size() < MeshFinding::mostPlaces)
                finding.places.push_back(place);
    }
}

std::vector<MeshFinding> MeshReport::findings() const
{
    std::vector<MeshFinding> found;
    for (const MeshFinding& finding : m_findings)
        if (finding.count > 0 && !(finding.fault == MeshFault::SeveralShells && finding.count == 1))
            found.push_back(finding);
    std::ranges::stable_sort(found, {}, rank);
    return found;
}

} // namespace ripstop
