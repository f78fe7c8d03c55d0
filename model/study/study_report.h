// What a study came to, for people: its variables, how its flights ended, what was measured, the
// best designs, and which variable matters where its plan tells that.
#pragma once

#include "study/sensitivity.h"
#include "study/study_run.h"

#include <string>

namespace ripstop {

enum class ReportFormat { Markdown, Html }; // HTML is a page of its own

std::string studyReport(const OpenedStudy& opened, const StudyFlights& flights,
                        ReportFormat format);

// Of one of readingsOf() (study_map.h), in a plan of sensitivity.
Sensitivity sensitivityOf(const OpenedStudy& opened, const StudyFlights& flights,
                          std::size_t reading);

} // namespace ripstop
