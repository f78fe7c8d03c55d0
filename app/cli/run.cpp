// ripstop-cli run: flies a scene and says what came of it.
//
// In order: the steps of the run, as Simulation::runUntil() takes them, so that the window gets the
// same bits; flyAndReport(), which opens what is to be written before the run and reports what was
// flown even when a file cannot be written (run_report.h); and run(), which refuses wrong options
// and files that cannot be written before the first step.
#include "bundle/bundle.h"
#include "cli/commands.h"
#include "cli/event_list.h"
#include "cli/replay.h"
#include "cli/run_report.h"
#include "cli/scene_input.h"
#include "cli/targets.h"
#include "compile/compile.h"
#include "io/control_track.h"
#include "io/csv.h"
#include "io/event_table.h"
#include "io/load_table.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "io/tear_table.h"
#include "recording/recorder.h"
#include "run/pose.h"
#include "run/settle.h"
#include "simulation/simulation.h"
#include "step/step_times.h"
#include "study/probe_names.h"
#include "terminal/terminal.h"

#include <charconv>
#include <chrono>
#include <iostream>

namespace ripstop {
namespace {

struct RunOptions
{
    SceneInput scene;
    std::optional<double> seconds; // s; without, a settling run has SettleGoal::within
    bool settles = false;
    std::string settleSpeed; // m/s, as typed; empty for the usual
    bool damped = false;
    int threads = 1;
    std::string csv;
    std::string tears;
    std::string loads;
    std::string events;
    std::string finalScene;
    std::string controls;
    std::string record;
    std::string replay; // a recording; nothing is flown then but that
    bool profile = false;
    bool json = false;
    bool strict = false;   // ends with an exit code of its own where the accuracy was missed
    bool asksMore = false; // than what to fly, on how many threads, and how to print
};

// Steps like Simulation::runUntil(), so that the window gets the same bits. Returns the wall time,
// s.
double fly(Simulation& simulation, const RunOptions& options, ControlPlayer& controls,
           CsvWriter* table, Settler* settler, Recorder& recorder, GrowingRecording* file,
           EventList* events)
{
    const double end = options.seconds.value_or(SettleGoal().within);
    ProgressLine progress(options.scene.file);
    const double timeStep = simulation.system().timeStep;
    const auto start = std::chrono::steady_clock::now();
    if (table)
        table->add(*simulation.frame());
    while (!hasReached(simulation.state().time, end, timeStep) && !interrupted()
           && !(settler && settler->isOver())) {
        controls.giveTo(simulation);
        if (recorder.beforeStep(simulation) && file)
            file->follow(recorder.recording());
        if (!simulation.step())
            break;
        recorder.afterStep(simulation);
        if (events)
            events->look(simulation);
        if (table)
            table->add(*simulation.frame());
        if (settler)
            settler->look(simulation);
        progress.show(simulation.state().time / end);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<RunEvent> eventsOf(const Recorder& recorder)
{
    return recorder.recording() ? recorder.recording()->events() : std::vector<RunEvent>();
}

// Flies a compiled scene, writes what was asked for and reports.
int flyAndReport(Scene scene, Simulation& simulation, const RunOptions& options,
                 const std::optional<SettleGoal>& goal, ControlTrack track)
{
    std::optional<CsvWriter> table;
    if (!options.csv.empty()) {
        Result<CsvWriter> opened = CsvWriter::open(options.csv, *simulation.frame());
        if (!opened)
            return fail(BadInput, opened.message());
        table = std::move(*opened);
    }
    std::optional<GrowingRecording> file;
    if (!options.record.empty()) {
        Result<GrowingRecording> opened = GrowingRecording::open(options.record);
        if (!opened)
            return fail(BadInput, opened.message());
        file.emplace(std::move(*opened));
    }
    ControlPlayer controls(std::move(track));
    StepTimes times;
    simulation.keepTimes(options.profile ? &times : nullptr);
    std::optional<Settler> settler;
    if (goal)
        settler.emplace(*goal, simulation);
    Recorder recorder;
    if (!options.record.empty()) // otherwise it has no design, and records nothing
        recorder.loaded(simulation, {std::make_shared<const Scene>(scene), {}});
    std::optional<EventList> events;
    if (!options.events.empty() && options.record.empty())
        events.emplace(simulation);
    const double wallSeconds =
        fly(simulation, options, controls, table ? &*table : nullptr, settler ? &*settler : nullptr,
            recorder, file ? &*file : nullptr, events ? &*events : nullptr);
    simulation.keepTimes(nullptr);
    simulation.keepInputs(nullptr);

    // What was flown is reported even when a file cannot be written.
    std::vector<std::optional<Failure>> written;
    if (table)
        written.push_back(table->close(*simulation.frame()));
    if (!options.tears.empty())
        written.push_back(writeTears(scene, *simulation.frame(), options.tears));
    Json unjudged;
    if (!options.loads.empty()) {
        written.push_back(writeLoads(scene, *simulation.frame(), options.loads));
        unjudged = namesWithoutStrength(scene);
    }
    if (!options.events.empty())
        written.push_back(
            writeEvents(scene, events ? events->all() : eventsOf(recorder), options.events));
    if (!options.finalScene.empty())
        written.push_back(
            saveScene(posed(std::move(scene), *simulation.frame()).scene, options.finalScene));
    recorder.finish();
    if (file)
        written.push_back(file->finish());

    Json result = runReport(simulation, wallSeconds);
    if (!options.loads.empty())
        tellUnjudged(std::move(unjudged), result);
    if (settler)
        result["settled"] = settlingOf(settler->progress());
    if (options.profile)
        result["profile"] = profileOf(times, wallSeconds);
    if (options.json)
        print(result);
    else
        printRunTable(result, *simulation.frame()->layout);
    if (options.profile && !options.json)
        printProfile(result);
    for (const auto& failure : written)
        if (failure)
            return fail(BadInput, failure->message);
    if (simulation.trouble())
        return fail(Diverged, simulation.trouble()->message);
    for (const Json& one : result["absurd"])
        fail(Absurd, one.get<std::string>());
    if (!result["absurd"].empty())
        return Absurd;
    if (const Message complaint = simulation.frame()->accuracy.complaint(); !complaint.empty()) {
        fail(Inaccurate, complaint);
        if (options.strict)
            return Inaccurate;
    }
    if (interrupted())
        return fail(Interrupted, "Interrupted; the results are those up to then.");
    return Done;
}

// The goal of a settling run, if one was asked for; wrong usage is a failure that says what is
// wrong.
Result<std::optional<SettleGoal>> settleGoal(const RunOptions& options)
{
    if (!options.settles && !options.seconds)
        return Failure{"--seconds is required, or --settle."};
    if (!options.settles)
        return std::optional<SettleGoal>();
    SettleGoal goal{.damped = options.damped};
    goal.within = options.seconds.value_or(goal.within);
    if (!options.settleSpeed.empty()) {
        const char* const end = options.settleSpeed.data() + options.settleSpeed.size();
        const auto [rest, error] = std::from_chars(options.settleSpeed.data(), end, goal.speed);
        if (error != std::errc() || rest != end || !(goal.speed > 0.0 && goal.speed < 1e9))
            return Failure("--settle: \"%1\" is no speed; give m/s above 0, like 0.01.",
                           options.settleSpeed);
    }
    return std::optional<SettleGoal>(goal);
}

int run(const RunOptions& options)
{
    if (!options.replay.empty())
        return replayFile(options.replay, options.threads, options.json);
    if (options.scene.file.empty())
        return fail(WrongUsage, "SCENE is required, or --replay FILE.");
    if (looksLikeBundle(options.scene.file)) {
        if (options.asksMore)
            return fail(WrongUsage, "A bundle is flown as it was, with --threads and --json alone; "
                                    "fly its scene.ripstop.json for anything else.");
        return flyBundle(options.scene.file, options.threads, options.json);
    }
    const auto goal = settleGoal(options);
    if (!goal)
        return fail(WrongUsage, goal.message());
    SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    const FileNames targets{options.csv,   options.finalScene, options.tears,
                            options.loads, options.events,     options.record};
    const FileNames inputs = inputsOf(*loaded.scene, options.scene.file, {options.controls});
    if (const int code = refuseTargets(targets, inputs); code != Done) // better than after an hour
        return code;
    ControlTrack track;
    if (!options.controls.empty()) {
        Result<ControlTrack> read = readControlTrack(options.controls, *loaded.scene);
        if (!read)
            return fail(BadInput, read.message());
        track = std::move(*read);
    }
    const auto system = compile(*loaded.scene);
    if (!system)
        return fail(BadInput, Message("%1: %2", options.scene.file, system.message()));
    if (options.finalScene.empty() && options.tears.empty() && options.record.empty()
        && options.events.empty() && options.loads.empty())
        loaded.scene = Scene(); // nobody reads it again, and links take a hundred bytes each
    Simulation simulation(*system, options.threads);
    return flyAndReport(std::move(*loaded.scene), simulation, options, *goal, std::move(track));
}

} // namespace

void addRun(CLI::App& app, Command& chosen)
{
    CLI::App* command =
        app.add_subcommand("run", "Fly a scene and report strain, energy, tears and probes.");
    const auto options = std::make_shared<RunOptions>();
    CLI::Option* replay =
        command
            ->add_option("--replay", options->replay,
                         "Compute a recording (*.ripstop-run) once more and compare every step")
            ->type_name("FILE");
    command
        ->add_option("SCENE", options->scene.file,
                     "Scene file, *.ripstop.json; or a bundle, to compare")
        ->excludes(replay);
    command
        ->add_option("--seconds", options->seconds,
                     "Simulated time, s; with --settle the longest, 60 unless given")
        ->check(numberBetween(0.0, 1e9))
        ->type_name("T");
    CLI::Option* settle =
        command
            ->add_option("--settle", options->settleSpeed,
                         "End when nothing has moved faster than SPEED m/s (0.01 unless given) for "
                         "half a second")
            ->expected(0, 1)
            ->type_name("[SPEED]");
    command
        ->add_flag("--kinetic-damping", options->damped,
                   "With --settle: stop all motion whenever its energy has passed a peak")
        ->needs(settle);
    command->add_flag("--strict", options->strict,
                      "End with exit code 5 when the wanted accuracy was missed");
    addSetOption(*command, options->scene.assignments);
    addThreadsOption(*command, options->threads);
    command->add_option("--csv", options->csv, "Write the probes after every time step")
        ->type_name("FILE");
    command
        ->add_option("--tears", options->tears,
                     "Write every break: time, element, part, strain, force, energy, place, event")
        ->type_name("FILE");
    command
        ->add_option("--loads", options->loads,
                     "Write the ten places nearest to breaking, of the last moment and of the run: "
                     "kind, element, part, load, strength, margin, time, place")
        ->type_name("FILE");
    command
        ->add_option("--events", options->events,
                     "Write what happened and when: tears, contact, lines that go slack or taut")
        ->type_name("FILE");
    command
        ->add_option("--final", options->finalScene,
                     "Write the scene as the run has left it: positions, velocities, tears")
        ->type_name("SCENE");
    command
        ->add_option("--controls", options->controls,
                     "What the pilot and hands do: a CSV file of time (s), control, value (m)")
        ->type_name("FILE");
    command
        ->add_option("--record", options->record,
                     "Keep the whole run, to look back at it, to go on from any moment, to compare")
        ->type_name("FILE");
    command->add_flag("--profile", options->profile, "Say where the time went, stage by stage");
    command->add_flag("--json", options->json, "Print one JSON object");
    command->footer(
        "Examples:\n"
        "  ripstop-cli run scenes/delta_kite.ripstop.json --seconds 20 --csv kite.csv\n"
        "  ripstop-cli run kite.ripstop.json --seconds 20 --set \"wind.velocity=8, 0, 0\" --json\n"
        "  ripstop-cli run cloth.ripstop.json --settle --kinetic-damping --final "
        "hung.ripstop.json\n"
        "  ripstop-cli run scenes/torn_sheet.ripstop.json --seconds 3 --tears tears.csv\n"
        "  ripstop-cli run scenes/ripstop_kite.ripstop.json --seconds 5 --loads loads.csv\n"
        "  ripstop-cli run scenes/delta_kite.ripstop.json --seconds 20 --record kite.ripstop-run\n"
        "  ripstop-cli run --replay kite.ripstop-run --threads 2\n"
        "  ripstop-cli run paper.zip                       (a bundle: see bundle --help)\n"
        "\n"
        "The hash is that of the final state: equal for equal bits only.\n"
        "Ctrl-C ends the run and reports what there is. When the simulation diverges, the last\n"
        "good state is reported and the exit code is 3. It is 4 when a replay or a bundle "
        "differs:\n"
        "the first step and particle that do are named.");
    command->callback([options, settle, command, &chosen] {
        options->settles = settle->count() > 0;
        for (const CLI::Option* option : command->get_options({}))
            options->asksMore |= option->count() > 0 && option->get_name() != "SCENE"
                                 && option->get_name() != "--threads"
                                 && option->get_name() != "--json";
        chosen = [options] { return run(*options); };
    });
}

} // namespace ripstop
