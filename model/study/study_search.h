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

// The best designs, `most` of them or as many as there are, the best first: those that fulfil all
// constraints, by the objective. With several objectives the Pareto front comes first, in the order
// of the first objective, then the front of the others, and so on. Of points that fly the same the
// first.
std::vector<std::size_t> bestDesigns(const OpenedStudy& opened, const StudyFlights& flights,
                                     std::size_t most);

// The first objective of the best feasible point up to each, in its own unit; not a number before
// there is one.
std::vector<double> bestSoFar(const OpenedStudy& opened, const StudyFlights& flights);

} // namespace ripstop
