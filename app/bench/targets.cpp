// A judge looks up rows of the races by their values and holds their figures against limits. Then
// come the targets themselves, by race: cost of a projection and of whole steps, time to quality,
// growth with size. Targets whose race has not been run have no row and are left out, so that they
// are neither met nor missed.
#include "bench/targets.h"

#include "bench/report.h"

#include <algorithm>
#include <optional>

namespace ripstop {
namespace {

enum class Wanted { AtMost, AtLeast };

class Judge
{
public:
    explicit Judge(const Json& results)
        : m_results(results)
    {}

    // The row that has these values; null when there is none.
    const Json* row(const char* race, const Json& values) const
    {
        if (!m_results.contains(race))
            return nullptr;
        for (const Json& row : m_results[race])
            if (std::all_of(values.items().begin(), values.items().end(), [&](const auto& item) {
                    return row.contains(item.key()) && row[item.key()] == item.value();
                }))
                return &row;
        return nullptr;
    }

    void add(const std::string& what, Wanted wanted, double limit, const Json* figures)
    {
        if (!figures)
            return;
        const double median = (*figures)["median"];
        const double quiet = (*figures)["quiet"];
        const auto meets = [&](double figure) {
            return wanted == Wanted::AtMost ? figure <= limit : figure >= limit;
        };
        m_targets.push_back({{"what", what},
                             {"wanted", wanted == Wanted::AtMost ? "at most" : "at least"},
                             {"limit", limit},
                             {"median", median},
                             {"quiet", quiet},
                             {"met", meets(median)},
                             {"met_when_quiet", meets(quiet)}});
    }

    Json targets() const { return m_targets; }

private:
    const Json& m_results;
    Json m_targets = Json::array();
};

const Json* part(const Json* row, const char* key)
{
    return row && row->contains(key) ? &(*row)[key] : nullptr;
}

void judgeProjections(Judge& judge)
{
    const std::pair<const char*, double> limits[]{{"glider", 3.2},    {"kite", 2.5},
                                                  {"cloth_10", 2.3},  {"cloth_32", 2.3},
                                                  {"cloth_100", 2.3}, {"cloth_316", 2.3}};
    for (const auto& [network, limit] : limits)
        judge.add(std::string("ns per projection, one thread, ") + network, Wanted::AtMost, limit,
                  part(judge.row("projection", {{"network", network}, {"threads", 1}}),
                       "ns_per_projection"));
    for (const char* network :
         {"glider", "kite", "cloth_10", "cloth_32", "cloth_100", "cloth_316", "cloth_1000"}) {
        const bool large = std::string_view(network).starts_with("cloth_")
                           && network != std::string_view("cloth_10");
        judge.add(std::string("two threads against one, ") + network, Wanted::AtLeast,
                  large ? 1.7 : 0.97, // 3 % is lost in the noise of the clock
                  part(judge.row("projection", {{"network", network}, {"threads", 2}}),
                       "times_one_thread"));
    }
    for (const auto& [network, limit] : {std::pair("glider_air", 25000.0), {"kite_air", 15000.0}})
        judge.add(std::string("whole steps with air at 55 sweeps, ") + network, Wanted::AtLeast,
                  limit,
                  part(judge.row("whole_steps", {{"network", network}, {"what", "step"}}),
                       "steps_per_second"));
}

// Of the solvers that reach the limit, the fastest one is judged.
void judgeQuality(Judge& judge, const Json& results)
{
    const std::pair<const char*, double> limits[]{
        {"glider_air", 190000.0}, {"kite_air", 13000.0}, {"cloth_32", 2200.0}, {"cloth_100", 40.0}};
    if (!results.contains("quality"))
        return;
    for (const auto& [network, limit] : limits) {
        const Json* best = nullptr;
        for (const Json& row : results["quality"])
            if (row["network"] == network && row["limit"] == 0.01 && row["reached"]
                && (row["path_counts"] || network == std::string_view("kite_air"))
                && (!best
                    || row["steps_per_second"]["median"] > (*best)["steps_per_second"]["median"]))
                best = &row;
        if (best)
            judge.add(std::string("steps/s with strain below 1 %, ") + network + " ("
                          + (*best)["solver"].get<std::string>() + ")",
                      Wanted::AtLeast, limit, part(best, "steps_per_second"));
    }
}

void judgeGrowth(Judge& judge, const Json& results)
{
    if (!results.contains("exponents"))
        return;
    for (const Json& row : results["exponents"]) {
        if (row["solver"] == "direct") // no sweeps
            continue;
        const Json figures{{"median", row["from_1000"]}, {"quiet", row["from_1000_quiet"]}};
        judge.add("exponent of growth of sweeps, " + row["solver"].get<std::string>(),
                  Wanted::AtMost, 1.05, &figures);
    }
}

} // namespace

Json judgedTargets(const Json& results)
{
    Judge judge(results);
    judgeProjections(judge);
    judgeQuality(judge, results);
    judgeGrowth(judge, results);
    return judge.targets();
}

void printTargets(const Json& targets)
{
    Table table("Targets, on a machine like AMD's EPYC",
                {{"what", -62}, {"wanted", 16}, {"median", 9}, {"quiet", 9}, {"", -18}}, true);
    for (const Json& target : targets)
        table.row({target["what"],
                   target["wanted"].get<std::string>() + " " + shortNumber(target["limit"]),
                   shortNumber(target["median"]), shortNumber(target["quiet"]),
                   target["met"]              ? "met"
                   : target["met_when_quiet"] ? "met when quiet"
                                              : "missed"});
}

} // namespace ripstop
