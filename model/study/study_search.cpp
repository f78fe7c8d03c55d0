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

// A point that fulfils all constraints.
struct FeasiblePoint
{
    std::size_t point;
    Score score;
};

// By the first objective, then by the others, then by their numbers: what comes later dominates
// nothing that comes before.
std::vector<FeasiblePoint> feasiblePoints(const OpenedStudy& opened, const StudyFlights& flights)
{
    std::vector<FeasiblePoint> designs;
    for (std::size_t i = 0; i < flights.size() && !opened.wanted.empty(); ++i)
        if (flights[i])
            if (Score score = scoreOf(opened, *flights[i]); score.isFeasible())
                designs.push_back({i, std::move(score)});
    std::ranges::stable_sort(
        designs, {},
        [](const FeasiblePoint& one) -> const std::vector<double>& { return one.score.objective; });
    return designs;
}

bool isBeaten(const FeasiblePoint& design, const std::vector<FeasiblePoint>& front)
{
    return std::ranges::any_of(
        front, [&](const FeasiblePoint& one) { return dominates(one.score, design.score); });
}

// Those that no other dominates, which are no longer among the rest.
std::vector<FeasiblePoint> takeFront(std::vector<FeasiblePoint>& designs)
{
    std::vector<FeasiblePoint> front, rest;
    for (FeasiblePoint& one : designs)
        (isBeaten(one, front) ? rest : front).push_back(std::move(one));
    designs = std::move(rest);
    return front;
}

std::vector<std::size_t> pointsOf(const std::vector<FeasiblePoint>& designs)
{
    std::vector<std::size_t> points;
    for (const FeasiblePoint& one : designs)
        points.push_back(one.point);
    return points;
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
    std::vector<FeasiblePoint> front;
    for (FeasiblePoint& one : feasiblePoints(opened, flights))
        if (!isBeaten(one, front)
            && (front.empty() || front.back().score.objective != one.score.objective))
            front.push_back(std::move(one));
    return pointsOf(front);
}

std::vector<std::size_t> bestDesigns(const OpenedStudy& opened, const StudyFlights& flights,
                                     std::size_t most)
{
    std::vector<FeasiblePoint> left = feasiblePoints(opened, flights);
    std::vector<std::size_t> best;
    std::set<std::string> keys;
    const auto take = [&](const std::vector<FeasiblePoint>& designs) {
        for (const FeasiblePoint& one : designs)
            if (best.size() < most && keys.insert(opened.key(one.point)).second)
                best.push_back(one.point);
    };
    if (opened.wanted.size() == 1)
        take(left); // each a front of its own
    else
        while (best.size() < most && !left.empty())
            take(takeFront(left));
    return best;
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
