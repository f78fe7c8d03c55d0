// An optimisation as a study: its points come of its flights.
//
// The optimiser (optimiser.h) asks for a batch of points; when the ledgers have all of them, it is
// told their scores and asks for the next. Points that were flown before are so read and not flown,
// and whoever has the rows of a study knows its points.
#pragma once

#include "study/goal.h"
#include "study/study_run.h"

#include <optional>
#include <vector>

namespace ripstop {

// Makes the first points of a plan that optimises; other plans have theirs.
void beginSearch(OpenedStudy& opened);

// Adds the points that follow from these rows, as far as that can be told.
void followSearch(OpenedStudy& opened, const LedgerRows& rows);

// The points that no other flown one dominates, among those that fulfil all constraints: with one
// objective the best, with several the Pareto front, in the order of the first objective. Of points
// that are alike the first.
std::vector<std::size_t> bestPoints(const OpenedStudy& opened, const StudyFlights& flights);

// The first objective of the best feasible point up to each, in its own unit; not a number before
// there is one.
std::vector<double> bestSoFar(const OpenedStudy& opened, const StudyFlights& flights);

} // namespace ripstop
