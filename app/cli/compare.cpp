// ripstop-cli compare: how far two recordings are apart.
#include "cli/commands.h"
#include "cli/replay.h"
#include "cli/scene_input.h"
#include "recording/compare_runs.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace ripstop {
namespace {

struct CompareOptions
{
    std::string a;
    std::string b;
    double interval = 0.1; // s
    bool json = false;
};

void printTable(const std::vector<RunDistance>& list)
{
    std::cout << "    time (s)     rms (m)    most (m)   particle\n";
    for (const RunDistance& row : list) {
        char line[96];
        std::snprintf(line, sizeof line, "%12.6g%12.4g%12.4g%11u\n", row.time, row.rms, row.most,
                      row.farthest);
        std::cout << line;
    }
}

Json jsonOf(const std::vector<RunDistance>& list)
{
    Json rows = Json::array();
    for (const RunDistance& row : list)
        rows.push_back({{"time", row.time},
                        {"particles", row.particles},
                        {"rms", row.rms},
                        {"most", row.most},
                        {"particle", row.farthest}});
    return rows;
}

int compare(const CompareOptions& options)
{
    const OpenedRecording a = openOrSay(options.a);
    const OpenedRecording b = a.recording ? openOrSay(options.b) : OpenedRecording();
    if (!b.recording)
        return BadInput;
    ProgressLine progress("comparing");
    const auto list = compareRuns(*a.recording, *b.recording, options.interval, [&](double share) {
        progress.show(share);
        return !interrupted();
    });
    if (!list)
        return fail(interrupted() ? Interrupted : BadInput, list.message());
    if (options.json)
        print({{"distances", jsonOf(*list)}});
    else
        printTable(*list);
    if (list->front().particles == 0)
        return fail(BadInput, "The two have no particle in common: they are of other designs.");
    const bool same = std::all_of(list->begin(), list->end(),
                                  [](const RunDistance& row) { return row.most == 0.0; });
    if (!same)
        return Differs;
    const bool isWhole = a.damage.empty() && b.damage.empty();
    return isWhole ? Done : BadInput; // openOrSay() has printed the damage
}

} // namespace

void addCompare(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "compare", "Tell how far the particles of two recordings are apart, over time.");
    const auto options = std::make_shared<CompareOptions>();
    command->add_option("FIRST", options->a, "Recording, *.ripstop-run")->required();
    command->add_option("SECOND", options->b, "Another one, of the same particles")->required();
    command->add_option("--interval", options->interval, "Between rows, s; 0 is every frame")
        ->transform(secondsBetween(0.0, 1e9))
        ->type_name("S");
    command->add_flag("--json", options->json, "Print one JSON object");
    command->footer("Example:\n"
                    "  ripstop-cli compare calm.ripstop-run gusty.ripstop-run --interval 0.5\n"
                    "\n"
                    "Particles are the same when their ids are. The exit code is 0 when all are at "
                    "the same places,\n4 when they are not.");
    command->callback([options, &chosen] { chosen = [options] { return compare(*options); }; });
}

} // namespace ripstop
