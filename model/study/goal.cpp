// scoreOf() makes each number so that less is better; dominates() is the order of all searches.
#include "study/goal.h"

#include "io/json_text.h"
#include "study/opened_study.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// Whether all numbers that objectives and constraints need are there.
bool hasNumbers(const OpenedStudy& opened, const FlightResult& flight)
{
    const auto isThere = [&](std::size_t measure) {
        return measure < flight.measured.size() && std::isfinite(flight.measured[measure]);
    };
    const std::vector<Constraint>& constraints = opened.study.constraints;
    for (std::size_t i = 0; i < constraints.size(); ++i)
        if (constraints[i].kind != Constraint::Kind::Outcome && !isThere(opened.constrained[i]))
            return false;
    return std::ranges::all_of(opened.wanted, isThere);
}

double objectiveOf(const Objective& objective, double value)
{
    switch (objective.goal) {
    case Goal::Minimise:
        return value;
    case Goal::Maximise:
        return -value;
    case Goal::Target: // squared, so that it is smooth where it is met
        return (value - objective.target) * (value - objective.target);
    }
    return value;
}

double excessOf(const Constraint& constraint, double value)
{
    const double size = constraint.limit != 0.0 ? std::abs(constraint.limit) : 1.0;
    const double beyond = (value - constraint.limit) / size;
    return constraint.kind == Constraint::Kind::AtMost ? beyond : -beyond;
}

bool hasCome(WantedOutcome outcome, const FlightResult& flight)
{
    return outcome == WantedOutcome::NoTear ? flight.torn == 0 : flight.inaccurate.empty();
}

} // namespace

double Score::violation() const
{
    if (!isWhole)
        return std::numeric_limits<double>::infinity();
    double sum = brokenOutcomes;
    for (const double one : excess)
        sum += std::max(0.0, one);
    return sum;
}

bool dominates(const Score& one, const Score& other)
{
    const double a = one.violation();
    const double b = other.violation();
    if (a != b)
        return a < b;
    bool isBetter = false;
    for (std::size_t i = 0; i < one.objective.size(); ++i) {
        if (one.objective[i] > other.objective[i])
            return false;
        isBetter |= one.objective[i] < other.objective[i];
    }
    return isBetter;
}

Score scoreOf(const OpenedStudy& opened, const FlightResult& flight)
{
    const Study& study = opened.study;
    Score score;
    score.isWhole = !flight.endedEarly() && hasNumbers(opened, flight);
    if (!score.isWhole) {
        score.objective.assign(study.objectives.size(), std::numeric_limits<double>::infinity());
        return score;
    }
    for (std::size_t i = 0; i < study.objectives.size(); ++i)
        score.objective.push_back(
            objectiveOf(study.objectives[i], flight.measured[opened.wanted[i]]));
    for (std::size_t i = 0; i < study.constraints.size(); ++i) {
        const Constraint& constraint = study.constraints[i];
        if (constraint.kind == Constraint::Kind::Outcome)
            score.brokenOutcomes += hasCome(constraint.outcome, flight) ? 0 : 1;
        else
            score.excess.push_back(excessOf(constraint, flight.measured[opened.constrained[i]]));
    }
    return score;
}

std::vector<std::string> objectiveTitles(const OpenedStudy& opened)
{
    std::vector<std::string> titles;
    for (std::size_t i = 0; i < opened.wanted.size(); ++i) {
        const Objective& objective = opened.study.objectives[i];
        std::string title(choiceNames<Goal>[std::size_t(objective.goal)]);
        if (objective.goal == Goal::Target)
            title += ' ' + numberText(objective.target) + " of";
        titles.push_back(title + ' ' + opened.headings[opened.wanted[i]]);
    }
    return titles;
}

} // namespace ripstop
