// The table of a study: a row for each point that is flown, as `study merge` and the window write
// it. What was set, how the flight went, the hash of its last state, and what was measured; where
// something is wanted, the objectives, by how much constraints are broken (nothing where the flight
// was not whole), and 1 for the best, or for those on the Pareto front.
#pragma once

#include "study/study_run.h"

#include <string>
#include <vector>

namespace ripstop {

struct StudyTableRows
{
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows; // empty cells where there is nothing
};
StudyTableRows studyTableRows(const OpenedStudy& opened, const StudyFlights& flights);

// CSV with a line before the heading that says program, scene and end.
std::string studyTable(const OpenedStudy& opened, const StudyFlights& flights);

} // namespace ripstop
