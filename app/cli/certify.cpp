// ripstop-cli certify: which digits of a run hold.
//
// The scene is flown three times (recording/certificate.h); what each probe goes to is printed as a
// table or as JSON, --csv writes the bands of errors over time, and --record keeps the run with
// them.
#include "run/certify.h"
#include "cli/certificate_text.h"
#include "cli/commands.h"
#include "cli/replay.h"
#include "cli/scene_input.h"
#include "cli/targets.h"
#include "io/certificate_table.h"
#include "io/control_track.h"
#include "io/whole_file.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace ripstop {
namespace {

struct CertifyOptions
{
    SceneInput scene;
    double seconds = 0.0; // s
    std::string controls;
    std::string csv;
    std::string record;
    int threads = 1;
    int digits = 0; // fewer end in Inaccurate
    bool json = false;
};

int certify(const CertifyOptions& options)
{
    SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    const FileNames inputs = inputsOf(*loaded.scene, options.scene.file, {options.controls});
    if (const int code = refuseTargets({options.csv, options.record}, inputs); code != Done)
        return code;
    tellWarnings(*loaded.scene, options.scene.file);
    std::function<Pilot()> newPilot;
    if (!options.controls.empty()) {
        auto track = readControlTrack(options.controls, *loaded.scene);
        if (!track)
            return fail(BadInput, track.message());
        newPilot = [track = *track] {
            return [player = std::make_shared<ControlPlayer>(track)](Simulation& simulation) {
                player->giveTo(simulation);
            };
        };
    }
    const auto made = [&] {
        ProgressLine progress("certifying " + options.scene.file);
        const auto goesOn = [&](double share) {
            progress.show(share);
            return !interrupted();
        };
        return ripstop::certify(*loaded.scene, options.seconds, newPilot, goesOn, options.threads);
    }();
    if (interrupted())
        return fail(Interrupted, "Interrupted; nothing is certified.");
    if (!made)
        return fail(BadInput, Message("%1: %2", options.scene.file, made.message()));
    if (!made->stopped.empty())
        return fail(Diverged, Message("%1: %2", options.scene.file, made->stopped));
    const Certificate& certificate = made->certificate;
    if (!options.csv.empty())
        if (const auto failure =
                replaceFile(options.csv, certificateTable(certificate), Flush::ToDisk))
            return fail(BadInput, failure->message);
    if (!options.record.empty())
        if (const auto failure = saveRun(made->flown, options.record))
            return fail(BadInput, failure->message);
    if (options.json)
        print(jsonOf(certificate));
    else
        printTable(certificate);
    const auto worst = std::ranges::min_element(certificate.probes, {}, &CertifiedProbe::digits);
    if (worst->digits() >= options.digits)
        return Done;
    return fail(Inaccurate, Message("%1 digits of \"%2\" hold, and %3 are wanted.", worst->digits(),
                                    worst->name, options.digits));
}

} // namespace

void addCertify(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "certify", "Tell which digits of the probes hold, by flying a scene three times.");
    const auto options = std::make_shared<CertifyOptions>();
    addSceneOption(*command, options->scene);
    addSetOption(*command, options->scene.assignments);
    command->add_option("--seconds", options->seconds, "Simulated time, s")
        ->required()
        ->transform(secondsBetween(1e-9, 1e9))
        ->type_name("T");
    command
        ->add_option("--controls", options->controls,
                     "What pilot and hands do: a control track, as of run --controls")
        ->type_name("FILE");
    command
        ->add_option("--csv", options->csv,
                     "Write the values of the probes and their errors over time")
        ->type_name("FILE");
    command
        ->add_option("--record", options->record,
                     "Record the run as it is, with its certificate (*.ripstop-run): tables and "
                     "figures that are exported from it have the errors")
        ->type_name("FILE");
    command
        ->add_option("--threads", options->threads,
                     "Threads of each of the two runs that are flown at a time; what is found is "
                     "the same for all")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command->add_option("--digits", options->digits, "End with code 5 where fewer digits hold")
        ->check(CLI::Range(0, 15))
        ->type_name("N");
    command->add_flag("--json", options->json, "Print one JSON object");
    command->footer(
        "Examples:\n"
        "  ripstop-cli certify scenes/stretched_line.ripstop.json --seconds 2\n"
        "  ripstop-cli certify kite.ripstop.json --seconds 5 --record kite.ripstop-run\n"
        "  ripstop-cli export kite.ripstop-run -o kite.svg\n"
        "\n"
        "The scene is flown as it is, with each substep cut in two, and in four; its tolerances "
        "are\ncut as well. What the last value of a probe goes to tells its order and its error "
        "(Richardson);\nwhere it goes nowhere, as in motion that is chaotic, the mean over the "
        "second half of the time\nis judged instead. It takes about seven times as long as the "
        "run.");
    command->callback([options, &chosen] { chosen = [options] { return certify(*options); }; });
}

} // namespace ripstop
