// Race 2: what a user feels. The time of one core for 10 ms of simulated time with the largest
// strain below a limit and the right trajectory.
//
// For each network and solver the least efforts are searched for first, one after the other; what
// was found is then timed together, in the same rounds, because times that are compared must see
// the same disturbances. Guesses only save time.
#include "bench/races.h"
#include "bench/report.h"
#include "bench/search.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ripstop {
namespace {

const std::vector<Column> qualityColumns{{"network", -12}, {"below", 6},   {"solver", -16},
                                         {"effort", 14},   {"strain", 9},  {"path error", 10},
                                         {"quiet/s", 9},   {"median/s", 9}};

constexpr double limits[]{0.01, 0.001};

struct Contest
{
    BenchNetwork network;
    std::map<const Choice*, BenchNetwork> own; // of choices that need a system of their own
    Gate gate;
    Path reference;
};

const BenchNetwork& networkFor(const Contest& contest, const Choice& choice)
{
    const auto found = contest.own.find(&choice);
    return found == contest.own.end() ? contest.network : found->second;
}

bool isTooLarge(const Contest& contest, const Choice& choice)
{
    return double(contest.network.system->key.size()) > choice.mostParticles;
}

struct FoundEffort // a row
{
    const Choice* choice;
    double limit;
    Gate gate;
    std::optional<int> effort;
    Quality quality; // the best strain only when no effort was enough
};

// The effort at which a search starts. It saves time and does not change what is found.
int guessFor(const std::string& network, const std::string& solver, double limit)
{
    const int fine = limit < 0.005 ? 4 : 1;
    if (solver == "auto") // what it is told is what it should keep
        return int(std::lround(0.01 / limit));
    if (network == "cloth_100" && solver == "small_steps")
        return 220 * fine;
    if (network == "cloth_32" && solver == "small_steps")
        return 36 * fine;
    if (network == "kite_air" && solver == "small_steps")
        return 24 * fine;
    return 4;
}

// Efforts over the whole range, for the plot of quality against cost.
void addCurve(Search& search, const BenchOptions& options)
{
    for (int effort = 1; effort <= 512; effort *= 2)
        if (!search.at(effort, options.thorough ? 30.0 : 1.0))
            break;
}

double budgetFor(const Contest& contest, const Choice& choice, const BenchOptions& options)
{
    if (options.seconds > 0.0)
        return options.seconds;
    const bool mainChoice = choice.name == std::string_view("small_steps");
    const double least = mainChoice ? 4.0 : 1.5;
    const bool large = contest.network.system->key.size() >= 10000;
    return (options.thorough ? 20.0 : 1.0) * (mainChoice && large ? 15.0 : least);
}

// The least efforts of one solver for each limit: with the right path, and, where it is less, for
// strain alone. What fails for one limit is not tried for a finer one.
void findEfforts(const Contest& contest, const BenchOptions& options, Search& search,
                 const Choice& choice, std::vector<FoundEffort>& findings)
{
    const double budget = budgetFor(contest, choice, options);
    bool hopeful = true;
    for (const double limit : limits) {
        std::optional<int> alone;
        std::optional<int> effort;
        int guess = guessFor(contest.network.name, choice.name, limit);
        if (hopeful)
            alone = search.leastEffort(limit, Gate::Strain, guess, budget);
        if (alone && contest.gate == Gate::StrainAndPath)
            effort = search.leastEffort(limit, contest.gate, *alone, budget);
        const auto add = [&](Gate gate, std::optional<int> found) {
            Quality quality;
            quality.strain = search.best();
            if (found)
                quality = search.tried().at(*found);
            findings.push_back({&choice, limit, gate, found, quality});
        };
        if (contest.gate == Gate::StrainAndPath)
            add(contest.gate, effort);
        if (contest.gate == Gate::Strain || (alone && (!effort || *alone < *effort)))
            add(Gate::Strain, alone);
        hopeful = alone.has_value();
    }
}

std::vector<FoundEffort> findAllEfforts(const Contest& contest, const BenchOptions& options,
                                        Json& curve)
{
    std::vector<FoundEffort> findings;
    const std::string& name = contest.network.name;
    ProgressLine progress("searching " + name);
    for (const Choice& choice : allChoices()) {
        progress.show(double(&choice - allChoices().data()) / double(allChoices().size()));
        if (isTooLarge(contest, choice))
            continue;
        Search search(networkFor(contest, choice), choice, contest.reference);
        findEfforts(contest, options, search, choice, findings);
        if ((name == "cloth_32" || name == "glider_air") && choice.at(1).solver != Solver::Auto)
            addCurve(search, options);
        for (const auto& [effort, quality] : search.tried())
            curve.push_back({{"network", name},
                             {"solver", choice.name},
                             {"effort", effort},
                             {"strain", quality.strain},
                             {"path_error_m", quality.centerError},
                             {"ms_per_step", 1e3 * quality.seconds}});
    }
    return findings;
}

Json rowOf(const Contest& contest, const FoundEffort& finding, const std::vector<double>& times)
{
    Json row{{"network", contest.network.name},
             {"solver", finding.choice->name},
             {"limit", finding.limit},
             {"path_counts", finding.gate == Gate::StrainAndPath},
             {"reached", finding.effort.has_value()},
             {"strain", finding.quality.strain}};
    if (finding.effort) {
        row["effort"] = *finding.effort;
        row["effort_text"] = finding.choice->text(*finding.effort);
        row["path_error_m"] = finding.quality.centerError;
        row["steps_per_second"] = jsonOf(rates(timingSummaryOf(times)));
    }
    return row;
}

void printQuality(Table& table, const Json& row)
{
    std::vector<std::string> cells{row["network"], percent(row["limit"]), row["solver"]};
    if (row["reached"]) {
        const Json& speed = row["steps_per_second"];
        cells.insert(cells.end(), {row["effort_text"], percent(row["strain"]),
                                   fixed(1e3 * row["path_error_m"].get<double>(), 1) + " mm"
                                       + (row["path_counts"] ? "" : "*"),
                                   rate(speed["quiet"]), rate(speed["median"])});
    } else {
        cells.insert(cells.end(), {"not reached", percent(row["strain"]),
                                   row["path_counts"] ? "-" : "*", "-", "-"});
    }
    table.row(cells);
}

// The efforts found, timed in the same rounds.
void timeFindings(const Contest& contest, const std::vector<FoundEffort>& findings,
                  const BenchOptions& options, Table& table, Json& rows)
{
    std::vector<BenchRunner> runners;
    for (const FoundEffort& finding : findings)
        if (finding.effort)
            runners.push_back(engineRunner(networkFor(contest, *finding.choice),
                                           finding.choice->at(*finding.effort)));
    const double budget = options.seconds > 0.0 ? options.seconds : options.quick ? 0.3 : 2.0;
    const auto times = timeInRounds(contest.network.name, runners, budget);
    std::size_t next = 0;
    for (const FoundEffort& finding : findings) {
        rows.push_back(
            rowOf(contest, finding, finding.effort ? times[next++] : std::vector<double>{}));
        printQuality(table, rows.back());
    }
}

} // namespace

std::optional<Json> qualityRace(const BenchOptions& options)
{
    Json rows = Json::array();
    Json curve = Json::array();
    Table table("Time to quality: steps of 10 ms per second of one core with the largest strain "
                "below a limit and the mass centre within 50 mm (* not judged)",
                qualityColumns, !options.json);
    for (const char* name :
         {"glider_air", "kite_air", "rope_pilot", "cloth_10", "cloth_32", "cloth_100"}) {
        if (!isWanted(options, name) || (options.quick && name == std::string_view("cloth_100")))
            continue;
        Contest contest{networkCalled(name),
                        {},
                        name == std::string_view("kite_air") ? Gate::Strain : Gate::StrainAndPath,
                        {}};
        for (const Choice& choice : allChoices())
            if (choice.ownSystem && !isTooLarge(contest, choice))
                contest.own.emplace(&choice, networkCalled(name, choice.at(1).solver));
        contest.reference = referencePath(contest.network, options.references);
        const std::vector<FoundEffort> findings = findAllEfforts(contest, options, curve);
        if (interrupted())
            return std::nullopt;
        timeFindings(contest, findings, options, table, rows);
        if (interrupted())
            return std::nullopt;
    }
    return Json{{"quality", rows}, {"curve", curve}};
}

} // namespace ripstop
