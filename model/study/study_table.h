// The table of a study: a row for each point that is flown, as `study merge` and the window write
// it. What was set, how the flight went, the hash of its last state, and what was measured.
#pragma once

#include "study/study_run.h"

#include <string>

namespace ripstop {

// CSV with a line before the heading that says program, scene and end.
std::string studyTable(const OpenedStudy& opened, const StudyFlights& flights);

} // namespace ripstop
