// Recordings that a study keeps beside its rows (KeptRuns), KEY.ripstop-run each.
//
// Which flights are the best is only known when the others are flown, so they are flown again for
// their recordings once a run of the study has flown what was missing. A flight that is overtaken
// loses its recording. The best of what is in the ledgers are the same whoever asks: shards settle
// it one after the other, and what the last of them leaves is what one alone would have left.
#pragma once

#include "study/study_run.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace ripstop {

// The file of a flight that was kept with its frames, whether it is there or not.
std::filesystem::path keptRun(const OpenedStudy& opened, std::size_t point);

// What is in that file, with what the probes read at its frames; nothing where it is not there or
// does not end as the row says.
std::optional<RecordedFlight> readKeptRun(const OpenedStudy& opened, std::size_t point,
                                          const FlightResult& row);

// Of a study that keeps the best: makes those recordings that are not there, and removes those of
// flights that were overtaken. Gives the points whose recordings are there, the best first: fewer
// than the best when it was interrupted. `told` hears how far it is, one call at a time.
Result<std::vector<std::size_t>> settleBest(const OpenedStudy& opened, const StudyFlights& flights,
                                            int jobs, const std::function<bool()>& isInterrupted,
                                            const ToldOfRecordings& told);

// The second half of that alone, for rows and recordings of many places that were brought together.
// Gives the points of the best whose recordings are there.
std::vector<std::size_t> removeOvertaken(const OpenedStudy& opened, const StudyFlights& flights);

} // namespace ripstop
