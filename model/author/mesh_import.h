// A mesh brought in as fabric: the file's polygons, in metres with y up, repaired, woven and
// weighed.
//
// In two stages, as a dialog shows the first while the choices of the second are still made:
// prepared() makes a sound surface of what was read, and fabricOf() makes parts and materials of
// that and the edit which adds them.
#pragma once

#include "author/mesh_network.h"
#include "author/mesh_repair.h"
#include "materials/presets.h"
#include "scene/edit.h"

#include <optional>

namespace ripstop {

enum class UpAxis { X, Y, Z };
std::string_view upAxisName(UpAxis axis); // "x", "y", "z"

struct LengthUnit
{
    std::string_view name; // "mm"
    double metres;
};
std::span<const LengthUnit> lengthUnits(); // mm, cm, m, in, ft

enum class MeshParts { One, PerObject };

struct MeshShape
{
    double scale = 1.0;         // m per unit of the file
    std::optional<double> size; // m, wanted for the longest side of the box around it; wins
    UpAxis up = UpAxis::Y;      // of the file; in Ripstop, y is up
    std::optional<double> weldTolerance; // m; absent: 1e-5 of the diagonal of the box
    bool isFlipped = false;              // all faces turned over in the end
    MeshParts parts = MeshParts::One;

    friend bool operator==(const MeshShape&, const MeshShape&) = default;
};

struct PreparedMesh
{
    std::vector<RepairedMesh> surfaces;               // one for each part
    MeshReport report;                                // of all of them
    Vec3 size = Vec3::Zero();                         // m
    double weldTolerance = 0.0;                       // m, as used
    std::vector<PolygonMesh::PackedPicture> pictures; // that lie within the mesh's file
};

// Lines beside the faces, as a bridle is drawn. They are told beside the size, which is that of the
// fabric: a kite is as wide with a line of 25 m as without.
struct MeshLines
{
    std::size_t count = 0;
    double length = 0.0; // m, of all together
};
MeshLines linesOf(const PreparedMesh& mesh);

// The file's own unit and axis win over those of `shape`.
Result<PreparedMesh> prepared(const PolygonMesh& mesh, const MeshShape& shape,
                              const Progress& progress = {});

// A material of the scene, or a new one.
struct MeshFabric
{
    Id existing{};                       // noId for the new one
    Material material;                   // as it is in the scene, or is to be
    std::optional<double> density;       // kg/m^2, where the material does not say
    std::optional<FabricKind> carrier;   // absent: carrierOf()
    bool isPerFileMaterial = false;      // one new material for each of the file, with its name,
                                         // colour and picture and the numbers of `material`; where
                                         // the file has one only, the new one has its picture
    double grain = 0.0;                  // degrees, that the warp of panels is turned from the way
                                         // in which the texture goes up (flat_panel.h)
    double bendStiffness = 0.0;          // N/m, of bend links; 0: 0.02 of the fabric's stiffness
    std::optional<LinkStyle> structural; // absent: defaultWeave()
    std::optional<LinkStyle> shear;
    std::optional<LinkStyle> bend;
};

// A new material called "fabric", with the numbers of the preset.
Material materialFrom(const Preset& preset);

// What carries the pull where nobody chose: panels, for which the mesh makes no difference. Threads
// where links along edges or across faces are chosen, and of a material without a membrane
// stiffness, which a panel cannot do without.
FabricKind carrierOf(const MeshFabric& fabric);

// Rods along edges, which no stiffness makes unstable, and shear links where there are quads:
// triangles resist shear as they are. Without a shear stiffness these are springs, so that they
// give. No bend links: a material has a bending stiffness for that. No links at all where panels
// carry the pull.
Weave defaultWeave(const PreparedMesh& mesh, const Material& material);
Weave weaveOf(const PreparedMesh& mesh, const MeshFabric& fabric); // what is chosen, and the rest

// What of a scene an import needs to know, so that another thread can make the edit.
struct Surroundings
{
    Id nextId{1};
    std::size_t itemCount = 0;
    std::vector<std::string> names; // of items
    std::string folder;             // that pictures are seen from, Scene::folder
};
Surroundings surroundingsOf(const Scene& scene);

struct MeshImport
{
    Edit edit; // adds material, parts, and groups by object
    std::vector<Id> parts;
    std::size_t particles = 0;
    std::size_t springs = 0;
    std::size_t rods = 0;
    std::size_t panels = 0;
    double area = 0.0;     // m^2
    double mass = 0.0;     // kg
    double warpsOff = 0.0; // degrees, of a texture from the threads that carry in its place
    std::vector<PolygonMesh::PackedPicture> pictures; // that the edit's materials name, and which
                                                      // have to be written: packed_pictures.h
};

// That threads do not run where the texture has its warp; nothing where they do, within the angle
// by which cloth that is cut off its warp begins to give way.
std::optional<Message> threadsComplaint(const MeshImport& made);

// `name` is that of the part, or in front of those of several.
Result<MeshImport> fabricOf(const PreparedMesh& mesh, const MeshFabric& fabric,
                            const std::string& name, const Surroundings& surroundings,
                            const Progress& progress = {});

} // namespace ripstop
