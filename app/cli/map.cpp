// ripstop-cli map: a number of elements as a formula of where they lie, or of a picture.
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "io/scene_file.h"
#include "scene/path.h"
#include "select/element_map.h"
#include "select/elements.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <iostream>

namespace ripstop {
namespace {

struct MapOptions
{
    SceneInput scene;
    std::string path;
    std::string formula;
    std::string of;
    std::string picture;
    std::vector<double> range; // of what the picture is to give, black and white
    std::string output;
};

// The item of this name, whatever it is.
Result<Id> itemCalled(const Scene& scene, const std::string& name)
{
    std::optional<Failure> failure;
    for (const Kind kind : {Kind::Material, Kind::Group, Kind::Part}) {
        const Result<Id> id = findNamed(scene, kind, name);
        if (id)
            return *id;
        if (!failure)
            failure = id.failure();
    }
    return *failure;
}

std::string formulaOf(const MapOptions& options)
{
    if (options.range.empty())
        return options.formula;
    const double black = options.range.front(), white = options.range.back();
    return textFromValue(black) + " + (" + textFromValue(white - black) + ") * grey";
}

int map(const MapOptions& options)
{
    if (options.formula.empty() && options.range.empty())
        return fail(WrongUsage, Message("Say what to set: --formula, or --picture and --range."));
    if (!options.range.empty() && options.picture.empty())
        return fail(WrongUsage, Message("--range is of a picture: name one with --picture."));
    SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    Scene& scene = *loaded.scene;
    Result<Place> place = findPlace(scene, options.path);
    if (!place)
        return fail(WrongUsage, Message("%1: %2.", options.path, place.message()));
    if (!options.of.empty()) {
        const Result<Id> item = itemCalled(scene, options.of);
        if (!item)
            return fail(WrongUsage, Message("--of %1: %2.", options.of, item.message()));
        const std::vector<Id> among = elementsOf(scene, {*item});
        std::erase_if(place->targets,
                      [&](Id id) { return !std::ranges::binary_search(among, id); });
    }
    const Result<MappedNumbers> made = mappedByPicture(scene, *place->property, place->targets,
                                                       formulaOf(options), options.picture);
    if (!made)
        return fail(BadInput, Message("%1: %2", options.scene.file, made.message()));
    (void)apply(scene, made->edit);
    if (const auto failure = saveScene(scene, options.output))
        return fail(BadInput, failure->message);
    std::cout << place->property->key << " of " << made->count << ' '
              << kindPlural(place->property->kind) << ": " << shortNumber(made->least) << " to "
              << shortNumber(made->most) << '\n';
    return Done;
}

} // namespace

void addMap(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "map", "Set a number of elements by a formula of where they lie, or by a picture.");
    const auto options = std::make_shared<MapOptions>();
    addSceneOption(*command, options->scene);
    command->add_option("PATH", options->path, "What is set: kite.links.tearLimit")->required();
    CLI::Option* formula = command->add_option(
        "--formula", options->formula,
        "Of x, y, z (m), u, v (texture), value (now) and grey (of the picture)");
    command->add_option("--of", options->of, "Only what this material, group or part has")
        ->type_name("NAME");
    command
        ->add_option("--picture", options->picture,
                     "PNG or PGM, seen at u and v, or laid over elements without texture")
        ->type_name("FILE");
    command
        ->add_option("--range", options->range,
                     "What black and white of the picture mean, in place of a formula")
        ->expected(2)
        ->type_name("LOW HIGH")
        ->excludes(formula);
    command->add_option("-o,--output", options->output, "Scene file to write")
        ->type_name("SCENE")
        ->required();
    addSetOption(*command, options->scene.assignments);
    command->footer(
        "A place of an element is the middle of its particles, as the scene has them. The value of "
        "a link that has\nno number of its own is what its material gives it.\n\n"
        "Examples:\n"
        "  ripstop-cli map cloth.ripstop.json sheet.panels.strengthFactor \\\n"
        "      --formula \"value * (1 - 0.5 * exp(-(x^2 + z^2) / 0.04))\" -o worn.ripstop.json\n"
        "  ripstop-cli map kite.ripstop.json kite.panels.strengthFactor --picture worn.png \\\n"
        "      --range 0.2 1 -o worn.ripstop.json\n"
        "  ripstop-cli map kite.ripstop.json kite.panels.grain --formula \"45 * u\" -o "
        "fan.ripstop.json");
    command->callback([options, &chosen] { chosen = [options] { return map(*options); }; });
}

} // namespace ripstop
