// What a study is for: which measures are wanted small, large or at a value, and what a design has
// to fulfil besides.
//
// A flight has a score: an objective each, of which less is better, and how far it breaks each
// constraint. Of two flights the one is better that breaks the constraints by less in sum, and of
// two that break them alike the one whose objectives are no worse and one of them better (Deb and
// others 2002). One that ended early, or lacks a number, breaks them beyond all measure.
#pragma once

#include "study/measure.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace ripstop {

struct FlightResult; // flight.h
struct OpenedStudy;  // opened_study.h

enum class Goal { Minimise, Maximise, Target };

template <>
inline constexpr std::array choiceNames<Goal>{"minimise", "maximise", "target"};

struct Objective
{
    Measure measure;
    Goal goal = Goal::Minimise;
    double target = 0.0; // of Goal::Target, in the unit of the probe
};

// What has to be so of the outcome of a flight.
enum class WantedOutcome { NoTear, Accurate };

template <>
inline constexpr std::array choiceNames<WantedOutcome>{"no_tear", "accurate"};

struct Constraint
{
    enum class Kind { AtMost, AtLeast, Outcome };
    Kind kind = Kind::Outcome;
    Measure measure;    // of AtMost and AtLeast
    double limit = 0.0; // of those, in the unit of the probe
    WantedOutcome outcome = WantedOutcome::NoTear;
};

struct Score
{
    std::vector<double> objective; // [objectives] less is better; all infinite unless it is whole
    std::vector<double> excess; // [constraints with a limit] 1, of the limit; above 0 where it is
                                // broken
    bool isWhole = false;       // the flight came to its end and has all numbers
    int brokenOutcomes = 0;     // wanted outcomes that did not come

    // 0 when all constraints hold, infinite of what is not whole.
    double violation() const;
    bool isFeasible() const { return violation() == 0.0; }
};

// Whether the first is better.
bool dominates(const Score& one, const Score& other);

Score scoreOf(const OpenedStudy& opened, const FlightResult& flight);

// "maximise line angle mean (deg)", of each objective.
std::vector<std::string> objectiveTitles(const OpenedStudy& opened);

} // namespace ripstop
