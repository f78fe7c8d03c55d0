// flyMissing() reads what is known, and each of its threads takes the next point and adds a row
// under a lock as soon as a flight is over; a search goes round again, and so does a study that
// keeps the best, which are told from all rows.
#include "study/study_run.h"

#include "io/recording_file.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "recording/recorder.h"
#include "study/frontier_search.h"
#include "study/kept_runs.h"
#include "study/many.h"
#include "study/study_search.h"

#include <algorithm>
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
        if (!flight || keep != KeptRuns::Failed || outcomeOf(&*flight) == FlightOutcome::Held)
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

// Which points fly the same as one before them. Of grids that is told by their values, of all
// others by a list of keys, which draws from a range do without: no two of them are the same.
class RepeatedPoints
{
public:
    explicit RepeatedPoints(const OpenedStudy& opened)
        : m_opened(opened)
        , m_isGrid(opened.study.plan.kind == StudyPlan::Kind::Grid)
    {
        const StudyPlan& plan = opened.study.plan;
        const auto& variables = opened.study.variables;
        const bool hasRange = std::ranges::any_of(variables, [](const auto& variable) {
            return variable.spread
                   && quantile(*variable.spread, 0.25) != quantile(*variable.spread, 0.75);
        });
        // what belongs together in a plan of sensitivity differs in one variable alone
        m_isDistinct = plan.draws() && plan.kind != StudyPlan::Kind::Sensitivity && hasRange;
        if (m_isGrid)
            for (const StudyVariable& variable : variables)
                m_isAgain.push_back(valuesAgain(opened, variable));
    }

    // Asked in order.
    bool has(std::size_t point)
    {
        if (m_isDistinct)
            return false;
        if (!m_isGrid)
            return !m_keys.insert(m_opened.key(point)).second;
        for (std::size_t v = m_isAgain.size(); v-- > 0;) { // as gridPoint() has it
            if (m_isAgain[v][point % m_isAgain[v].size()])
                return true;
            point /= m_isAgain[v].size();
        }
        return false;
    }

private:
    // Whether each value of a variable stands before it already.
    static std::vector<bool> valuesAgain(const OpenedStudy& opened, const StudyVariable& variable)
    {
        std::vector<bool> again;
        std::set<std::string> before;
        for (const std::string& value : variable.values) {
            const auto track = opened.tracks.find(value);
            const bool isTrack = track != opened.tracks.end();
            again.push_back(!before.insert(isTrack ? track->second.hash : value).second);
        }
        return again;
    }

    const OpenedStudy& m_opened;
    bool m_isGrid;
    bool m_isDistinct;
    std::vector<std::vector<bool>> m_isAgain; // [variables][values] of a grid
    std::set<std::string> m_keys;
};

// Takes the points of other shards away, and says how many those were.
std::size_t leaveToOthers(PointSet& points, const Shard& shard)
{
    std::size_t ofOthers = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i] && i % shard.count != shard.place) {
            points[i] = false;
            ++ofOthers;
        }
    return ofOthers;
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

// Flies these points, and adds each to the ledger and to what was flown.
std::optional<Failure> flyRound(const OpenedStudy& opened, const PointSet& points,
                                std::size_t count, Ledger& ledger, int jobs,
                                const std::function<bool()>& isInterrupted,
                                const ToldOfFlight& told, StudyFlown& flown)
{
    std::optional<Failure> failure;
    std::mutex mutex;
    std::size_t next = 0;
    const auto takeNext = [&] {
        const std::lock_guard lock(mutex);
        while (!points[next])
            ++next;
        return next++;
    };
    forEachOfMany(count, jobs, [&](std::size_t) {
        const std::size_t point = takeNext();
        const auto kept = flyAndKeep(opened, point, isInterrupted);
        const std::string key = opened.key(point);
        const std::lock_guard lock(mutex);
        if (!kept && !failure)
            failure = kept.failure();
        if (failure || !*kept)
            return false;
        const FlightResult* flight = &**kept;
        failure = ledger.add(key, *flight);
        if (failure)
            return false;
        flown.tally.add(*flight);
        told({point, key, *flight, flown});
        return true;
    });
    return failure;
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

PointSet missingPoints(const OpenedStudy& opened, const FlightLookup& flightOf)
{
    PointSet missing(opened.points.count(), false);
    if (opened.study.plan.kind == StudyPlan::Kind::Frontier) {
        const auto held = [&](std::size_t point) -> std::optional<bool> {
            const FlightResult* flight = flightOf(point);
            if (!flight)
                return std::nullopt;
            return outcomeOf(flight) == FlightOutcome::Held;
        };
        for (const std::size_t point : frontierPoints(opened.study, held))
            missing[point] = true;
        return missing;
    }
    RepeatedPoints repeated(opened);
    for (std::size_t i = 0; i < missing.size(); ++i)
        missing[i] = !flightOf(i) && !repeated.has(i);
    return missing;
}

PointSet missingPoints(const OpenedStudy& opened, const StudyFlights& flights)
{
    return missingPoints(opened, [&](std::size_t point) { return flights[point]; });
}

std::size_t countOf(const PointSet& points)
{
    return std::size_t(std::ranges::count(points, true));
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
                              const std::function<bool()>& isInterrupted, const ToldOfFlight& told,
                              const ToldOfRecordings& recorded)
{
    StudyFlown flown;
    OpenedStudy opened = study;   // its points may become more
    std::optional<Ledger> ledger; // opened once there is something to write
    const bool goesRound = opened.study.plan.isSearch();
    for (;;) {
        const auto known = readLedgers(ledgerFolder(opened.file));
        if (!known)
            return known.failure();
        followSearch(opened, known->rows);
        PointSet points = missingPoints(opened, [&](std::size_t point) {
            const auto row = known->rows.find(opened.key(point));
            return row == known->rows.end() ? nullptr : &row->second;
        });
        flown.ofOthers = leaveToOthers(points, shard);
        const std::size_t count = countOf(points);
        flown.planned = flown.tally.flown + count;
        if (opened.plan.progress)
            opened.plan.progress->plan(flown.planned);
        if (count == 0) {
            if (opened.study.keep != KeptRuns::Best)
                return flown;
            auto best =
                settleBest(opened, flightsOf(opened, known->rows), jobs, isInterrupted, recorded);
            if (!best)
                return best.failure();
            flown.best = std::move(*best);
            return flown;
        }
        if (!ledger) {
            auto one = Ledger::open(ledgerFolder(opened.file), shard.name(), opened.headings,
                                    opened.keys.design());
            if (!one)
                return one.failure();
            ledger.emplace(std::move(*one));
            if (const auto failure = keepDesign(opened))
                return *failure;
        }
        if (const auto failure =
                flyRound(opened, points, count, *ledger, jobs, isInterrupted, told, flown))
            return *failure;
        // a hundred thousand rows are not read again for nothing
        const bool looksAgain = goesRound || opened.study.keep == KeptRuns::Best;
        if (!looksAgain || flown.tally.flown < flown.planned)
            return flown;
    }
}

} // namespace ripstop
