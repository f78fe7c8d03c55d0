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

// What is known of each point; null where it is not flown. They point to rows of the ledgers.
using StudyFlights = std::vector<const FlightResult*>; // [points]
StudyFlights flightsOf(const OpenedStudy& opened, const LedgerRows& rows);

// Whether each point has to be flown next: those that are not, or of a plan along the frontier
// those of them that are needed as far as can be told now. Of points that are alike the first,
// except of draws from ranges, which are alike by a rare chance and to no harm. A bit for each, as
// there may be a hundred million.
using PointSet = std::vector<bool>;                                         // [points]
using FlightLookup = std::function<const FlightResult*(std::size_t point)>; // null: not flown
PointSet missingPoints(const OpenedStudy& opened, const FlightLookup& flightOf);
PointSet missingPoints(const OpenedStudy& opened, const StudyFlights& flights);
std::size_t countOf(const PointSet& points);

// Nothing when it was interrupted.
std::optional<FlightResult> flyPoint(const OpenedStudy& opened, std::size_t point,
                                     const std::function<bool()>& isInterrupted);

// The same flight with all of its frames.
struct RecordedFlight
{
    FlightResult flight;
    std::shared_ptr<Recording> recording; // null where nothing could be flown
    ProbeCurves curves;
};
//   memory  bytes that the recording may hold before it goes to a temporary file
std::optional<RecordedFlight> flyRecorded(const OpenedStudy& opened, std::size_t point,
                                          const std::function<bool()>& isInterrupted,
                                          std::size_t memory = std::size_t(512) << 20);

struct StudyTally
{
    std::size_t flown = 0;
    std::size_t torn = 0;       // of those, in which something tore
    std::size_t stopped = 0;    // of those, that diverged or ended in what cannot be
    std::size_t inaccurate = 0; // of those, that missed the wanted accuracy

    void add(const FlightResult& flight);
};
StudyTally tallyOf(const StudyFlights& flights);

// What has become of flying a study.
struct StudyFlown
{
    StudyTally tally;         // of what this call flew
    std::size_t planned = 0;  // of its shard, as far as it is known; more than were flown when it
                              // was interrupted
    std::size_t ofOthers = 0; // points that other shards have to fly before it can go on
    std::optional<std::vector<std::size_t>> best; // of a study that keeps the best: those that are
                                                  // kept, the best first (kept_runs.h)
};

// A flight of it that is over, and in the ledger.
struct FlightNews
{
    std::size_t point;
    const std::string& key; // of its row
    const FlightResult& flight;
    const StudyFlown& flown; // with this one
};
using ToldOfFlight = std::function<void(const FlightNews&)>;

// How many of the best flights have their recordings, of those that had none.
using ToldOfRecordings = std::function<void(std::size_t done, std::size_t wanted)>;

// Flies what is missing of the shard, round after round where a plan finds out what it needs, and
// then those of the best again whose recordings the study keeps and does not have.
// `told` hears of each flight once it is in the ledger, `recorded` before the first of the best and
// after each; from the thread that flew it, one at a time. `isInterrupted` is asked by any of these
// threads at any time, between two steps. The progress of the plan (opened.plan.progress), where
// there is one, hears how many flights it will be and how far those are that are under way. Fails
// when a ledger cannot be read or written.
Result<StudyFlown> flyMissing(
    const OpenedStudy& opened, const Shard& shard, int jobs,
    const std::function<bool()>& isInterrupted, const ToldOfFlight& told,
    const ToldOfRecordings& recorded = [](std::size_t, std::size_t) {});

} // namespace ripstop
