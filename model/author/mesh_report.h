// What is wrong with a mesh, and what was done about it: a count for each kind of fault and the
// first few places, m. Repair and import fill a report, and the import dialog and the command line
// show it. The words and the gravity of each fault are one table in the source.
#pragma once

#include "base/message.h"
#include "base/vec3.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

enum class MeshFault {
    LooseVertices,     // no face uses them: left out
    DuplicateVertices, // within the weld tolerance of another one: joined
    HangingVertices,   // within the weld tolerance of a side of a face: made a corner of it
    DegenerateFaces,   // without area: left out
    DuplicateFaces,    // with the corners of another one: left out
    NonManifoldEdges,  // of more than two faces: kept, as where a keel meets a sail
    FlippedFaces,      // wound against their neighbours: turned over
    InsideOutShells,   // closed, and wound inwards: turned over
    OneSidedEdges,     // where no turning over helps, as on a Moebius strip: kept
    SeveralShells,     // pieces that nothing joins: kept
    OpenEdges,         // of one face: kept, as every sail has them
    WarpedPolygons,    // of more than three corners that lie in no plane: triangles fold them
    SplitPolygons,     // of more than three corners: made triangles
    TextureSeams,      // vertices with several texture points: the picture keeps the first one
    EmptyObjects,      // without a face that has an area: left out, each by its name
    MissingFiles,      // of colours and pictures, each by its name: the fabric goes without
    StrayElements,     // lines and single points of the file: left out
    OddSize            // larger than a hall or smaller than a hand: a wrong unit?
};
inline constexpr int meshFaultCount = 18;

// "loose_vertices", ...: as scripts know them.
std::string_view meshFaultName(MeshFault fault);

enum class MeshGravity { Note, Repaired, Warning };
MeshGravity gravityOf(MeshFault fault);

struct MeshFinding
{
    static constexpr std::size_t mostPlaces = 5;

    MeshFault fault;
    std::size_t count = 0;    // of what the fault names
    std::size_t of = 0;       // rims of open edges, pieces; for others 0
    std::vector<Vec3> places; // m, of the first few, after scale and axes
    Message told;             // in the place of the table's words, where there is more to say
    std::string name = {};    // of the first, for objects and files
    double farthest = 0.0;    // m, of a corner from the plane of its polygon, of those warped

    // "28 vertices lie on another one: joined."
    Message text() const;
};

class MeshReport
{
public:
    void add(MeshFault fault, const Vec3& place, std::size_t count = 1);
    void add(MeshFault fault, std::size_t count);
    void tell(MeshFault fault, Message told); // once
    void addNamed(MeshFault fault, const std::string& name);
    void addWarped(const Vec3& place, double distance); // m, from its plane
    void add(const MeshReport& other);                  // of another object of the same file
    void setOf(MeshFault fault, std::size_t of) { m_findings[std::size_t(fault)].of = of; }

    // How often; 0 for what is not wrong.
    std::size_t count(MeshFault fault) const { return m_findings[std::size_t(fault)].count; }

    // Those that count something, the grave ones first.
    std::vector<MeshFinding> findings() const;

private:
    std::vector<MeshFinding> m_findings = none();
    static std::vector<MeshFinding> none();
};

} // namespace ripstop
