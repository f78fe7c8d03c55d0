// ripstop-cli weigh: gives particles the mass that the densities of their materials say.
#include "scene/weigh.h"

#include "check/check.h"
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "io/scene_file.h"
#include "scene/particle_of.h"
#include "terminal/terminal.h"

#include <iostream>

namespace ripstop {
namespace {

struct WeighOptions
{
    SceneInput scene;
    std::string output;
    bool keepsHeavier = false;
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

void keepHeavier(const Scene& scene, SetValues& masses)
{
    SetValues kept{masses.property, {}, {}};
    for (std::size_t i = 0; i < masses.targets.size(); ++i)
        if (std::get<double>(masses.values[i]) >= particleOf(scene, masses.targets[i])->mass) {
            kept.targets.push_back(masses.targets[i]);
            kept.values.push_back(masses.values[i]);
        }
    masses = std::move(kept);
}

// What weighs more than twice what its materials say carries something else, such as a payload.
// Says what of that will be gone; empty where nothing is.
std::string lostBy(const SetValues& masses, const Scene& scene)
{
    double lost = 0.0; // kg, of all
    double most = 0.0; // kg, of one
    std::size_t count = 0;
    Id heaviest = noId;
    for (std::size_t i = 0; i < masses.targets.size(); ++i) {
        const double before = particleOf(scene, masses.targets[i])->mass;
        const double less = before - std::get<double>(masses.values[i]);
        if (less <= 0.5 * before)
            continue;
        ++count;
        lost += less;
        if (less > most) {
            most = less;
            heaviest = masses.targets[i];
        }
    }
    if (count == 0)
        return {};
    return shortNumber(lost) + " kg of what " + std::to_string(count)
           + (count == 1 ? " particle" : " particles")
           + " carried beside cloth and lines is gone, the most, " + shortNumber(most)
           + " kg, of particle " + std::to_string(std::uint32_t(heaviest))
           + ": --keep-heavier keeps such masses.";
}

int weigh(const WeighOptions& options)
{
    SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    Scene& scene = *loaded.scene;
    const double before = massOf(scene);
    Edit edit = weighing(scene);
    if (edit.changes.empty())
        return fail(BadInput, options.scene.file
                                  + ": no panel or link is made of a material of known density; "
                                    "set arealDensity or linearDensity of a material with --set.");
    SetValues& masses = std::get<SetValues>(edit.changes.front());
    if (options.keepsHeavier)
        keepHeavier(scene, masses);
    const std::string lost = lostBy(masses, scene);
    const std::size_t count = masses.targets.size();
    (void)apply(scene, edit);
    if (const auto failure = saveReadable(scene, options.output))
        return fail(BadInput, failure->message);
    if (!lost.empty())
        warn(lost);
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
    command->add_flag("--keep-heavier", options->keepsHeavier,
                      "Particles that weigh more than their materials say keep their mass, as of a "
                      "payload");
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
