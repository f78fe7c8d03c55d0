// An import in two stages, as the header has it.
// prepared(): the mesh is scaled to metres and turned upright, split by object if asked, and each
// piece repaired with a share of the progress; the report tells of odd sizes.
// fabricOf(): the density is known or refused, materials are added to a scratch scene that counts
// ids from where the open scene ends, each surface is woven into a part, and objects of the file
// become groups. The items of the scratch scene are the edit, so that the open scene is not needed
// on this thread.
#include "author/mesh_import.h"

#include "derived/named_files.h"
#include "materials/presets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

namespace ripstop {
namespace {

constexpr double weldOverSize = 1e-5;
constexpr double largest = 30.0;     // m, of a mesh that is not told to be of a wrong unit
constexpr double smallest = 0.05;    // m
constexpr double likelyLeast = 0.2;  // m, of one in the right unit
constexpr double likelyMost = 15.0;  // m
constexpr double bendShare = 0.02;   // as the cloth paper's springs have
constexpr double lineDensity = 1e-3; // kg/m
constexpr std::uint32_t mostIds = 0xfffffff0;

struct Box
{
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;

    void add(const Vec3& point)
    {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    Vec3 size() const { return high - low; }
};

Box boxOf(const PolygonMesh& mesh) // of what faces use
{
    Box box;
    for (const int corner : mesh.corners)
        box.add(mesh.points[std::size_t(corner)]);
    return box;
}

Vec3 upright(const Vec3& point, UpAxis up)
{
    switch (up) {
    case UpAxis::X:
        return {-point.y(), point.x(), point.z()};
    case UpAxis::Z:
        return {point.x(), point.z(), -point.y()};
    default:
        return point;
    }
}

Result<PolygonMesh> inMetres(const PolygonMesh& mesh, const MeshShape& shape)
{
    double scale = mesh.unit.value_or(shape.scale);
    if (shape.size) {
        const double extent = boxOf(mesh).size().maxCoeff();
        if (!(extent > 0.0))
            return Failure{"All faces of the mesh lie in one point; choose another file."};
        scale = *shape.size / extent;
    }
    if (!(scale > 0.0) || !std::isfinite(scale))
        return Failure{"The scale of the mesh must be above 0."};
    PolygonMesh metres = mesh;
    for (Vec3& point : metres.points)
        point = upright(scale * point, mesh.isUpright ? UpAxis::Y : shape.up);
    const Vec3 size = boxOf(metres).size();
    if (!(size.maxCoeff() < 1e6)) // a thousand kilometres, where forces of floats end
        return Failure{"The mesh would be more than 1000 km wide; choose a smaller unit."};
    return metres;
}

Message wordOf(const LengthUnit& unit)
{
    return unit.name == "mm"   ? Message("millimetres")
           : unit.name == "cm" ? Message("centimetres")
           : unit.name == "m"  ? Message("metres")
           : unit.name == "in" ? Message("inches")
                               : Message("feet");
}

// Says how large the mesh is, m, and in which unit it would have a likely size. Metres and what
// they are cut into come before inches and feet, which far fewer programs write.
Message sizeComplaint(const PolygonMesh& mesh, const MeshShape& shape, double size)
{
    const Message large = Message::number("%.4g", size);
    if (shape.size) // which the author has chosen
        return Message("The mesh is scaled to %1 m: hardly any fabric has such a size.", large);
    const Message such = size > largest
                             ? Message("The mesh is %1 m large, and hardly any fabric is", large)
                             : Message("The mesh is only %1 m large", large);
    if (mesh.unit)
        return Message("%1: if its file has a wrong unit, scale it to a size.", such);
    for (const std::size_t i : {2, 1, 0, 3, 4}) {
        const LengthUnit& unit = lengthUnits()[i];
        const double then = size / shape.scale * unit.metres;
        if (then >= likelyLeast && then <= likelyMost)
            return Message("%1: if its file is in %2, it is %3 m.", such, wordOf(unit),
                           Message::number("%.4g", then));
    }
    return Message("%1: if that is wrong, scale it to a size.", such);
}

void turnOver(RepairedMesh& surface)
{
    for (auto& [a, b, c] : surface.triangles)
        std::swap(b, c);
    PolygonMesh& mesh = surface.mesh;
    for (std::size_t i = 0; i < mesh.faceCount(); ++i)
        std::reverse(mesh.corners.begin() + mesh.first[i] + 1,
                     mesh.corners.begin() + mesh.first[i + 1]);
}

std::string freeName(std::vector<std::string>& taken, const std::string& base)
{
    std::string name = base;
    for (int number = 2; std::ranges::find(taken, name) != taken.end(); ++number)
        name = base + " " + std::to_string(number);
    taken.push_back(name);
    return name;
}

// Which panels came from which object of the file.
void addGroups(Scene& scratch, const RepairedMesh& surface, Id firstPanel,
               std::vector<std::string>& names)
{
    std::vector<std::vector<Id>> panels(surface.mesh.objects.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const int object = surface.mesh.object[std::size_t(surface.faceOf[t])];
        panels[std::size_t(object)].push_back(Id(std::uint32_t(firstPanel) + std::uint32_t(t)));
    }
    const auto isUsed = [](const std::vector<Id>& one) { return !one.empty(); };
    if (std::ranges::count_if(panels, isUsed) < 2)
        return;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const std::string& object = surface.mesh.objects[i];
        if (isUsed(panels[i]))
            addGroup(scratch, freeName(names, object.empty() ? "group" : object),
                     std::move(panels[i]));
    }
}

double areaOf(const RepairedMesh& surface)
{
    double area = 0.0;
    for (const auto& [a, b, c] : surface.triangles) {
        const std::vector<Vec3>& at = surface.mesh.points;
        area += 0.5
                * (at[std::size_t(b)] - at[std::size_t(a)])
                      .cross(at[std::size_t(c)] - at[std::size_t(a)])
                      .norm();
    }
    return area;
}

void print(Material& material, const PolygonMesh::Material& file, const std::string& folder)
{
    if (!file.picture.empty())
        material.picture = nameSeenFrom(folder, file.picture);
}

// Those of the pictures that are printed on a material.
std::vector<PolygonMesh::PackedPicture>
picturesOn(const Scene& scratch, const std::vector<PolygonMesh::PackedPicture>& pictures)
{
    std::set<std::string> printed;
    for (const Entry& entry : scratch.items)
        if (const auto* material = std::get_if<Material>(&entry.item))
            printed.insert(material->picture);
    std::vector<PolygonMesh::PackedPicture> found;
    for (const PolygonMesh::PackedPicture& picture : pictures)
        if (!picture.file.empty()
            && printed.contains(nameSeenFrom(scratch.folder.path, picture.file)))
            found.push_back(picture);
    return found;
}

// The new materials, by the index of the file's; those that no face has are noId.
std::vector<Id> addFabrics(Scene& scratch, const PreparedMesh& mesh, const MeshFabric& fabric,
                           double density, std::vector<std::string>& names)
{
    if (fabric.existing != noId)
        return {fabric.existing};
    Material material = fabric.material;
    material.arealDensity = density;
    const std::vector<PolygonMesh::Material>& listed = mesh.surfaces.front().mesh.materials;
    if (!fabric.isPerFileMaterial) {
        material.name = freeName(names, material.name);
        std::set<int> used;
        for (const RepairedMesh& surface : mesh.surfaces)
            used.insert(surface.mesh.material.begin(), surface.mesh.material.end());
        if (used.size() == 1)
            print(material, listed[std::size_t(*used.begin())], scratch.folder.path);
        return {addItem(scratch, std::move(material))};
    }
    std::vector<Id> ids(listed.size(), noId);
    for (const RepairedMesh& surface : mesh.surfaces)
        for (const int used : surface.mesh.material) {
            Id& id = ids[std::size_t(used)];
            if (id != noId)
                continue;
            const PolygonMesh::Material& file = listed[std::size_t(used)];
            Material one = material;
            one.name = freeName(names, file.name.empty() ? material.name : file.name);
            one.color = file.color.empty() ? one.color : file.color;
            print(one, file, scratch.folder.path);
            id = addItem(scratch, std::move(one));
        }
    return ids;
}

Id addBendMaterial(Scene& scratch, const MeshFabric& fabric, std::vector<std::string>& names)
{
    const Material& cloth = fabric.material;
    Material bend;
    bend.name = freeName(names, cloth.name + " bend");
    bend.color = cloth.color;
    bend.shown = false;
    bend.damping = cloth.damping;
    bend.stiffness = fabric.bendStiffness > 0.0
                         ? fabric.bendStiffness
                         : bendShare * cloth.membraneStiffness.value_or(cloth.stiffness);
    bend.compliance = bend.stiffness > 0.0 ? 1.0 / bend.stiffness : 0.0;
    return addItem(scratch, std::move(bend));
}

// Inextensible, and as heavy as a thin cord; the file says neither.
Id addLineMaterial(Scene& scratch, std::vector<std::string>& names)
{
    Material line;
    line.name = freeName(names, "lines");
    line.color = "#5b6770";
    line.linearDensity = lineDensity;
    return addItem(scratch, std::move(line));
}

} // namespace

std::string_view upAxisName(UpAxis axis)
{
    constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
    return names[std::size_t(axis)];
}

std::span<const LengthUnit> lengthUnits()
{
    static constexpr std::array<LengthUnit, 5> units{
        {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}, {"ft", 0.3048}}};
    return units;
}

Result<PreparedMesh> prepared(const PolygonMesh& mesh, const MeshShape& shape,
                              const Progress& progress)
{
    Result<PolygonMesh> metres = inMetres(mesh, shape);
    if (!metres)
        return metres.failure();
    std::size_t stray = std::exchange(metres->strayElements, 0);
    PreparedMesh result;
    result.pictures = std::exchange(metres->pictures, {});
    result.size = boxOf(*metres).size();
    result.weldTolerance = shape.weldTolerance.value_or(weldOverSize * result.size.norm());
    if (!(result.weldTolerance >= 0.0) || result.weldTolerance > result.size.maxCoeff())
        return Failure{"The weld tolerance must be 0 or more, and smaller than the mesh."};

    std::vector<PolygonMesh> parts;
    if (shape.parts == MeshParts::PerObject) {
        std::vector<std::uint8_t> isUsed(metres->points.size());
        for (const int corner : metres->corners)
            isUsed[std::size_t(corner)] = 1;
        if (metres->objects.size() == 1) // repairing tells it
            isUsed.assign(isUsed.size(), 1);
        for (std::size_t i = 0; i < isUsed.size(); ++i)
            if (!isUsed[i])
                result.report.add(MeshFault::LooseVertices, metres->points[i]);
        parts = byObject(*metres);
        if (metres->objects.size() > 1) // a line may join two of them, and is of none
            stray += metres->lines.size();
    } else {
        parts.push_back(std::move(*metres));
    }
    std::optional<Failure> failure; // of the first object that is left out
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double count = double(parts.size());
        const std::string named = parts[i].objects.front();
        const std::string object = named.empty() ? "#" + std::to_string(i + 1) : named;
        Result<RepairedMesh> surface =
            repaired(std::move(parts[i]), result.weldTolerance,
                     stageOf(progress, double(i) / count, double(i + 1) / count));
        if (!surface) {
            const bool isCancelled = !goesOn(progress, double(i) / count);
            if (isCancelled || parts.size() == 1)
                return surface.failure();
            result.report.addNamed(MeshFault::EmptyObjects, object);
            failure = failure ? failure : surface.failure();
            continue;
        }
        if (shape.isFlipped)
            turnOver(*surface);
        result.report.add(surface->report);
        result.surfaces.push_back(std::move(*surface));
    }
    if (result.surfaces.empty())
        return *failure;
    for (const std::string& file : mesh.missingFiles)
        result.report.addNamed(MeshFault::MissingFiles, file);
    if (stray > 0)
        result.report.add(MeshFault::StrayElements, stray);
    if (result.size.maxCoeff() > largest || result.size.maxCoeff() < smallest)
        result.report.tell(MeshFault::OddSize, sizeComplaint(mesh, shape, result.size.maxCoeff()));
    return result;
}

MeshLines linesOf(const PreparedMesh& mesh)
{
    MeshLines lines;
    for (const RepairedMesh& surface : mesh.surfaces) {
        std::set<std::pair<int, int>> seen; // one that is told twice is one link
        for (const auto& [a, b] : surface.mesh.lines) {
            if (!seen.insert(std::minmax(a, b)).second)
                continue;
            const std::vector<Vec3>& points = surface.mesh.points;
            lines.length += (points[std::size_t(b)] - points[std::size_t(a)]).norm();
            ++lines.count;
        }
    }
    return lines;
}

Material materialFrom(const Preset& preset)
{
    Material material;
    material.name = "fabric";
    give(material, preset);
    return material;
}

FabricKind carrierOf(const MeshFabric& fabric)
{
    const auto isChosen = [](const std::optional<LinkStyle>& style) {
        return style.value_or(LinkStyle::None) != LinkStyle::None;
    };
    if (fabric.carrier)
        return *fabric.carrier;
    return isChosen(fabric.structural) || isChosen(fabric.shear)
                   || !fabric.material.membraneStiffness
               ? FabricKind::Threads
               : FabricKind::Panels;
}

Weave defaultWeave(const PreparedMesh& mesh, const Material& material)
{
    Weave weave;
    bool hasCells = false;
    for (const RepairedMesh& surface : mesh.surfaces)
        for (std::size_t i = 0; i < surface.mesh.faceCount() && !hasCells; ++i)
            hasCells = isCell(surface.mesh, i);
    weave.shear = !hasCells                 ? LinkStyle::None
                  : material.shearStiffness ? LinkStyle::Rods
                                            : LinkStyle::Springs;
    return weave;
}

Weave weaveOf(const PreparedMesh& mesh, const MeshFabric& fabric)
{
    Weave weave = defaultWeave(mesh, fabric.material);
    if (carrierOf(fabric) == FabricKind::Panels)
        weave = {LinkStyle::None, LinkStyle::None, LinkStyle::None};
    weave.structural = fabric.structural.value_or(weave.structural);
    weave.shear = fabric.shear.value_or(weave.shear);
    weave.bend = fabric.bend.value_or(weave.bend);
    return weave;
}

Surroundings surroundingsOf(const Scene& scene)
{
    Surroundings surroundings{scene.nextId, scene.items.size(), {}, scene.folder.path};
    for (const Entry& entry : scene.items)
        surroundings.names.push_back(nameOf(entry.item));
    return surroundings;
}

Result<MeshImport> fabricOf(const PreparedMesh& mesh, const MeshFabric& fabric,
                            const std::string& name, const Surroundings& surroundings,
                            const Progress& progress)
{
    const std::optional<double> density = fabric.material.arealDensity.value_or(0.0) > 0.0
                                              ? fabric.material.arealDensity
                                              : fabric.density;
    if (!density || !(*density > 0.0) || !std::isfinite(*density))
        return Failure("The material %1 has no mass per area; give one above 0 kg/m^2, or choose a "
                       "preset.",
                       fabric.material.name);
    std::size_t triangles = 0;
    for (const RepairedMesh& surface : mesh.surfaces)
        triangles += surface.triangles.size();
    std::size_t lines = 0;
    for (const RepairedMesh& surface : mesh.surfaces)
        lines += surface.mesh.lines.size();
    // a triangle has at most 3 threads, 3 shear, 3 bend links, 3 particles and itself, a line has
    // two particles and itself
    if (13.0 * double(triangles) + 3.0 * double(lines) + std::uint32_t(surroundings.nextId)
        > mostIds)
        return Failure{"The mesh has too many triangles; make it coarser in a mesh program."};

    std::vector<std::string> names = surroundings.names;
    Scene scratch;
    scratch.nextId = surroundings.nextId;
    scratch.folder.path = surroundings.folder;
    const Weave weave = weaveOf(mesh, fabric);
    WeaveMaterials materials{addFabrics(scratch, mesh, fabric, *density, names), noId};
    if (weave.bend != LinkStyle::None)
        materials.bend = addBendMaterial(scratch, fabric, names);
    if (lines > 0)
        materials.line = addLineMaterial(scratch, names);
    materials.lineDensity = lineDensity;

    MeshImport result;
    for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
        const RepairedMesh& surface = mesh.surfaces[i];
        const double count = double(mesh.surfaces.size());
        const bool isOnly = mesh.surfaces.size() == 1;
        const std::string& object = surface.mesh.objects.front();
        Network network(scratch, freeName(names, isOnly || object.empty() ? name : object));
        if (!weaveInto(network, surface, weave, materials, *density,
                       stageOf(progress, double(i) / count, double(i + 1) / count)))
            return Failure{"The import was cancelled."};
        if (carrierOf(fabric) == FabricKind::Panels)
            network.carryByPanels(warpsOf(surface), fabric.grain);
        else
            result.warpsOff = std::max(result.warpsOff, warpsOffThreads(surface));
        const Part& part = network.part();
        result.particles += part.particles.size();
        result.panels += part.panels.size();
        for (const Link& link : part.links)
            ++(link.kind == LinkKind::Rod ? result.rods : result.springs);
        for (const Particle& particle : part.particles)
            result.mass += particle.mass;
        result.area += areaOf(surface);
        const Id firstPanel = part.panels.front().id;
        result.parts.push_back(network.finish({}, {}));
        addGroups(scratch, surface, firstPanel, names);
    }
    result.pictures = picturesOn(scratch, mesh.pictures);
    result.edit.label = Message("Import %1", name);
    for (std::size_t i = 0; i < scratch.items.size(); ++i)
        result.edit.changes.push_back(
            AddItem{surroundings.itemCount + i, std::move(scratch.items[i])});
    return result;
}

std::optional<Message> threadsComplaint(const MeshImport& made)
{
    constexpr double most = 10.0; // degrees
    if (!(made.warpsOff > most))
        return std::nullopt;
    return Message(
        "The texture turns the warp by %1 degrees from the edges of the mesh, and threads "
        "run along these: the cloth will be stiffer than it is so cut. Have panels carry "
        "its pull.",
        Message::number("%.0f", made.warpsOff));
}

} // namespace ripstop
