// ripstop-cli weigh: gives particles the mass that the densities of their materials say.
#include "scene/weigh.h"

#include "check/check.h"
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "io/scene_file.h"
#include "terminal/terminal.h"

#include <iostream>

namespace ripstop {
namespace {

struct WeighOptions
{
    SceneInput scene;
    std::string output;
};

double massOf(const Scene& scene) // kg
{
    double sum = 0.0;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles)
            sum += particle.mass;
    });
    return sum;
}

int weigh(const WeighOptions& options)
{
    SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    Scene& scene = *loaded.scene;
    const double before = massOf(scene);
    const Edit edit = weighing(scene);
    if (edit.changes.empty())
        return fail(BadInput, options.scene.file
                                  + ": no panel or link is made of a material of known density; "
                                    "set arealDensity or linearDensity of a material with --set.");
    const std::size_t count = std::get<SetValues>(edit.changes.front()).targets.size();
    (void)apply(scene, edit);
    if (const auto failure = saveReadable(scene, options.output))
        return fail(BadInput, failure->message);
    std::cout << count << " particles weighed: " << shortNumber(before) << " kg became "
              << shortNumber(massOf(scene)) << " kg\n";
    return Done;
}

} // namespace

void addWeigh(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "weigh", "Give particles the mass that the densities of their materials say.");
    const auto options = std::make_shared<WeighOptions>();
    addSceneOption(*command, options->scene);
    command->add_option("-o,--output", options->output, "Scene file to write")
        ->type_name("SCENE")
        ->required();
    addSetOption(*command, options->scene.assignments);
    command->footer(
        "Panels give a third of their mass to each corner, links half of theirs to each end; what "
        "else these\nparticles carried is lost, and all others keep their mass.\n\n"
        "Example:\n"
        "  ripstop-cli weigh drawn.ripstop.json --set fabric.arealDensity=0.04 -o "
        "sail.ripstop.json");
    command->callback([options, &chosen] { chosen = [options] { return weigh(*options); }; });
}

} // namespace ripstop
