// followSearch() tells the optimiser whole batches; what is best is found by going through all
// flights.
#include "study/study_search.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ripstop {
namespace {

void addAsked(OpenedStudy& opened)
{
    for (const SharePlace& place : opened.optimiser->asked())
        opened.points.add(place);
}

} // namespace

void beginSearch(OpenedStudy& opened)
{
    if (opened.study.plan.kind != StudyPlan::Kind::Optimise)
        return;
    opened.optimiser.emplace(opened.study.plan, opened.study.variables.size());
    addAsked(opened);
}

void followSearch(OpenedStudy& opened, const LedgerRows& rows)
{
    while (opened.optimiser && opened.told < opened.points.count()) {
        std::vector<Score> scores;
        for (std::size_t i = opened.told; i < opened.points.count(); ++i) {
            const auto row = rows.find(opened.key(i));
            if (row == rows.end())
                return;
            scores.push_back(scoreOf(opened, row->second));
        }
        opened.told = opened.points.count();
        opened.optimiser->tell(scores);
        addAsked(opened);
    }
}

std::vector<std::size_t> bestPoints(const OpenedStudy& opened, const StudyFlights& flights)
{
    if (opened.wanted.empty())
        return {};
    struct Best
    {
        std::size_t point;
        Score score;
    };
    std::vector<Best> best; // of those that were looked at
    for (std::size_t i = 0; i < flights.size(); ++i) {
        if (!flights[i])
            continue;
        Score score = scoreOf(opened, *flights[i]);
        const bool isBeaten =
            !score.isFeasible() || std::ranges::any_of(best, [&](const Best& one) {
                return dominates(one.score, score) || one.score.objective == score.objective;
            });
        if (isBeaten)
            continue;
        std::erase_if(best, [&](const Best& one) { return dominates(score, one.score); });
        best.push_back({i, std::move(score)});
    }
    std::ranges::stable_sort(best, {}, [](const Best& one) { return one.score.objective.front(); });
    std::vector<std::size_t> points;
    for (const Best& one : best)
        points.push_back(one.point);
    return points;
}

std::vector<double> bestSoFar(const OpenedStudy& opened, const StudyFlights& flights)
{
    std::vector<double> values(flights.size(), std::nan(""));
    std::optional<Score> best;
    double value = std::nan("");
    for (std::size_t i = 0; i < flights.size() && !opened.wanted.empty(); ++i) {
        if (flights[i]) {
            Score score = scoreOf(opened, *flights[i]);
            const bool isBetter = !best || score.objective.front() < best->objective.front();
            if (score.isFeasible() && isBetter) {
                value = flights[i]->measured[opened.wanted.front()];
                best = std::move(score);
            }
        }
        values[i] = value;
    }
    return values;
}

} // namespace ripstop
