// flyPoints() takes the next point in each of its threads, and adds a row under a lock as soon as one
// is over.
#include "study/study_run.h"

#include "recording/recorder.h"
#include "study/many.h"

#include <cmath>
#include <mutex>
#include <set>

namespace ripstop {
namespace {

std::optional<FlightResult> flyWith(const OpenedStudy& opened, std::size_t point,
                                    const std::function<bool()>& isInterrupted, Recorder* recorder)
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
    return fly(*scene, opened.controls, plan, recorder);
}

} // namespace

std::string Shard::name() const
{
    return "shard-" + std::to_string(place + 1) + "-of-" + std::to_string(count);
}

std::vector<std::size_t> missingPoints(const OpenedStudy& opened, const LedgerRows& rows,
                                       const Shard& shard)
{
    std::vector<std::size_t> points;
    std::set<std::string> keys;
    for (std::size_t i = shard.place; i < opened.points.count(); i += shard.count) {
        std::string key = opened.key(i);
        if (!rows.contains(key) && keys.insert(std::move(key)).second)
            points.push_back(i);
    }
    return points;
}

std::optional<FlightResult> flyPoint(const OpenedStudy& opened, std::size_t point,
                                     const std::function<bool()>& isInterrupted)
{
    return flyWith(opened, point, isInterrupted, nullptr);
}

std::optional<RecordedFlight> flyRecorded(const OpenedStudy& opened, std::size_t point,
                                          const std::function<bool()>& isInterrupted)
{
    Recorder recorder;
    auto flight = flyWith(opened, point, isInterrupted, &recorder);
    if (!flight)
        return std::nullopt;
    RecordedFlight recorded{std::move(*flight), recorder.recording()};
    recorder.finish();
    return recorded;
}

void StudyTally::add(const FlightResult& flight)
{
    ++flown;
    torn += flight.torn > 0;
    stopped += flight.endedEarly();
}

Result<StudyTally> flyPoints(
    const OpenedStudy& opened, const std::vector<std::size_t>& points, const Shard& shard, int jobs,
    const std::function<bool()>& isInterrupted,
    const std::function<void(std::size_t point, const FlightResult&, const StudyTally&)>& told)
{
    auto ledger = Ledger::open(ledgerFolder(opened.file), shard.name(), opened.headings);
    if (!ledger)
        return ledger.failure();
    std::optional<Failure> failure;
    std::mutex mutex;
    StudyTally tally;
    forEachOfMany(points.size(), jobs, [&](std::size_t i) {
        const auto flight = flyPoint(opened, points[i], isInterrupted);
        const std::string key = opened.key(points[i]);
        const std::lock_guard lock(mutex);
        if (!flight || failure)
            return false;
        failure = ledger->add(key, *flight);
        if (failure)
            return false;
        tally.add(*flight);
        told(points[i], *flight, tally);
        return true;
    });
    if (failure)
        return *failure;
    return tally;
}

} // namespace ripstop
