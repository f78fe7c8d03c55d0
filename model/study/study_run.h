// Flying a study: which of its points no ledger has yet, and flying those, many at a time.
//
// Any number of processes may fly shares of one study, and may be ended at any moment: a flight is
// in the ledger as soon as it is over (ledger.h). A point that diverges or cannot be set is a row
// that says so, and never the end.
#pragma once

#include "study/opened_study.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ripstop {

class Recording; // recording/recording.h

struct Shard // the points i with i % count == place
{
    std::size_t place = 0;
    std::size_t count = 1;

    std::string name() const; // of its file, without the ending
};

// The points of the shard that have no row; of points that are alike the first.
std::vector<std::size_t> missingPoints(const OpenedStudy& opened, const LedgerRows& rows,
                                       const Shard& shard = {});

// Nothing when it was interrupted.
std::optional<FlightResult> flyPoint(const OpenedStudy& opened, std::size_t point,
                                     const std::function<bool()>& isInterrupted);

// The same flight with all of its frames.
struct RecordedFlight
{
    FlightResult flight;
    std::shared_ptr<Recording> recording; // null where nothing could be flown
};
std::optional<RecordedFlight> flyRecorded(const OpenedStudy& opened, std::size_t point,
                                          const std::function<bool()>& isInterrupted);

struct StudyTally
{
    std::size_t flown = 0;
    std::size_t torn = 0;    // of those, in which something tore
    std::size_t stopped = 0; // of those, that diverged or ended in what cannot be

    void add(const FlightResult& flight);
};

// `told` hears of each flight once it is in the ledger, from the thread that flew it, one at a
// time. Fewer are flown than there are points when it was interrupted. Fails when the ledger cannot
// be written.
Result<StudyTally> flyPoints(
    const OpenedStudy& opened, const std::vector<std::size_t>& points, const Shard& shard, int jobs,
    const std::function<bool()>& isInterrupted,
    const std::function<void(std::size_t point, const FlightResult&, const StudyTally&)>& told);

} // namespace ripstop
