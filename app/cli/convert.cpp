// ripstop-cli convert: panels in place of the threads that have carried the pull of a fabric, and
// threads in place of panels.
#include "check/check.h"
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "derived/panel_fabric.h"
#include "derived/thread_fabric.h"
#include "io/scene_file.h"
#include "scene/path.h"
#include "terminal/terminal.h"

#include <iostream>

namespace ripstop {
namespace {

struct ConvertOptions
{
    SceneInput scene;
    std::string fabric;
    std::vector<std::string> parts;
    std::string output;
};

// Those that are named, or all.
Result<std::vector<Id>> partsOf(const ConvertOptions& options, const Scene& scene)
{
    std::vector<Id> parts;
    for (const std::string& name : options.parts) {
        const Result<Id> id = findNamed(scene, Kind::Part, name);
        if (!id)
            return Failure("--part %1: %2.", name, id.message());
        parts.push_back(*id);
    }
    if (parts.empty())
        forEachPart(scene, [&](Id id, const Part&) { parts.push_back(id); });
    return parts;
}

constexpr std::string_view threadsName = choiceNames<FabricKind>[std::size_t(FabricKind::Threads)];

// The edit, with what goes and what comes.
Result<PanelFabric> carriedByThreads(const Scene& scene, const std::vector<Id>& parts)
{
    PanelFabric made;
    SetValues carrier{&propertyOf<&Part::carrier>(), {}, {std::string(threadsName)}};
    for (const Id id : parts) {
        const Part& part = *findItem<Part>(scene, id);
        if (part.panels.empty())
            continue;
        carrier.targets.push_back(id);
        made.panels += part.panels.size();
    }
    made.parts = carrier.targets;
    if (made.parts.empty())
        return Failure{"There are no panels here that threads could take the place of."};
    made.edit = threaded(scene, {Message("Panels to threads"), {std::move(carrier)}});
    for (const Change& change : made.edit.changes)
        if (const auto* rows = std::get_if<AddRows>(&change))
            made.threads += rows->links.size();
    if (made.threads == 0)
        return Failure{"The fabric here has its threads already."};
    return made;
}

int convert(const ConvertOptions& options)
{
    SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    Scene& scene = *loaded.scene;
    const Result<std::vector<Id>> parts = partsOf(options, scene);
    if (!parts)
        return fail(WrongUsage, parts.message());
    const bool toThreads = options.fabric == threadsName;
    const Result<PanelFabric> made =
        toThreads ? carriedByThreads(scene, *parts) : carriedByPanels(scene, *parts);
    if (!made)
        return fail(BadInput, Message("%1: %2", options.scene.file, made.message()));
    (void)apply(scene, made->edit);
    for (const Finding& finding : problemsOf(scene))
        if (finding.severity == Severity::Error)
            return fail(BadInput, Message("%1: %2", options.scene.file, finding.message));
    if (const auto failure = saveReadable(scene, options.output))
        return fail(BadInput, failure->message);
    std::string names;
    for (const Id id : made->parts)
        names += (names.empty() ? "" : ", ") + findItem<Part>(scene, id)->name;
    std::cout << names << ": "
              << (toThreads ? std::to_string(made->threads) + " threads carry what "
                                  + std::to_string(made->panels) + " panels have carried\n"
                            : std::to_string(made->panels) + " panels carry what "
                                  + std::to_string(made->threads) + " threads have carried\n");
    return Done;
}

} // namespace

void addConvert(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "convert", "Have panels carry the fabric that threads carry, or threads that of panels.");
    const auto options = std::make_shared<ConvertOptions>();
    addSceneOption(*command, options->scene);
    command
        ->add_option(
            "--fabric", options->fabric,
            "What is to carry the pull: panels, elastic triangles with warp, weft and shear, or "
            "threads along the sides of panels")
        ->check(CLI::IsMember({"panels", "threads"}))
        ->required();
    command->add_option("--part", options->parts, "Name of a part; all of them without it")
        ->type_name("PART");
    command->add_option("-o,--output", options->output, "Scene file to write")
        ->type_name("SCENE")
        ->required();
    addSetOption(*command, options->scene.assignments);
    command->footer(
        "Links that stand for strips of fabric, those with the role thread or bias and a width, "
        "go. Lines, spars\nand hems stay, panels keep the cut that the threads had, and groups "
        "that named threads name the panels\nbeside them. Materials of panels need a membrane "
        "stiffness. The other way each side of\na panel becomes a thread, as in the import of a "
        "mesh of triangles.\n\n"
        "Example:\n"
        "  ripstop-cli convert sail.ripstop.json --fabric panels \\\n"
        "      --set fabric.membraneStiffness=40000 -o elastic.ripstop.json");
    command->callback([options, &chosen] { chosen = [options] { return convert(*options); }; });
}

} // namespace ripstop
