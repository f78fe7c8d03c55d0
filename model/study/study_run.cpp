// flyMissing() reads what is known, and each of its threads takes the next point and adds a row
// under a lock as soon as a flight is over; a search goes round again.
#include "study/study_run.h"

#include "base/hash_text.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "recording/recorder.h"
#include "study/frontier_search.h"
#include "study/many.h"
#include "study/probe_names.h"
#include "study/study_search.h"

#include <cmath>
#include <mutex>
#include <set>

namespace ripstop {
namespace {

std::optional<FlightResult> flyWith(const OpenedStudy& opened, std::size_t point,
                                    const std::function<bool()>& isInterrupted,
                                    Recorder* recorder = nullptr, ProbeCurves* curves = nullptr)
{
    const auto scene = sceneOf(opened, point);
    if (!scene) {
        FlightResult none;
        none.measured.assign(opened.plan.measures.size(), std::nan(""));
        none.stopped = scene.message().english();
        return none;
    }
    FlightPlan plan = opened.plan;
    plan.isInterrupted = isInterrupted;
    return fly(*scene, opened.controlsOf(point), plan, recorder, curves);
}

// Also into a file of its own where the study keeps such a flight. A flight that is only kept when
// it fails is flown again for that, which comes to the same.
Result<std::optional<FlightResult>> flyAndKeep(const OpenedStudy& opened, std::size_t point,
                                               const std::function<bool()>& isInterrupted)
{
    const KeptRuns keep = opened.study.keep;
    if (keep != KeptRuns::All) {
        auto flight = flyPoint(opened, point, isInterrupted);
        if (!flight || keep == KeptRuns::Nothing || outcomeOf(&*flight) == FlightOutcome::Held)
            return flight;
    }
    auto flown = flyRecorded(opened, point, isInterrupted);
    if (!flown)
        return std::optional<FlightResult>();
    if (flown->recording)
        if (auto failure = saveRecording(*flown->recording, keptRun(opened, point)))
            return *failure;
    return std::optional(std::move(flown->flight));
}

// Beside the ledgers, once.
std::optional<Failure> keepDesign(const OpenedStudy& opened)
{
    const auto file = keptDesign(ledgerFolder(opened.file), opened.keys.design());
    std::error_code error;
    if (std::filesystem::exists(file, error))
        return std::nullopt;
    return replaceFile(file, sceneText(opened.scene), Flush::Later);
}

} // namespace

std::string Shard::name() const
{
    return "shard-" + std::to_string(place + 1) + "-of-" + std::to_string(count);
}

StudyFlights flightsOf(const OpenedStudy& opened, const LedgerRows& rows)
{
    StudyFlights flights(opened.points.count(), nullptr);
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (const auto row = rows.find(opened.key(i)); row != rows.end())
            flights[i] = &row->second;
    return flights;
}

std::vector<std::size_t> missingPoints(const OpenedStudy& opened, const StudyFlights& flights)
{
    if (opened.study.plan.kind == StudyPlan::Kind::Frontier)
        return frontierPoints(opened.study, [&](std::size_t point) -> std::optional<bool> {
            if (!flights[point])
                return std::nullopt;
            return outcomeOf(flights[point]) == FlightOutcome::Held;
        });
    std::vector<std::size_t> points;
    std::set<std::string> keys;
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (!flights[i] && keys.insert(opened.key(i)).second)
            points.push_back(i);
    return points;
}

std::optional<FlightResult> flyPoint(const OpenedStudy& opened, std::size_t point,
                                     const std::function<bool()>& isInterrupted)
{
    return flyWith(opened, point, isInterrupted);
}

std::optional<RecordedFlight> flyRecorded(const OpenedStudy& opened, std::size_t point,
                                          const std::function<bool()>& isInterrupted,
                                          std::size_t memory)
{
    Recorder recorder(memory);
    RecordedFlight recorded;
    auto flight = flyWith(opened, point, isInterrupted, &recorder, &recorded.curves);
    if (!flight)
        return std::nullopt;
    recorded.flight = std::move(*flight);
    recorded.recording = recorder.recording();
    recorder.finish();
    return recorded;
}

std::filesystem::path keptRun(const OpenedStudy& opened, std::size_t point)
{
    return ledgerFolder(opened.file) / (opened.key(point) + std::string(recordingExtension));
}

std::optional<RecordedFlight> readKeptRun(const OpenedStudy& opened, std::size_t point,
                                          const FlightResult& row)
{
    const std::filesystem::path file = keptRun(opened, point);
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return std::nullopt;
    const auto found = openRecording(file);
    if (!found || found->recording->frameCount() == 0)
        return std::nullopt;
    RecordedFlight kept{row, found->recording, {}};
    const Recording& recording = *kept.recording;
    if (hashText(recording.hashOf(recording.lastStep())) != row.hash)
        return std::nullopt;
    for (std::size_t i = 0; i < recording.frameCount(); ++i) {
        const auto frame = recording.frame(i);
        if (!frame)
            return std::nullopt;
        kept.curves.take({0, (*frame)->layout, (*frame)->time, (*frame)->probe});
        kept.flight.probes = (*frame)->layout->probes;
    }
    const std::vector<std::string> names = distinctNames(kept.flight.probes);
    for (std::size_t i = 0; i < names.size(); ++i)
        kept.flight.probes[i].name = names[i];
    return kept;
}

void StudyTally::add(const FlightResult& flight)
{
    ++flown;
    torn += flight.torn > 0;
    stopped += flight.endedEarly();
    inaccurate += !flight.inaccurate.empty();
}

StudyTally tallyOf(const StudyFlights& flights)
{
    StudyTally tally;
    for (const FlightResult* flight : flights)
        if (flight)
            tally.add(*flight);
    return tally;
}

Result<StudyFlown> flyMissing(const OpenedStudy& study, const Shard& shard, int jobs,
                              const std::function<bool()>& isInterrupted, const ToldOfFlight& told)
{
    StudyFlown flown;
    OpenedStudy opened = study;   // its points may become more
    std::optional<Ledger> ledger; // opened once there is something to write
    for (;;) {
        const auto known = readLedgers(ledgerFolder(opened.file));
        if (!known)
            return known.failure();
        followSearch(opened, known->rows);
        std::vector<std::size_t> points = missingPoints(opened, flightsOf(opened, known->rows));
        const std::size_t all = points.size();
        std::erase_if(points, [&](std::size_t i) { return i % shard.count != shard.place; });
        flown.planned = flown.tally.flown + points.size();
        flown.ofOthers = all - points.size();
        if (points.empty())
            return flown;
        if (!ledger) {
            auto one = Ledger::open(ledgerFolder(opened.file), shard.name(), opened.headings,
                                    opened.keys.design());
            if (!one)
                return one.failure();
            ledger.emplace(std::move(*one));
            if (const auto failure = keepDesign(opened))
                return *failure;
        }
        std::optional<Failure> failure;
        std::mutex mutex;
        forEachOfMany(points.size(), jobs, [&](std::size_t i) {
            const auto kept = flyAndKeep(opened, points[i], isInterrupted);
            const std::string key = opened.key(points[i]);
            const std::lock_guard lock(mutex);
            if (!kept && !failure)
                failure = kept.failure();
            if (failure || !*kept)
                return false;
            const FlightResult* flight = &**kept;
            failure = ledger->add(key, *flight);
            if (failure)
                return false;
            flown.tally.add(*flight);
            told({points[i], key, *flight, flown});
            return true;
        });
        if (failure)
            return *failure;
        if (!opened.study.plan.isSearch() || flown.tally.flown < flown.planned)
            return flown;
    }
}

} // namespace ripstop
