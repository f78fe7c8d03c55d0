// ripstop-cli run: flies a scene and says what came of it.
//
// In order: RunFiles, which opens what is to be written before the run; fly(), which steps as
// Simulation::runUntil() does, so that the window gets the same bits; flyAndReport(), which reports
// what was flown even when a file cannot be written (run_report.h); and run(), which refuses wrong
// options and files that cannot be written before the first step.
#include "bundle/bundle.h"
#include "check/finding.h"
#include "check/strength_gaps.h"
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
#include "scene/typed_number.h"
#include "simulation/simulation.h"
#include "step/step_times.h"
#include "study/probe_names.h"
#include "terminal/output.h"
#include "terminal/terminal.h"

#include <algorithm>
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
    int printed = 0;       // tables that go to the standard output
    bool asksMore = false; // than what to fly, on how many threads, and how to print
};

// What is written and noted while a scene flies, and after.
class RunFiles
{
public:
    RunFiles(const RunOptions& options, const Scene& scene)
        : m_options(options)
        , m_scene(scene)
    {}

    std::optional<Failure> open(Simulation& simulation)
    {
        if (!m_options.csv.empty()) {
            Result<CsvWriter> opened = CsvWriter::open(m_options.csv, *simulation.frame());
            if (!opened)
                return opened.failure();
            m_table = std::move(*opened);
        }
        if (!m_options.record.empty()) {
            Result<GrowingRecording> opened = GrowingRecording::open(m_options.record);
            if (!opened)
                return opened.failure();
            m_recording.emplace(std::move(*opened));
            // otherwise it has no design, and records nothing
            m_recorder.loaded(simulation, {std::make_shared<const Scene>(m_scene), {}});
        } else if (!m_options.events.empty()) {
            m_events.emplace(simulation);
        }
        m_landings.begin();
        if (m_table)
            m_table->add(*simulation.frame());
        return std::nullopt;
    }

    void beforeStep(Simulation& simulation)
    {
        m_landings.beforeStep(simulation);
        if (m_recorder.beforeStep(simulation) && m_recording)
            m_recording->follow(m_recorder.recording());
    }

    void afterStep(Simulation& simulation)
    {
        m_recorder.afterStep(simulation);
        m_landings.afterStep(simulation);
        if (m_events)
            m_events->look(simulation);
        if (m_table)
            m_table->add(*simulation.frame());
    }

    std::span<const Landing> landings() const { return m_landings.all(); }

    // Returns what could not be written.
    std::vector<Failure> finish(const Frame& last)
    {
        std::vector<Failure> failures;
        const auto note = [&](std::optional<Failure> failure) {
            if (failure)
                failures.push_back(std::move(*failure));
        };
        if (m_table)
            note(m_table->close(last));
        if (!m_options.tears.empty())
            note(writeTears(m_scene, last, m_options.tears));
        if (!m_options.loads.empty())
            note(writeLoads(m_scene, last, m_options.loads));
        if (!m_options.events.empty())
            note(writeEvents(m_scene, m_events ? m_events->all() : recordedEvents(),
                             m_options.events));
        if (!m_options.finalScene.empty())
            note(saveScene(posed(m_scene, last).scene, m_options.finalScene));
        m_recorder.finish();
        if (m_recording)
            note(m_recording->finish());
        return failures;
    }

private:
    std::vector<RunEvent> recordedEvents() const
    {
        return m_recorder.recording() ? m_recorder.recording()->events() : std::vector<RunEvent>();
    }

    const RunOptions& m_options;
    const Scene& m_scene;
    std::optional<CsvWriter> m_table;
    std::optional<GrowingRecording> m_recording;
    Recorder m_recorder;
    std::optional<EventList> m_events; // where nothing is recorded
    LandingWatch m_landings;
};

// Steps like Simulation::runUntil(), so that the window gets the same bits. Returns the wall time,
// s.
double fly(Simulation& simulation, const RunOptions& options, ControlPlayer& controls,
           Settler* settler, RunFiles& files)
{
    const double end = options.seconds.value_or(SettleGoal().within);
    ProgressLine progress(options.scene.file);
    const double timeStep = simulation.system().timeStep;
    const auto start = std::chrono::steady_clock::now();
    while (!hasReached(simulation.state().time, end, timeStep) && !interrupted()
           && !(settler && settler->isOver())) {
        controls.giveTo(simulation);
        files.beforeStep(simulation);
        if (!simulation.step())
            break;
        files.afterStep(simulation);
        if (settler)
            settler->look(simulation);
        progress.show(simulation.state().time / end);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The worst place that has borne more than it can and is whole, as its material never tears.
void warnOfOverload(const std::vector<Id>& lasting, const Frame& frame)
{
    for (const LoadedPlace& place : frame.worstOfRun.all()) {
        if (place.torn || place.margin() <= 1.0
            || std::ranges::find(lasting, Id{place.material}) == lasting.end())
            continue;
        const Message element =
            subjectOf(place.kind == LoadKind::Cloth ? Kind::Panel : Kind::Link, Id{place.element});
        return warn(
            Message("%1 has borne %2 times its strength at %3 s and holds, as nothing says that "
                    "its material tears: tearRule=strength has it break.",
                    element, Message::number("%.3g", place.margin()),
                    Message::number("%.3g", place.time))
                .english());
    }
}

// Says on the standard error what was wrong with the run.
//   lasting  materials that never tear
int judge(const Simulation& simulation, const Json& result, const RunOptions& options,
          const std::vector<Id>& lasting)
{
    if (simulation.trouble())
        return fail(Diverged, simulation.trouble()->message);
    for (const Json& one : result["absurd"])
        fail(Absurd, one.get<std::string>());
    if (!result["absurd"].empty())
        return Absurd;
    const auto frame = simulation.frame();
    warnOfOverload(lasting, *frame);
    if (const Message complaint = frame->accuracy.dampingComplaint(); !complaint.empty())
        warn(complaint.english());
    if (const Message complaint = frame->accuracy.loadComplaint(frame->worstOfRun);
        !complaint.empty())
        warn(complaint.english());
    if (const Message complaint = frame->accuracy.complaint(); !complaint.empty()) {
        fail(Inaccurate, complaint);
        if (options.strict)
            return Inaccurate;
    }
    if (interrupted())
        return fail(Interrupted, "Interrupted; the results are those up to then.");
    return Done;
}

// On the standard error where a table has the standard output for itself.
void tellReport(const Json& result, const Layout& layout, const RunOptions& options)
{
    const OutputOnError beside(options.printed > 0);
    if (options.json)
        return print(result);
    printRunTable(result, layout);
    if (options.profile)
        printProfile(result);
}

// Flies a compiled scene, writes what was asked for and reports.
int flyAndReport(const Scene& scene, Simulation& simulation, const RunOptions& options,
                 const std::optional<SettleGoal>& goal, ControlTrack track,
                 const std::vector<Id>& lasting)
{
    RunFiles files(options, scene);
    if (const auto failure = files.open(simulation))
        return fail(BadInput, failure->message);
    ControlPlayer controls(std::move(track));
    StepTimes times;
    simulation.keepTimes(options.profile ? &times : nullptr);
    std::optional<Settler> settler;
    if (goal)
        settler.emplace(*goal, simulation);
    const double wallSeconds =
        fly(simulation, options, controls, settler ? &*settler : nullptr, files);
    simulation.keepTimes(nullptr);
    simulation.keepInputs(nullptr);

    // What was flown is reported even when a file cannot be written.
    const std::vector<Failure> unwritten = files.finish(*simulation.frame());
    Json result = runReport(simulation, wallSeconds);
    result["landings"] = landingsOf(files.landings(), scene);
    tellOpening(scene, result);
    tellWinds(scene, result);
    if (!options.loads.empty())
        tellUnjudged(namesWithoutStrength(scene), result);
    if (settler)
        result["settled"] = settlingOf(settler->progress());
    if (options.profile)
        result["profile"] = profileOf(times, wallSeconds);
    tellReport(result, *simulation.frame()->layout, options);
    for (const Failure& failure : unwritten)
        fail(BadInput, failure.message);
    return unwritten.empty() ? judge(simulation, result, options, lasting) : BadInput;
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
        const Typed typed = typedValue(options.settleSpeed, "m/s", ThreeDigits::AreRefused);
        goal.speed = typed.number ? typed.number->number : 0.0;
        if (!(goal.speed > 0.0 && goal.speed < 1e9))
            return Failure("--settle: \"%1\" is no speed; give m/s above 0, like 0.01.",
                           options.settleSpeed);
    }
    return std::optional<SettleGoal>(goal);
}

// Nobody reads them again, and links take a hundred bytes each. What items are called stays.
void dropElements(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item)) {
            part->particles = {};
            part->links = {};
            part->panels = {};
        }
}

int run(const RunOptions& options)
{
    if (!options.replay.empty())
        return replayFile(options.replay, options.threads, options.json);
    if (options.scene.file.empty())
        return fail(WrongUsage, "SCENE is required, or --replay FILE.");
    if (looksLikeBundle(options.scene.file)) {
        if (options.asksMore) {
            if (const Result<Bundle> bundle = openBundle(options.scene.file); !bundle)
                return fail(BadInput, bundle.message()); // such as a folder that is none
            return fail(WrongUsage, "A bundle is flown as it was, with --threads and --json alone; "
                                    "fly its scene.ripstop.json for anything else.");
        }
        return flyBundle(options.scene.file, options.threads, options.json);
    }
    if (options.printed > 1)
        return fail(WrongUsage, "The standard output takes one table: give the others a file.");
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
    tellWarnings(*loaded.scene, options.scene.file);
    const std::vector<Id> lasting = materialsThatNeverTear(*loaded.scene);
    if (options.finalScene.empty() && options.tears.empty() && options.record.empty()
        && options.events.empty() && options.loads.empty())
        dropElements(*loaded.scene);
    Simulation simulation(*system, options.threads);
    return flyAndReport(*loaded.scene, simulation, options, *goal, std::move(track), lasting);
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
        ->transform(secondsBetween(0.0, 1e9))
        ->type_name("T");
    CLI::Option* settle =
        command
            ->add_option("--settle", options->settleSpeed,
                         "End when nothing has moved faster than SPEED m/s (0.01 unless given) for "
                         "half a swing of a pendulum of its size, half a second at least")
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
    command
        ->add_option("--csv", options->csv,
                     "Write the probes after every time step; - writes to the standard output, as "
                     "it does of the tables below, and the report goes to the standard error")
        ->type_name("FILE");
    command
        ->add_option("--tears", options->tears,
                     "Write every break: time, element, part, strain, force, energy, place, event")
        ->type_name("FILE");
    command
        ->add_option(
            "--loads", options->loads,
            "Write the ten places nearest to breaking, of the last moment and of the run, "
            "and those that broke first: kind, element, part, load, strength, margin, time, place")
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
        for (std::string* table :
             {&options->csv, &options->tears, &options->loads, &options->events})
            options->printed += takeStandardOutput(*table);
        for (const CLI::Option* option : command->get_options({}))
            options->asksMore |= option->count() > 0 && option->get_name() != "SCENE"
                                 && option->get_name() != "--threads"
                                 && option->get_name() != "--json";
        chosen = [options] { return run(*options); };
    });
}

} // namespace ripstop
