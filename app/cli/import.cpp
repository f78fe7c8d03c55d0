// ripstop-cli import: meshes of other programs as fabric.
//
// In order, by section: options become the shape and the fabric that the model takes; what was
// found and made becomes a text or JSON; and the command sorts its arguments into files and
// options, imports one file after the other into one scene, fits the substeps to the springs, and
// writes the scene.
#include "author/mesh_import.h"
#include "check/step_check.h"
#include "cli/commands.h"
#include "cli/own_library.h"
#include "cli/scene_input.h"
#include "cli/targets.h"
#include "io/scene_file.h"
#include "scene/element_index.h"
#include "scene/path.h"
#include "shapes/mesh_file.h"
#include "shapes/packed_pictures.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

namespace ripstop {
namespace {

struct ImportOptions
{
    std::vector<std::string> arguments; // files, and KEY=VALUE for --KEY VALUE
    std::vector<std::string> files;
    std::string unit;
    std::optional<double> scale;
    std::optional<double> size;
    std::string up = "y";
    std::optional<double> weld;
    bool flip = false;
    std::string parts = "one";
    std::string name;
    std::string preset = "ripstop_075";
    std::string own; // file of own materials
    std::string material;
    std::string materials = "one";
    std::optional<double> density;
    std::optional<double> membrane;
    std::optional<double> shearStiffness;
    std::optional<double> bending;
    std::string fabric;
    std::optional<double> grain; // degrees
    std::string structural;
    std::string shear;
    std::string bend;
    std::optional<double> bendStiffness;
    SceneInput into;
    std::string output;
    bool json = false;
};

// --- options into what the model takes ---------------------------------------------------------

MeshShape shapeOf(const ImportOptions& options)
{
    MeshShape shape;
    for (const LengthUnit& unit : lengthUnits())
        if (unit.name == options.unit)
            shape.scale = unit.metres;
    shape.scale = options.scale.value_or(shape.scale);
    shape.size = options.size;
    for (const UpAxis axis : {UpAxis::X, UpAxis::Y, UpAxis::Z})
        if (upAxisName(axis) == options.up)
            shape.up = axis;
    shape.weldTolerance = options.weld;
    shape.isFlipped = options.flip;
    shape.parts = options.parts == "object" ? MeshParts::PerObject : MeshParts::One;
    return shape;
}

std::optional<LinkStyle> styleCalled(const std::string& name)
{
    for (const LinkStyle style : {LinkStyle::None, LinkStyle::Springs, LinkStyle::Rods})
        if (linkStyleName(style) == name)
            return style;
    return std::nullopt;
}

Result<MeshFabric> fabricFor(const ImportOptions& options, const Scene& scene)
{
    MeshFabric fabric;
    if (!options.material.empty()) {
        const Result<Id> id = findNamed(scene, Kind::Material, options.material);
        if (!id)
            return Failure("--material %1: %2.", options.material, id.message());
        fabric.existing = *id;
        fabric.material = *findItem<Material>(scene, *id);
        fabric.density = options.density;
    } else {
        const std::vector<Preset> own = ownMaterials(options.own);
        const Result<const Preset*> preset = findPreset(options.preset, own);
        if (!preset)
            return preset.failure();
        if (!isSheet((*preset)->kind))
            return Failure("The preset %1 is not a fabric; ripstop-cli presets lists those.",
                           options.preset);
        Material& material = fabric.material = materialFrom(**preset);
        if (options.density)
            material.arealDensity = options.density;
        if (options.membrane)
            material.membraneStiffness = options.membrane;
        if (options.shearStiffness)
            material.shearStiffness = options.shearStiffness;
        material.bendingStiffness = options.bending.value_or(material.bendingStiffness);
    }
    fabric.isPerFileMaterial = options.materials == "file";
    for (const FabricKind kind : {FabricKind::Threads, FabricKind::Panels})
        if (choiceNames<FabricKind>[std::size_t(kind)] == options.fabric)
            fabric.carrier = kind;
    fabric.grain = options.grain.value_or(0.0);
    fabric.structural = styleCalled(options.structural);
    fabric.shear = styleCalled(options.shear);
    fabric.bend = styleCalled(options.bend);
    fabric.bendStiffness = options.bendStiffness.value_or(0.0);
    if (options.grain && carrierOf(fabric) != FabricKind::Panels)
        return Failure{"--grain turns the warp of panels, and threads run along the edges of the "
                       "mesh: leave it out, or choose --fabric panels."};
    return fabric;
}

// --- what comes out ----------------------------------------------------------------------------

std::string sizeText(const Vec3& size)
{
    return shortNumber(size.x()) + " x " + shortNumber(size.y()) + " x " + shortNumber(size.z())
           + " m";
}

// Empty where the mesh has faces only.
std::string linesText(const MeshLines& lines)
{
    if (lines.count == 0)
        return {};
    return std::to_string(lines.count) + (lines.count == 1 ? " line of " : " lines of ")
           + shortNumber(lines.length) + (lines.count == 1 ? " m, " : " m together, ");
}

std::string_view gravityName(MeshGravity gravity)
{
    constexpr std::array<std::string_view, 3> names{"note", "repaired", "warning"};
    return names[std::size_t(gravity)];
}

Json jsonOf(const std::string& file, const PreparedMesh& mesh, const MeshImport& made)
{
    Json report = Json::array();
    for (const MeshFinding& finding : mesh.report.findings()) {
        Json places = Json::array();
        for (const Vec3& place : finding.places)
            places.push_back(numbersOf(place));
        report.push_back({{"fault", meshFaultName(finding.fault)},
                          {"count", finding.count},
                          {"gravity", gravityName(gravityOf(finding.fault))},
                          {"text", finding.text().english()},
                          {"places", std::move(places)}});
    }
    Json pictures = Json::array();
    for (const PolygonMesh::PackedPicture& picture : made.pictures)
        pictures.push_back(picture.file);
    const MeshLines lines = linesOf(mesh);
    return {{"file", file},
            {"size", numbersOf(mesh.size)},
            {"lines", {{"count", lines.count}, {"length", lines.length}}},
            {"weld_tolerance", mesh.weldTolerance},
            {"parts", made.parts.size()},
            {"particles", made.particles},
            {"links", made.rods + made.springs},
            {"rods", made.rods},
            {"springs", made.springs},
            {"panels", made.panels},
            {"fabric_area", made.area},
            {"mass", made.mass},
            {"pictures", std::move(pictures)},
            {"report", std::move(report)}};
}

void describe(const std::string& file, const PreparedMesh& mesh, const MeshImport& made)
{
    std::cout << file << ": " << sizeText(mesh.size) << " (width, height, depth), "
              << linesText(linesOf(mesh)) << made.parts.size()
              << (made.parts.size() == 1 ? " part, " : " parts, ") << made.particles
              << " particles, " << made.springs << " springs, " << made.rods << " rods, "
              << made.panels << " panels, " << shortNumber(made.area) << " m^2, "
              << shortNumber(made.mass) << " kg\n";
    for (const PolygonMesh::PackedPicture& picture : made.pictures)
        std::cout << "  note: a picture that lies within the mesh's file is " << picture.file
                  << " now.\n";
    if (const std::optional<Message> off = threadsComplaint(made))
        std::cout << "  warning: " << off->english() << '\n';
    for (const MeshFinding& finding : mesh.report.findings()) {
        std::cout << "  " << gravityName(gravityOf(finding.fault)) << ": "
                  << finding.text().english();
        if (!finding.places.empty() && finding.fault != MeshFault::SplitPolygons) {
            std::cout << (finding.places.size() < finding.count ? " First at" : " At");
            for (std::size_t i = 0; i < finding.places.size(); ++i) {
                const Vec3& place = finding.places[i];
                std::cout << (i ? "; " : " ") << shortNumber(place.x()) << ", "
                          << shortNumber(place.y()) << ", " << shortNumber(place.z());
            }
            std::cout << " m.";
        }
        std::cout << '\n';
    }
}

// Springs of stiff or light fabric need short substeps.
void fitSubsteps(Scene& scene)
{
    const std::optional<StepLimit> limit = stepLimit(scene);
    if (limit && exceeds(scene.settings, *limit))
        scene.settings.substeps = substepsWithin(*limit, scene.settings);
}

// --- the command -------------------------------------------------------------------------------

// Adds one file to the scene. Returns nothing, or the exit code after a message has been printed.
std::optional<int> importOne(const ImportOptions& options, const std::string& file, Scene& scene,
                             MeshFabric& fabric, Json& list)
{
    ProgressLine line("Importing " + file);
    const Progress progress = [&line](double share) {
        line.show(share);
        return !interrupted();
    };
    const Result<PolygonMesh> read = readPolygonFile(file, stageOf(progress, 0.0, 0.4));
    if (interrupted())
        return fail(Interrupted, "Interrupted; nothing was written.");
    if (!read)
        return fail(BadInput, read.message());
    const Result<PreparedMesh> mesh =
        prepared(*read, shapeOf(options), stageOf(progress, 0.4, 0.7));
    if (interrupted())
        return fail(Interrupted, "Interrupted; nothing was written.");
    if (!mesh)
        return fail(BadInput, Message("%1: %2", file, mesh.message()));
    const std::string name =
        options.name.empty() ? std::filesystem::path(file).stem().string() : options.name;
    Result<MeshImport> made =
        fabricOf(*mesh, fabric, name, surroundingsOf(scene), stageOf(progress, 0.7, 1.0));
    if (interrupted())
        return fail(Interrupted, "Interrupted; nothing was written.");
    if (!made)
        return fail(BadInput, Message("%1: %2", file, made.message()));
    std::erase_if(made->pictures, [](const PolygonMesh::PackedPicture& picture) {
        const auto failure = unpack(picture);
        if (failure)
            warn(failure->message.english());
        return failure.has_value();
    });
    (void)apply(scene, made->edit);
    const Part& part = *findItem<Part>(scene, made->parts.front());
    if (!fabric.isPerFileMaterial) { // the next file is of the same
        fabric.existing = part.panels.front().material;
        fabric.material = *findItem<Material>(scene, fabric.existing);
    }
    const std::size_t materials = std::set(read->material.begin(), read->material.end()).size();
    if (options.json)
        list.push_back(jsonOf(file, *mesh, *made));
    else
        describe(file, *mesh, *made);
    if (!options.json && materials > 1 && options.materials == "one" && options.material.empty())
        std::cout << "  note: the file has " << materials
                  << " materials, and all of it became one; "
                  << "--materials file keeps them apart.\n";
    return std::nullopt;
}

int importMeshes(const ImportOptions& options)
{
    if (const int code = refuseTargets({options.output}, options.files); code != Done)
        return code; // the scene that they come into may be added to where it is
    Scene scene;
    if (!options.into.file.empty()) {
        SceneOutcome loaded = loadScene({options.into.file, {}});
        if (!loaded.scene)
            return loaded.exitCode;
        scene = std::move(*loaded.scene);
    } else {
        scene.settings.title = std::filesystem::path(options.files.front()).stem().string();
        if (!options.material.empty())
            return fail(WrongUsage,
                        "--material names a material of a scene: it needs --into SCENE.");
    }
    Result<MeshFabric> fabric = fabricFor(options, scene);
    if (!fabric)
        return fail(WrongUsage, fabric.message());
    Json list = Json::array();
    for (const std::string& file : options.files)
        if (const std::optional<int> code = importOne(options, file, scene, *fabric, list))
            return *code;
    fitSubsteps(scene);
    if (const auto failure = assign(scene, options.into.assignments))
        return fail(WrongUsage, failure->message);
    if (const auto failure = saveReadable(scene, options.output))
        return fail(BadInput, failure->message);
    tellWarnings(scene, options.output);
    if (options.json)
        print({{"scene", options.output}, {"meshes", std::move(list)}});
    return Done;
}

// "scale=0.001" is "--scale 0.001". What is neither an option nor has "=" is a file.
std::optional<Failure> sortArguments(CLI::App& command, ImportOptions& options)
{
    for (const std::string& argument : options.arguments) {
        const std::size_t equals = argument.find('=');
        if (equals == std::string::npos || std::filesystem::exists(argument)) {
            options.files.push_back(argument);
            continue;
        }
        std::string key = argument.substr(0, equals);
        std::ranges::replace(key, '_', '-');
        CLI::Option* option = command.get_option_no_throw("--" + key);
        if (!option || key == "help")
            return Failure("\"%1\" is no option of import; ripstop-cli import --help lists them.",
                           key);
        if (option->count() > 0)
            return Failure("%1 is given twice.", key);
        try {
            option->add_result(argument.substr(equals + 1));
            option->run_callback();
        } catch (const CLI::Error& error) {
            return Failure("%1.", error.what());
        }
    }
    if (options.files.empty())
        return Failure{
            "Name a mesh to import: an OBJ, STL, PLY, OFF, glTF, GLB, Collada, VTP or VTU file."};
    return std::nullopt;
}

void addShapeOptions(CLI::App& command, ImportOptions& options)
{
    std::vector<std::string> units;
    for (const LengthUnit& unit : lengthUnits())
        units.emplace_back(unit.name);
    auto* unit = command.add_option("--unit", options.unit, "What one unit of the file is; m")
                     ->check(CLI::IsMember(units))
                     ->type_name("mm|cm|m|in|ft");
    auto* scale = command.add_option("--scale", options.scale, "Metres per unit of the file")
                      ->check(numberBetween(1e-12, 1e12))
                      ->excludes(unit);
    command
        .add_option("--size", options.size,
                    "Wanted length of the longest side, m, or with its unit: \"24 in\"")
        ->transform(quantityBetween(1e-6, 1e6, "m"))
        ->excludes(unit)
        ->excludes(scale);
    command.add_option("--up", options.up, "The axis of the file that points up")
        ->check(CLI::IsMember({"x", "y", "z"}))
        ->capture_default_str()
        ->type_name("x|y|z");
    command
        .add_option("--weld", options.weld,
                    "Vertices nearer than this are joined, m; 1e-5 of the size")
        ->transform(quantityBetween(0.0, 1e6, "m"));
    command.add_flag("--flip", options.flip, "Turn all faces over");
    command.add_option("--parts", options.parts, "One part, or one for each object of the file")
        ->check(CLI::IsMember({"one", "object"}))
        ->capture_default_str()
        ->type_name("one|object");
    command.add_option("--name", options.name, "Name of the part; that of the file")
        ->type_name("NAME");
}

void addFabricOptions(CLI::App& command, ImportOptions& options)
{
    auto* preset = command.add_option("--preset", options.preset, "Fabric (ripstop-cli presets)")
                       ->capture_default_str()
                       ->type_name("PRESET");
    addOwnMaterialsOption(command, "--own-materials", options.own);
    command.add_option("--material", options.material, "A material of the scene instead")
        ->type_name("NAME")
        ->excludes(preset);
    command
        .add_option("--materials", options.materials,
                    "One material, or one for each of the file, with its name and colour")
        ->check(CLI::IsMember({"one", "file"}))
        ->capture_default_str()
        ->type_name("one|file");
    command.add_option("--density", options.density, "Mass per area of the fabric, kg/m^2")
        ->transform(quantityBetween(1e-6, 1e3, "kg/m^2"));
    command.add_option("--membrane", options.membrane, "Stiffness E t along threads, N/m")
        ->transform(quantityBetween(1e-6, 1e9, "N/m"));
    command.add_option("--shear-stiffness", options.shearStiffness, "Shear stiffness G t, N/m")
        ->transform(quantityBetween(1e-6, 1e9, "N/m"));
    command.add_option("--bending", options.bending, "Bending stiffness, N m")
        ->transform(quantityBetween(0.0, 1e6, "N m"));
    command
        .add_option("--fabric", options.fabric,
                    "What carries the pull: panels are elastic triangles with warp, weft and "
                    "shear, threads are links along edges and across; panels, unless such links "
                    "are asked for or the material has no membrane stiffness")
        ->check(CLI::IsMember({"threads", "panels"}))
        ->type_name("threads|panels");
    command
        .add_option("--grain", options.grain,
                    "Degrees by which the warp of panels is turned from the way the texture goes "
                    "up; without a texture, from upright, or from x on what lies level; 0")
        ->transform(quantityBetween(-180.0, 180.0, "deg"));
    const auto style = [&](const char* name, std::string& value, const char* help) {
        command.add_option(name, value, help)
            ->check(CLI::IsMember({"none", "springs", "rods"}))
            ->type_name("none|springs|rods");
    };
    style("--structural", options.structural, "Links along edges; rods where threads carry");
    style("--shear", options.shear,
          "Links across quads and pairs of triangles; where threads carry and there are quads, "
          "rods (springs without a shear stiffness)");
    style("--bend", options.bend, "Links over two edges; none");
    command
        .add_option("--bend-stiffness", options.bendStiffness,
                    "Stiffness of bend links, N/m; 0.02 of the membrane's")
        ->transform(quantityBetween(1e-9, 1e9, "N/m"));
}

} // namespace

void addImport(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "import", "Make fabric of meshes: OBJ, STL, PLY, OFF, glTF, Collada, VTP, VTU.");
    const auto options = std::make_shared<ImportOptions>();
    command->add_option("FILE", options->arguments, "Meshes; KEY=VALUE stands for --KEY VALUE")
        ->required();
    addShapeOptions(*command, *options);
    addFabricOptions(*command, *options);
    command->add_option("--into", options->into.file, "Scene that the meshes are added to")
        ->type_name("SCENE");
    addSetOption(*command, options->into.assignments);
    command->add_option("-o,--output", options->output, "Scene file to write")
        ->required()
        ->type_name("SCENE");
    command->add_flag("--json", options->json, "Print the report as one JSON object");
    command->footer(
        "glTF and Collada say their unit and their upward axis; --unit and --up are for the\n"
        "other formats.\n"
        "Examples:\n"
        "  ripstop-cli import sail.obj -o sail.ripstop.json\n"
        "  ripstop-cli import kite.stl --unit mm --up z --preset skytex_27 -o kite.ripstop.json\n"
        "  ripstop-cli import wing.obj --size 2.4 --parts object --bend springs \\\n"
        "      --into scene.ripstop.json -o scene.ripstop.json");
    command->callback([command, options, &chosen] {
        chosen = [command, options] {
            if (const auto failure = sortArguments(*command, *options))
                return fail(WrongUsage, failure->message);
            return importMeshes(*options);
        };
    });
}

} // namespace ripstop
