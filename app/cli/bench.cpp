// ripstop-cli bench: how fast the engine is on this machine.
//
// bench() runs the races that are wanted one after the other, or the single one that was named;
// addBench() has the options.
#include "bench/quality.h"
#include "bench/races.h"
#include "bench/report.h"
#include "bench/targets.h"
#include "cli/commands.h"
#include "cli/scene_input.h"

#include <algorithm>
#include <iostream>
#include <thread>

namespace ripstop {
namespace {

int bench(const BenchOptions& options, const std::string& only)
{
    Json results{{"machine", machine()}, {"threads", options.threads}};
    if (!options.json)
        std::cout << machineText(results["machine"]) << '\n';
    for (const Race& race : races()) {
        if (!only.empty() && only != race.name)
            continue;
        std::optional<Json> rows = race.run(options);
        if (!rows)
            return fail(Interrupted, "Interrupted.");
        results.update(*rows);
    }
    if (std::all_of(results.begin(), results.end(),
                    [](const Json& part) { return !part.is_array() || part.empty(); }))
        return fail(WrongUsage, "No case has \"" + options.filter + "\" in its name.");
    results["targets"] = judgedTargets(results);
    if (options.json)
        print(results);
    else
        printTargets(results["targets"]);
    return Done;
}

std::vector<std::string> raceNames()
{
    std::vector<std::string> names;
    for (const Race& race : races())
        names.emplace_back(race.name);
    return names;
}

} // namespace

void addBench(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand("bench", "Measure the speed of the engine.");
    const auto options = std::make_shared<BenchOptions>();
    const auto only = std::make_shared<std::string>();
    const auto make = std::make_shared<bool>(false);
    options->threads = std::clamp(int(std::thread::hardware_concurrency()), 1, 2);
    options->references = REFERENCE_FOLDER;
    command->add_option("--race", *only, "Only this race; all of them without")
        ->check(CLI::IsMember(raceNames()))
        ->type_name("NAME");
    command->add_option("--filter", options->filter, "Only networks with this in their name")
        ->type_name("TEXT");
    command->add_option("--seconds", options->seconds, "Wall time for each network, about, s")
        ->check(numberBetween(1e-3, 1e4))
        ->type_name("T");
    command->add_option("--threads", options->threads, "Threads that are compared with one")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str()
        ->type_name("N");
    command->add_flag("--quick", options->quick, "Short, and without the largest networks");
    command->add_flag("--thorough", options->thorough, "Search however long it takes");
    command->add_flag("--json", options->json, "Print one JSON object");
    command->add_option("--references", options->references, "Folder of converged trajectories")
        ->type_name("FOLDER");
    command->add_flag("--make-references", *make, "Compute those trajectories again, and end");
    command->footer(
        "Examples:\n"
        "  ripstop-cli bench\n"
        "  ripstop-cli bench --race projection --filter cloth --threads 2 --json\n"
        "\n"
        "The first race is the cost of a projection, the visit of a solver to a rod: the time of\n"
        "a step, all stages included, divided by substeps x sweeps x rods. The second is the time\n"
        "to quality: steps of 10 ms per second at which no rod is stretched by more than a limit\n"
        "and the mass centre goes where it should. The third is the growth of cost with size, the\n"
        "fourth the time from an edit of a large cloth to its running simulation, the fifth the\n"
        "time to write 600 frames of a cloth in each format of exports.\n"
        "All things compared run in turn, in blocks of 3 ms. Quiet is the 10th percentile of\n"
        "the blocks, slow the 90th.");
    command->callback([options, only, make, &chosen] {
        chosen = [options, only, make]() -> int {
            if (!*make)
                return bench(*options, *only);
            return makeReferences(options->references)
                       ? Done
                       : fail(interrupted() ? Interrupted : BadInput,
                              "The references could not be written to " + options->references
                                  + ".");
        };
    });
}

} // namespace ripstop
