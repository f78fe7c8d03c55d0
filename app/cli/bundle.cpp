// ripstop-cli bundle: all of a run for a paper, in one folder or zip; and what run does with one.
//
// In order: what became of the writing is reported; a bundle is made of a recording that there is,
// or of a scene; and flyBundle() computes the run of a bundle once more, for the command run.
#include "bundle/bundle.h"

#include "base/hash_text.h"
#include "cli/commands.h"
#include "cli/replay.h"
#include "cli/scene_input.h"
#include "cli/targets.h"
#include "terminal/terminal.h"

#include <iostream>

namespace ripstop {
namespace {

struct BundleOptions
{
    SceneInput scene;
    std::string output;
    std::optional<double> seconds;
    std::string controls;
    int threads = 1;
};

int tell(const BundleWritten& written)
{
    if (!written.failure)
        return Done;
    return fail(written.stopped ? Diverged
                : interrupted() ? Interrupted
                                : BadInput,
                written.failure->message);
}

int bundleRecording(const BundleOptions& options, const BundleOrder& order,
                    const Progress& progress)
{
    if (!options.scene.assignments.empty() || !options.controls.empty() || options.seconds)
        return fail(WrongUsage, "A recording is bundled as it was flown: --seconds, --set and "
                                "--controls go with a scene.");
    const OpenedRecording opened = openOrSay(options.scene.file);
    if (!opened.recording || !opened.damage.empty())
        return BadInput;
    return tell(writeBundle(opened.recording, order, options.output, progress));
}

int bundle(const BundleOptions& options)
{
    BundleOrder order;
    order.threads = options.threads;
    if (isInput(options.output, {options.scene.file, options.controls}))
        return WrongUsage;
    ProgressLine line(options.output);
    const Progress progress = [&](double share) {
        line.show(share);
        return !interrupted();
    };
    if (options.scene.file.ends_with(recordingExtension))
        return bundleRecording(options, order, progress);
    const SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    if (isInput(options.output, inputsOf(*loaded.scene, options.scene.file)))
        return WrongUsage;
    order.seconds = options.seconds.value_or(order.seconds);
    if (!options.controls.empty()) {
        Result<ControlTrack> track = readControlTrack(options.controls, *loaded.scene);
        if (!track)
            return fail(BadInput, track.message());
        order.controls = std::move(*track);
    }
    return tell(writeBundle(*loaded.scene, order, options.output, progress));
}

} // namespace

int flyBundle(const std::string& file, int threads, bool json)
{
    ProgressLine line(file);
    const Progress progress = [&](double share) {
        line.show(share);
        return !interrupted();
    };
    const auto bundle = openBundle(file, progress);
    if (!bundle)
        return fail(interrupted() ? Interrupted : BadInput, bundle.message());
    for (const std::string& name : bundle->changed)
        std::cerr << "ripstop-cli: " << name << " in " << file
                  << " is not as it was when the bundle was made.\n";
    const auto outcome = flyAgain(*bundle, threads, progress);
    if (!outcome)
        return fail(BadInput, outcome.message());
    const int code = tellReplay(*outcome, json);
    if (code == Done && hashText(outcome->hash) != bundle->manifest.hashAtEnd)
        return fail(Differs, "The manifest of " + file + " names another state at the end, "
                                 + bundle->manifest.hashAtEnd + ": it was changed.");
    return code;
}

void addBundle(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "bundle", "Put a run, all that it was made of and all that came of it into one folder or "
                  "zip.");
    const auto options = std::make_shared<BundleOptions>();
    command
        ->add_option("SCENE", options->scene.file,
                     "Scene file, which is flown, or a recording (*.ripstop-run)")
        ->required();
    command
        ->add_option("-o,--output", options->output, "A new folder, or a file that ends with .zip")
        ->required()
        ->type_name("TARGET");
    command->add_option("--seconds", options->seconds, "Simulated time, s; 10 unless given")
        ->transform(secondsBetween(0.0, 1e9))
        ->type_name("T");
    command
        ->add_option("--controls", options->controls,
                     "What pilot and hands do: a control track, as of run --controls")
        ->type_name("FILE");
    addSetOption(*command, options->scene.assignments);
    addThreadsOption(*command, options->threads);
    command->footer(
        "Examples:\n"
        "  ripstop-cli bundle kite.ripstop.json -o kite.zip --seconds 20\n"
        "  ripstop-cli bundle flown.ripstop-run -o flown\n"
        "  ripstop-cli run kite.zip\n"
        "\n"
        "In it are the scene with the files that it names, controls, recording, the probes as a\n"
        "table and a figure, and a README with the command lines that make all of it again.\n"
        "run flies it again and compares the hash of every step. An older bundle of that name is\n"
        "replaced when the new one is whole; Ctrl-C leaves nothing.");
    command->callback([options, &chosen] { chosen = [options] { return bundle(*options); }; });
}

} // namespace ripstop
