// The table of a study as a file of SQLite, for people who ask it questions.
//
//     flights  a row for each point that is flown, with the columns of the CSV (study_table.h)
//     study    key and value: program, scene, seconds, plan, text (the file of the study)
//
// It is a copy: the ledgers are what a study lives on, as no database is safe on a network file
// system.
#pragma once

#include "base/result.h"
#include "study/study_run.h"

#include <filesystem>
#include <optional>

namespace ripstop {

// Whole or not at all. Takes the place of a file of SQLite, and of none else.
std::optional<Failure> writeStudyDatabase(const OpenedStudy& opened, const StudyFlights& flights,
                                          const std::filesystem::path& file);

} // namespace ripstop
