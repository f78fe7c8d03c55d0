// ripstop-cli bench: how fast the engine is on this machine, on three designs of known size.
#include "builders/builder.h"
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/terminal.h"
#include "compile/compile.h"
#include "run/simulation.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <thread>

namespace ripstop {
namespace {

struct Case
{
    const char* name;
    const char* builder;
    Parameters parameters;
    bool rods; // turn every spring into a rod of the same stiffness
    const char* what;
};

const std::vector<Case>& allCases()
{
    static const std::vector<Case> cases{
        {"hang_glider", "hang_glider", {}, false, "the paper's wing with its pilot"},
        {"delta_kite", "delta_kite", {}, false, "the paper's kite on its line"},
        {"cloth_rods",
         "cloth",
         {{"columns", 100}, {"rows", 100}, {"sphere", 0}},
         true,
         "100 x 100 cells of cloth, tied by rods"},
        {"cloth_springs",
         "cloth",
         {{"columns", 100}, {"rows", 100}, {"sphere", 0}},
         false,
         "the same cloth, tied by springs"},
    };
    return cases;
}

struct Options
{
    std::string filter;
    int repetitions = 5;
    double seconds = 1.0; // s of wall time per repetition, about
    int threads = 1;
    bool json = false;
};

void tieByRods(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            for (Link& link : part->links) {
                const Material* material = findItem<Material>(scene, link.material);
                const double stiffness =
                    link.stiffness.value_or(material ? material->stiffness : 0.0);
                link.kind = LinkKind::Rod;
                link.compliance = stiffness > 0.0 ? 1.0 / stiffness : 0.0;
            }
}

Result<std::shared_ptr<const System>> systemOf(const Case& benchmark)
{
    const Builder* builder = findBuilder(benchmark.builder);
    if (!builder)
        return Failure{"The builder " + std::string(benchmark.builder) + " is missing."};
    Result<Scene> scene = build(*builder, benchmark.parameters);
    if (!scene)
        return scene.failure();
    if (benchmark.rods)
        tieByRods(*scene);
    return compile(*scene);
}

double wallSeconds(Simulation& simulation, long steps)
{
    const auto start = std::chrono::steady_clock::now();
    for (long i = 0; i < steps; ++i)
        if (!simulation.step())
            return 0.0;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Wall time of one time step in s, for each repetition. All of them fly the same stretch of time
// from the design. Empty when the simulation diverged.
std::vector<double> measure(const std::shared_ptr<const System>& system, const Options& options)
{
    // the first flights warm caches up and tell how many steps fit
    long steps = 1;
    for (bool enough = false; !enough && !interrupted();) {
        Simulation trial(system, options.threads);
        const double taken = wallSeconds(trial, steps);
        if (trial.trouble())
            return {};
        enough = taken > 0.1 * options.seconds;
        steps = enough ? std::max(1L, long(double(steps) * options.seconds / taken)) : 2 * steps;
    }
    std::vector<double> times;
    for (int i = 0; i < options.repetitions && !interrupted(); ++i) {
        Simulation simulation(system, options.threads);
        times.push_back(wallSeconds(simulation, steps) / double(steps));
        if (simulation.trouble())
            return {};
    }
    std::sort(times.begin(), times.end());
    return times;
}

Json resultOf(const Case& benchmark, const System& system, const std::vector<double>& times)
{
    const double median = times[times.size() / 2];
    const double least = times.front();
    const double projections =
        double(system.rods.size()) * double(system.substeps) * double(system.sweeps);
    const double springVisits = double(system.springs.size()) * double(system.substeps);
    const auto perProjection = [&](double time) {
        return projections > 0.0 ? Json(1e9 * time / projections) : Json();
    };
    return {{"name", benchmark.name},
            {"what", benchmark.what},
            {"particles", system.key.size()},
            {"rods", system.rods.size()},
            {"springs", system.springs.size()},
            {"panels", system.panels.size()},
            {"time_step", system.timeStep},
            {"substeps", system.substeps},
            {"sweeps", system.sweeps},
            {"repetitions", times.size()},
            {"steps_per_second", 1.0 / median},
            {"best_steps_per_second", 1.0 / least},
            {"real_time_ratio", system.timeStep / median},
            {"ns_per_rod_projection", perProjection(median)},
            {"best_ns_per_rod_projection", perProjection(least)},
            {"ns_per_spring", springVisits > 0.0 ? Json(1e9 * median / springVisits) : Json()}};
}

std::string processor()
{
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return "unknown processor";
}

Json machine(const Options& options)
{
    return {{"processor", processor()},   {"cores", std::thread::hardware_concurrency()},
            {"threads", options.threads}, {"compiler", "g++ " __VERSION__},
#ifdef NDEBUG
            {"build", "optimised"},
#else
            {"build", "with checks: figures mean little"},
#endif
            {"version", RIPSTOP_VERSION}};
}

void printRow(const Json& result)
{
    const auto cell = [](const std::string& text, std::size_t width) {
        std::cout << text << std::string(width - std::min(text.size(), width - 1), ' ');
    };
    cell(result["name"], 16);
    cell(std::to_string(result["rods"].get<long>()), 10);
    cell(std::to_string(result["springs"].get<long>()), 10);
    cell(shortNumber(result["steps_per_second"]), 14);
    cell(shortNumber(result["real_time_ratio"]), 14);
    const Json& median = result["ns_per_rod_projection"];
    const Json& least = result["best_ns_per_rod_projection"];
    std::cout << (median.is_null() ? "no rods"
                                   : shortNumber(median) + " (best " + shortNumber(least) + ")")
              << std::endl;
}

int bench(const Options& options)
{
    Json results = Json::array();
    const Json where = machine(options);
    if (!options.json)
        std::cout << where["processor"].get<std::string>() << ", "
                  << where["compiler"].get<std::string>() << ", "
                  << where["build"].get<std::string>() << ", " << options.threads
                  << " thread(s); median of " << options.repetitions << "\n\n"
                  << "case            rods      springs   steps/s       x real time   "
                     "ns per rod projection\n";
    catchInterrupt();
    for (const Case& benchmark : allCases()) {
        if (std::string_view(benchmark.name).find(options.filter) == std::string_view::npos)
            continue;
        const auto system = systemOf(benchmark);
        if (!system)
            return fail(BadInput, system.message());
        const std::vector<double> times = measure(*system, options);
        if (interrupted())
            return fail(Interrupted, "Interrupted.");
        if (times.empty())
            return fail(Diverged, std::string(benchmark.name) + " diverged.");
        results.push_back(resultOf(benchmark, **system, times));
        if (!options.json)
            printRow(results.back());
    }
    if (results.empty())
        return fail(WrongUsage, "No case has \"" + options.filter + "\" in its name.");
    if (options.json)
        print({{"machine", where}, {"cases", std::move(results)}});
    return Done;
}

} // namespace

void addBench(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand("bench", "Measure the speed of the engine.");
    const auto options = std::make_shared<Options>();
    command->add_option("--filter", options->filter, "Only cases with this in their name")
        ->type_name("TEXT");
    command->add_option("--repeat", options->repetitions, "Repetitions of each case")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str()
        ->type_name("N");
    command->add_option("--seconds", options->seconds, "Wall time of a repetition, about, s")
        ->check(numberBetween(1e-3, 1e3))
        ->capture_default_str()
        ->type_name("T");
    command->add_option("--threads", options->threads, "Threads")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str()
        ->type_name("N");
    command->add_flag("--json", options->json, "Print one JSON object");
    command->footer("Examples:\n"
                    "  ripstop-cli bench\n"
                    "  ripstop-cli bench --filter cloth --threads 4 --json\n"
                    "\n"
                    "A rod projection is one visit of the solver to one rod: the time of a step,\n"
                    "all stages included, is divided by substeps x sweeps x rods.");
    command->callback([options, &chosen] { chosen = [options] { return bench(*options); }; });
}

} // namespace ripstop
