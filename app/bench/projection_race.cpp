// Race 1: what the visit of a solver to a rod costs, with the whole step around it.
//
// In order: the networks of the race; memory above what the process had before; projections with
// one thread and with more in the same rounds, so that their ratio is fair; and whole steps of
// designs with air, ground and controls.
#include "bench/races.h"
#include "bench/report.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

const std::vector<Column> projectionColumns{{"network", -12}, {"rods", 8},    {"sweeps", 6},
                                            {"threads", 7},   {"quiet", 7},   {"median", 7},
                                            {"slow", 7},      {"steps/s", 9}, {"x 1 thread", 10}};
const std::vector<Column> stepColumns{{"network", -12}, {"panels", 6}, {"sweeps", 6}, {"what", -24},
                                      {"quiet", 9},     {"median", 9}, {"slow", 9}};

struct Case
{
    std::string name;
    int sweeps;
    double seconds; // s of wall time
};

std::vector<Case> cases(const BenchOptions& options)
{
    std::vector<Case> all{{"glider", 55, 1.5},
                          {"kite", 55, 1.5},
                          {"cloth_10", 55, 1.5},
                          {"cloth_32", 55, 2.0},
                          {"cloth_100", 55, 3.0}};
    if (!options.quick) {
        all.push_back({"cloth_316", 10, 4.0});
        all.push_back({"cloth_1000", 10, 6.0});
    }
    for (Case& one : all)
        one.seconds =
            options.seconds > 0.0 ? options.seconds : one.seconds / (options.quick ? 5 : 1);
    return all;
}

// What System, State, Stepper and solver take, above what the process had before.
Json memoryOf(const BenchNetwork& network, long before, long system, long running)
{
    const auto particles = double(network.system->key.size());
    const auto rods = double(network.system->rods.size());
    // a cloth has 6 rods for each particle; particles cost what the arrays of their size add up to
    return {{"particles", particles},
            {"rods", rods},
            {"system_bytes", system - before},
            {"state_and_solver_bytes", running - system},
            {"bytes_per_particle", double(running - before) / particles},
            {"bytes_per_rod", double(running - before) / rods}};
}

Json projectionRow(const BenchNetwork& network, const Setup& setup, const TimingSummary& perStep,
                   const TimingSummary& speedup)
{
    const System& system = *network.system;
    const double visits =
        double(system.rods.size()) * double(setup.substeps) * double(setup.sweeps);
    return {{"network", network.name},
            {"particles", system.key.size()},
            {"rods", system.rods.size()},
            {"solver", choiceNames<Solver>[std::size_t(setup.solver)]},
            {"substeps", setup.substeps},
            {"sweeps", setup.sweeps},
            {"threads", setup.threads},
            {"ns_per_projection", jsonOf(scaled(perStep, 1e9 / visits))},
            {"steps_per_second", jsonOf(rates(perStep))},
            {"times_one_thread", jsonOf(speedup)}};
}

void printProjection(Table& table, const Json& row)
{
    const Json& ns = row["ns_per_projection"];
    table.row({row["network"], std::to_string(row["rods"].get<long>()),
               std::to_string(row["sweeps"].get<int>()), std::to_string(row["threads"].get<int>()),
               fixed(ns["quiet"], 2), fixed(ns["median"], 2), fixed(ns["slow"], 2),
               rate(row["steps_per_second"]["median"]),
               fixed(row["times_one_thread"]["median"], 2)});
}

// One network with one thread and with more, in the same rounds.
bool projection(const BenchOptions& options, const Case& one, Table& table, Json& rows,
                Json& memory)
{
    const long before = residentBytes();
    const BenchNetwork network = networkCalled(one.name);
    const long system = residentBytes();
    std::vector<Setup> setups;
    std::vector<BenchRunner> runners;
    for (int threads : {1, options.threads}) {
        if (threads == 1 && !setups.empty())
            continue;
        setups.push_back({Solver::GaussSeidel, 1, one.sweeps, threads});
        runners.push_back(engineRunner(network, setups.back()));
        if (one.name == "cloth_1000" && setups.size() == 1)
            memory = memoryOf(network, before, system, residentBytes());
    }
    const auto times = timeInRounds(one.name, runners, one.seconds);
    if (interrupted())
        return false;
    for (std::size_t i = 0; i < setups.size(); ++i) {
        rows.push_back(projectionRow(network, setups[i], timingSummaryOf(times[i]),
                                     timingSummaryOf(ratios(times[0], times[i]))));
        printProjection(table, rows.back());
    }
    return true;
}

// The step of a design as it is, with air, ground and controls; and with what a running simulation
// does besides: it keeps the last good state and looks for trouble.
bool wholeSteps(const BenchOptions& options, const std::string& name, Table& table, Json& rows)
{
    const BenchNetwork network = networkCalled(name + "_air");
    const Setup setup{Solver::GaussSeidel, 1, 55, 1};
    apply(setup, *network.system);
    const auto simulation = std::make_shared<std::unique_ptr<Simulation>>();
    std::vector<BenchRunner> runners{engineRunner(network, setup),
                                     {[simulation, system = network.system] {
                                          *simulation = std::make_unique<Simulation>(system);
                                      },
                                      [simulation] { (*simulation)->step(); }}};
    const auto times = timeInRounds(network.name, runners,
                                    options.seconds > 0.0 ? options.seconds
                                    : options.quick       ? 0.4
                                                          : 2.0);
    if (interrupted())
        return false;
    const char* const what[]{"step", "step and watchdog"};
    // a kite on 25 m of line flutters at 55 sweeps, and a stopped simulation is no measure
    const std::size_t sound = (*simulation)->trouble() ? 1 : 2;
    for (std::size_t i = 0; i < sound; ++i) {
        const TimingSummary figures = rates(timingSummaryOf(times[i]));
        rows.push_back({{"network", network.name},
                        {"panels", network.system->panels.size()},
                        {"sweeps", setup.sweeps},
                        {"what", what[i]},
                        {"steps_per_second", jsonOf(figures)}});
        table.row({network.name, std::to_string(network.system->panels.size()), "55", what[i],
                   rate(figures.quiet), rate(figures.median), rate(figures.slow)});
    }
    return true;
}

} // namespace

std::optional<Json> projectionRace(const BenchOptions& options)
{
    Json rows = Json::array();
    Json steps = Json::array();
    Json memory;
    {
        Table table("Cost of a projection: ns of a whole step / (sweeps x rods), no air",
                    projectionColumns, !options.json);
        for (const Case& one : cases(options))
            if (isWanted(options, one.name) && !projection(options, one, table, rows, memory))
                return std::nullopt;
    }
    Table table("Whole steps per second with air, one thread", stepColumns, !options.json);
    for (const char* name : {"glider", "kite"})
        if (isWanted(options, std::string(name) + "_air")
            && !wholeSteps(options, name, table, steps))
            return std::nullopt;
    if (!memory.is_null()) {
        Table bytes("Memory of cloth_1000: System, State, Stepper",
                    {{"particles", 10}, {"rods", 10}, {"bytes/particle", 14}, {"bytes/rod", 10}},
                    !options.json);
        bytes.row({rate(memory["particles"]), rate(memory["rods"]),
                   fixed(memory["bytes_per_particle"], 0), fixed(memory["bytes_per_rod"], 0)});
    }
    return Json{{"projection", rows}, {"whole_steps", steps}, {"memory", memory}};
}

} // namespace ripstop
