// ripstop-cli sweep: one table of many runs.
//
// In order: one run (study/flight.h); the table, whose columns are the cloth, the axes and the
// probes of all scenes; and many runs, as many at a time as there are jobs, each on one place of
// the list of orders. The file is replaced by a whole one at most once a second, so that a sweep
// that is interrupted leaves all runs that were done. prepare() refuses what it can before the
// first run.
#include "base/program_version.h"
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/sweep_axes.h"
#include "cli/targets.h"
#include "io/control_track.h"
#include "io/csv.h"
#include "io/json_text.h"
#include "io/whole_file.h"
#include "materials/cloths.h"
#include "study/flight.h"
#include "study/many.h"
#include "study/point_scene.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <mutex>

namespace ripstop {
namespace {

constexpr double mostRuns = 1e6;

struct SweepOptions
{
    std::vector<std::string> scenes;
    std::vector<std::string> sweeps; // "PATH=VALUES"
    std::vector<std::string> assignments;
    std::vector<std::string> cloths; // names of presets, or "all"
    double seconds = 0.0;            // s
    double from = 0.0;               // s, of what means and extremes are over
    std::string output;              // empty for standard output
    std::string controls;
    int threads = 1;
    int jobs = 1;
};

// One run of the sweep: a scene of the list, what its cloth is made of, and a value for each axis.
struct Order
{
    std::size_t scene;
    const Preset* cloth; // null where it stays what it is
    std::vector<std::string> values;
};

struct Sweep
{
    const SweepOptions& options;
    std::vector<SweepAxis> axes;
    std::vector<const Preset*> cloths;
    std::vector<Scene> scenes; // as loaded, with --set
    std::vector<ControlTrack> controls;
    std::vector<Order> orders;
};

FlightResult notFlown(const Message& why)
{
    FlightResult none;
    none.stopped = why.english();
    return none;
}

// Flies one run of the sweep. Returns nothing when it was interrupted.
std::optional<FlightResult> flyOrder(const Sweep& sweep, const Order& order)
{
    Scene base = sweep.scenes[order.scene];
    if (order.cloth) {
        const auto made = presetEdit(base, *order.cloth, clothMaterials(base));
        if (!made)
            return notFlown(made.message());
        (void)apply(base, made->edit);
    }
    std::vector<std::string> assignments;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
        assignments.push_back(sweep.axes[i].path + "=" + order.values[i]);
    const auto scene = sceneWith(base, assignments);
    if (!scene)
        return notFlown(scene.message());
    FlightPlan plan;
    plan.seconds = sweep.options.seconds;
    plan.from = sweep.options.from;
    plan.threads = sweep.options.threads;
    plan.isInterrupted = interrupted;
    return fly(*scene, sweep.controls[order.scene], plan);
}

// --- the table -----------------------------------------------------------------------------------

using Rows = std::vector<std::optional<FlightResult>>; // [orders], those that are done

// Probes are compared by name and unit, so that those of several scenes which are called alike
// share their columns.
bool isSame(const Layout::Probe& a, const Layout::Probe& b)
{
    return a.name == b.name && a.unit == b.unit;
}

std::vector<Layout::Probe> probesOf(const Rows& rows)
{
    std::vector<Layout::Probe> all;
    for (const auto& row : rows)
        if (row)
            for (const Layout::Probe& probe : row->probes)
                if (std::ranges::none_of(all, [&](const auto& p) { return isSame(p, probe); }))
                    all.push_back(probe);
    return all;
}

std::string header(const Sweep& sweep, const std::vector<Layout::Probe>& probes)
{
    std::string text = "# Ripstop " + programVersion() + "; each run until ";
    appendNumber(text, sweep.options.seconds);
    text += " s";
    if (sweep.options.from > 0.0) {
        text += "; means and extremes from ";
        appendNumber(text, sweep.options.from);
        text += " s on";
    }
    text += "\nscene";
    if (!sweep.cloths.empty())
        text += ",cloth";
    for (const SweepAxis& axis : sweep.axes)
        text += ',' + csvCell(axis.path);
    text += ",time (s),steps,hash,torn links,stopped,accuracy";
    for (const Layout::Probe& probe : probes)
        for (const char* what : {" final", " mean", " min", " max"})
            text += ',' + csvCell(withUnit(probe.name + what, probe.unit));
    return text + '\n';
}

std::string line(const Sweep& sweep, const Order& order, const FlightResult& row,
                 const std::vector<Layout::Probe>& probes)
{
    std::string text = csvCell(sweep.options.scenes[order.scene]);
    if (!sweep.cloths.empty())
        text += order.cloth ? ',' + csvCell(order.cloth->name) : ",";
    for (const std::string& value : order.values)
        text += ',' + csvCell(value);
    appendCell(text, row.time);
    text += ',' + std::to_string(row.steps) + ',' + row.hash + ',' + std::to_string(row.torn) + ','
            + csvCell(row.stopped.empty() ? row.absurd : row.stopped) + ','
            + csvCell(row.inaccurate);
    for (const Layout::Probe& probe : probes) {
        const auto found =
            std::ranges::find_if(row.probes, [&](const auto& p) { return isSame(p, probe); });
        if (found == row.probes.end()) {
            text += ",,,,";
            continue;
        }
        const auto first =
            std::size_t(found - row.probes.begin()) * 4; // as usualMeasures() has them
        for (std::size_t i = first; i < first + 4; ++i)
            appendCell(text, i < row.measured.size() ? row.measured[i] : std::nan(""));
    }
    return text + '\n';
}

std::string table(const Sweep& sweep, const Rows& rows)
{
    const std::vector<Layout::Probe> probes = probesOf(rows);
    std::string text = header(sweep, probes);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i])
            text += line(sweep, sweep.orders[i], *rows[i], probes);
    return text;
}

// --- many runs -----------------------------------------------------------------------------------

// Takes the orders one after the other, as many at a time as there are jobs. The file has all that
// are done, whole, a second after each at the latest; more often would write long tables again and
// again.
class Works
{
public:
    explicit Works(const Sweep& sweep)
        : m_sweep(sweep)
        , m_rows(sweep.orders.size())
        , m_progress("sweep")
    {}

    std::optional<Failure> run()
    {
        forEachOfMany(m_rows.size(), m_sweep.options.jobs,
                      [this](std::size_t i) { return work(i); });
        if (!m_failure && m_done > 0)
            save();
        return m_failure;
    }

    const Rows& rows() const { return m_rows; }

private:
    bool work(std::size_t i) // whether to go on
    {
        auto row = flyOrder(m_sweep, m_sweep.orders[i]);
        const std::lock_guard lock(m_mutex);
        if (!row)
            return false;
        m_rows[i] = std::move(row);
        m_progress.show(double(++m_done) / double(m_rows.size()));
        const bool isOld = Clock::now() - m_saved > std::chrono::seconds(1);
        if (isOld && !isDevice(m_sweep.options.output)) // a pipe takes it once
            save();
        return !m_failure;
    }

    void save()
    {
        const std::string& file = m_sweep.options.output;
        if (!file.empty())
            m_failure = replaceFile(file, table(m_sweep, m_rows), Flush::Later);
        m_saved = Clock::now();
    }

    using Clock = std::chrono::steady_clock;

    const Sweep& m_sweep;
    Rows m_rows;
    ProgressLine m_progress;
    std::size_t m_done = 0;
    Clock::time_point m_saved = Clock::now();
    std::optional<Failure> m_failure;
    std::mutex m_mutex;
};

// Every cloth of the library for "all".
std::optional<Failure> findCloths(const std::vector<std::string>& names,
                                  std::vector<const Preset*>& cloths)
{
    for (const std::string& name : names) {
        if (name == "all") {
            cloths = clothPresets();
            return std::nullopt;
        }
        const auto preset = findPreset(name);
        if (!preset)
            return preset.failure();
        if (!isSheet((*preset)->kind))
            return Failure("--cloth %1: this is no fabric; ripstop-cli presets lists them.", name);
        cloths.push_back(*preset);
    }
    return std::nullopt;
}

// A scene without cloth is flown once, as it is.
void addOrders(Sweep& sweep, std::size_t scene)
{
    std::vector<const Preset*> cloths = sweep.cloths;
    if (cloths.empty() || clothMaterials(sweep.scenes[scene]).empty())
        cloths = {nullptr};
    for (const Preset* cloth : cloths)
        for (auto& values : combinations(sweep.axes))
            sweep.orders.push_back({scene, cloth, std::move(values)});
}

// Refuses what can be refused before the first run. Returns the exit code.
int prepare(const SweepOptions& options, Sweep& sweep)
{
    if (options.from > 0.0 && options.from >= options.seconds)
        return fail(WrongUsage,
                    "--from: the runs are over at " + shortNumber(options.seconds)
                        + " s, before anything is measured; begin earlier, or take more "
                          "--seconds.");
    for (const std::string& text : options.sweeps) {
        auto axis = sweepAxis(text);
        if (!axis)
            return fail(WrongUsage, axis.message());
        if (setsControls(axis->path))
            return fail(WrongUsage, "--sweep " + text
                                        + ": a sweep flies one control track, --controls FILE; a "
                                          "study varies them.");
        if (std::ranges::find(sweep.axes, axis->path, &SweepAxis::path) != sweep.axes.end())
            return fail(WrongUsage, "--sweep " + text + ": " + axis->path
                                        + " is varied twice; put all of its values into one list.");
        sweep.axes.push_back(std::move(*axis));
    }
    if (const auto failure = findCloths(options.cloths, sweep.cloths))
        return fail(WrongUsage, failure->message);
    double runs = double(options.scenes.size() * std::max<std::size_t>(1, sweep.cloths.size()));
    for (const SweepAxis& axis : sweep.axes)
        runs *= double(axis.values.size());
    if (runs > mostRuns)
        return fail(WrongUsage, "These are " + shortNumber(runs) + " runs; a sweep has up to "
                                    + shortNumber(mostRuns) + ".");
    for (std::size_t i = 0; i < options.scenes.size(); ++i) {
        SceneOutcome loaded = loadScene({options.scenes[i], options.assignments});
        if (!loaded.scene)
            return loaded.exitCode;
        for (const SweepAxis& axis : sweep.axes)
            if (const auto failure = checkValues(*loaded.scene, axis.path, axis.values))
                return fail(WrongUsage,
                            Message("%1: --sweep %2", options.scenes[i], failure->message));
        const FileNames inputs = inputsOf(*loaded.scene, options.scenes[i], {options.controls});
        if (const int code = refuseTargets({options.output}, inputs); code != Done)
            return code;
        tellWarnings(*loaded.scene, options.scenes[i]);
        std::vector<std::string> paths;
        for (const SweepAxis& axis : sweep.axes)
            paths.push_back(axis.path);
        tellIdle(*loaded.scene, options.scenes[i], paths);
        sweep.controls.emplace_back();
        if (!options.controls.empty()) {
            auto track = readControlTrack(options.controls, *loaded.scene);
            if (!track)
                return fail(BadInput, track.message());
            sweep.controls.back() = std::move(*track);
        }
        sweep.scenes.push_back(std::move(*loaded.scene));
        addOrders(sweep, i);
    }
    return Done;
}

std::string countOf(std::size_t some, std::size_t all)
{
    return std::to_string(some) + " of " + std::to_string(all) + " runs";
}

int sweep(const SweepOptions& options)
{
    Sweep sweep{options, {}, {}, {}, {}, {}};
    if (const int code = prepare(options, sweep); code != Done)
        return code;
    std::size_t done = 0, stopped = 0, absurd = 0;
    {
        Works works(sweep);
        const auto failure = works.run();
        if (failure)
            return fail(BadInput, failure->message);
        for (const auto& row : works.rows()) {
            done += row.has_value();
            stopped += row && !row->stopped.empty();
            absurd += row && !row->absurd.empty();
        }
        if (options.output.empty())
            std::cout << table(sweep, works.rows());
    }
    if (done < sweep.orders.size())
        return fail(Interrupted,
                    "Interrupted; the table has " + countOf(done, sweep.orders.size()) + ".");
    if (stopped > 0)
        return fail(Diverged,
                    countOf(stopped, done) + " ended early: the column \"stopped\" says why.");
    if (absurd > 0)
        return fail(Absurd, countOf(absurd, done)
                                + " ended in a state that no fabric can be in: the column "
                                  "\"stopped\" says what.");
    return Done;
}

} // namespace

void addSweep(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "sweep", "Fly many scenes, or one with many values of its properties, into one table.");
    const auto options = std::make_shared<SweepOptions>();
    command->add_option("SCENES", options->scenes, "Scene files, *.ripstop.json")->required();
    command
        ->add_option("--sweep", options->sweeps,
                     "A property and its values: PATH=100,200,400, or PATH=FROM:STEP:TO with both "
                     "ends, or \"wind.velocity=8,0,0; 6,0,0\", where ; separates values that have "
                     "commas; of several all combinations are "
                     "flown")
        ->type_name("PATH=VALUES")
        ->allow_extra_args(false);
    command
        ->add_option("--cloth", options->cloths,
                     "Presets that all cloth of the scenes is made of, one after the other: "
                     "ripstop_050,skytex_27, or all of the library; lines and spars stay")
        ->delimiter(',')
        ->type_name("PRESETS")
        ->allow_extra_args(false);
    command->add_option("--seconds", options->seconds, "Simulated time of each run, s")
        ->required()
        ->transform(secondsBetween(0.0, 1e9))
        ->type_name("T");
    command
        ->add_option("--from", options->from,
                     "Simulated time, s, from which means and extremes are taken: what comes "
                     "before, as a start that has to die away, does not count")
        ->transform(secondsBetween(0.0, 1e9))
        ->type_name("T");
    command
        ->add_option("-o,--output", options->output, "The table, CSV; on standard output without")
        ->type_name("FILE");
    addSetOption(*command, options->assignments);
    command
        ->add_option("--controls", options->controls,
                     "What pilot and hands do in each run: a control track, as of run --controls")
        ->type_name("FILE");
    command->add_option("--jobs", options->jobs, "Runs at a time; the table is the same for all")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command
        ->add_option("--threads", options->threads,
                     "Threads of each run; the result is the same for all")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command->footer(
        "Examples:\n"
        "  ripstop-cli sweep scenes/delta_kite.ripstop.json --sweep wind.velocity=\"6,0,0; 8,0,0\" "
        "\\\n"
        "      --sweep settings.airDensity=1.0:0.1:1.3 --seconds 10 -o kite.csv --jobs 2\n"
        "  ripstop-cli sweep scenes/*.ripstop.json --cloth all --seconds 5 -o cloths.csv\n"
        "\n"
        "A row for each run: what was set, time and steps that it came to, the hash of its last\n"
        "state, links that tore, and the final, mean, least and largest value of each probe over\n"
        "all steps, or those after --from. A run that stops early says so in its row, and the "
        "others go on; the exit "
        "code\n"
        "is 3 then. One that missed the accuracy that is wanted says so in the column "
        "\"accuracy\".\n"
        " The file is whole at any time and grows while runs end; Ctrl-C keeps the rows\n"
        "of runs that are done.");
    command->callback([options, &chosen] { chosen = [options] { return sweep(*options); }; });
}

} // namespace ripstop
