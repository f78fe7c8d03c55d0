// begin() ends what is under way and starts a thread, whose work hands in its outcome as a function
// to be called on the window's thread. A call with an outdated outcome cannot come: the thread is
// joined before another starts, and what it has posted is dropped by its number.
#include "study/study_runner.h"

#include "document/time_left.h"
#include "study/kept_runs.h"
#include "study/many.h"
#include "study/study_search.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace ripstop {
namespace {

constexpr int pause = 100; // ms, between two looks at what has been flown
constexpr std::size_t mostInMemory = 24;
constexpr std::size_t keptMemory = std::size_t(64) << 20; // bytes, of each of them

} // namespace

StudyRunner::StudyRunner(QObject* parent)
    : QObject(parent)
{
    m_tick.setInterval(pause);
    connect(&m_tick, &QTimer::timeout, this, &StudyRunner::collect);
}

StudyRunner::~StudyRunner() { stop(); }

void StudyRunner::stop()
{
    m_stops = true;
    if (m_thread.joinable())
        m_thread.join();
    m_stops = false;
    collect();
    m_tick.stop();
    if (std::exchange(m_task, Task::None) != Task::None)
        emit ended();
}

void StudyRunner::close()
{
    stop();
    m_study = nullptr;
    m_flights.clear();
    m_rows.clear();
    m_otherBuild = {};
    m_kept.clear();
}

template <typename Work>
void StudyRunner::begin(Task task, Work work)
{
    stop();
    m_task = task;
    m_planned = m_done = 0;
    m_flown = 0.0;
    m_bestRecorded = m_newRecorded = {};
    m_progress.plan(0);
    m_clock.start();
    m_tick.start();
    m_thread = std::jthread([this, work, number = ++m_number] {
        const std::function<void()> outcome = work();
        QMetaObject::invokeMethod(
            this,
            [this, number, outcome] {
                if (m_task == Task::None || m_number != number) // it was stopped
                    return;
                m_thread.join();
                collect();
                m_tick.stop();
                m_task = Task::None;
                emit ended();
                outcome();
            },
            Qt::QueuedConnection);
    });
}

void StudyRunner::open(const std::filesystem::path& file)
{
    begin(Task::Opening, [this, file]() -> std::function<void()> {
        struct Found
        {
            std::shared_ptr<OpenedStudy> study;
            LedgerContent content;
            StudyFlights flights;
        };
        const auto fail = [this](const Message& why) { return [this, why] { emit failed(why); }; };
        auto study = openStudy(file);
        if (!study)
            return fail(study.message());
        auto content = readLedgers(ledgerFolder(file));
        if (!content)
            return fail(content.message());
        const auto found = std::make_shared<Found>();
        found->study = std::make_shared<OpenedStudy>(std::move(*study));
        found->content = std::move(*content);
        followSearch(*found->study, found->content.rows);
        found->flights = flightsOf(*found->study, found->content.rows);
        return [this, found] {
            m_study = found->study;
            m_study->plan.progress = &m_progress;
            m_rows = std::move(found->content.rows); // rows stay where they are
            m_otherBuild = found->content.other;
            m_flights = std::move(found->flights);
            emit opened();
        };
    });
}

void StudyRunner::fly(int jobs)
{
    if (!m_study)
        return;
    const auto study = std::make_shared<const OpenedStudy>(*m_study); // its points stay
    begin(Task::Flying, [this, study, jobs]() -> std::function<void()> {
        const auto isStopped = [this] { return m_stops.load(); };
        const auto tell = [this](const FlightNews& news) {
            const std::lock_guard lock(m_mutex);
            m_news.push_back({news.point, news.key, news.flight});
        };
        const auto recorded = [this](std::size_t done, std::size_t wanted) {
            const std::lock_guard lock(m_mutex);
            m_newRecorded = {done, wanted};
        };
        const auto flown = flyMissing(*study, {}, jobs, isStopped, tell, recorded);
        if (!flown)
            return [this, why = flown.message()] { emit failed(why); };
        return [this] {
            m_flights = flightsOf(*m_study, m_rows); // points that are alike were flown once
            emit grew();
        };
    });
}

void StudyRunner::collect()
{
    std::vector<Flown> news;
    Recorded best;
    {
        const std::lock_guard lock(m_mutex);
        news.swap(m_news);
        best = m_newRecorded;
    }
    if (m_task == Task::Flying)
        m_planned = m_progress.planned();
    collectRecordings();
    collectBest(best);
    if (!news.empty())
        collectFlights(std::move(news));
    collectProgress();
}

// A flight that is over is no longer under way a moment before it is in the ledger, which is not to
// be seen.
void StudyRunner::collectProgress()
{
    const std::size_t over = m_bestRecorded.wanted > 0 ? m_bestRecorded.done : m_done;
    const double flown = double(over) + m_progress.underWay();
    if (flown <= m_flown)
        return;
    m_flown = flown;
    emit progressed();
}

void StudyRunner::collectFlights(std::vector<Flown> news)
{
    for (Flown& one : news) {
        const auto [row, isNew] = m_rows.emplace(one.key, std::move(one.flight));
        if (one.point < m_flights.size())
            m_flights[one.point] = &row->second;
    }
    if (m_study->optimiser) { // there are more points than before
        followSearch(*m_study, m_rows);
        m_flights = flightsOf(*m_study, m_rows);
    }
    m_done += news.size();
    emit grew();
}

void StudyRunner::collectBest(Recorded best)
{
    if (m_task != Task::Flying || best == m_bestRecorded)
        return;
    if (m_bestRecorded.wanted == 0) { // of what is left
        m_clock.restart();
        m_flown = 0.0;
    }
    m_bestRecorded = best;
    emit recorded();
}

void StudyRunner::collectRecordings()
{
    std::vector<FlownAgain> news;
    {
        const std::lock_guard lock(m_mutex);
        news.swap(m_newKept);
    }
    if (news.empty())
        return;
    m_done += news.size();
    std::ranges::move(news, std::back_inserter(m_kept));
    if (m_kept.size() > mostInMemory)
        m_kept.erase(m_kept.begin(), m_kept.end() - std::ptrdiff_t(mostInMemory));
    emit recorded();
}

std::shared_ptr<const StudyRunner::Kept> StudyRunner::kept(std::size_t point) const
{
    const auto found = std::ranges::find(m_kept, m_study->key(point), &FlownAgain::key);
    return found == m_kept.end() ? nullptr : found->kept;
}

// In a thread of its own, or read where the study has kept it. Says why there is no recording.
std::optional<Message> StudyRunner::flyAgain(const OpenedStudy& study, std::size_t point,
                                             const std::optional<FlightResult>& row)
{
    auto flown = row ? readKeptRun(study, point, *row) : std::nullopt;
    if (!flown)
        flown = flyRecorded(
            study, point, [this] { return m_stops.load(); }, keptMemory);
    if (!flown)
        return std::nullopt;
    if (!flown->recording)
        return Message("%1", flown->flight.whyEarly());
    const auto kept = std::make_shared<Kept>();
    kept->isSame = !row || row->hash == flown->flight.hash;
    kept->recorded = std::move(*flown);
    const std::lock_guard lock(m_mutex);
    m_newKept.push_back({study.key(point), kept});
    return std::nullopt;
}

std::optional<FlightResult> StudyRunner::rowOf(std::size_t point) const
{
    return m_flights[point] ? std::optional(*m_flights[point]) : std::nullopt;
}

void StudyRunner::watch(std::size_t point)
{
    if (!m_study)
        return;
    if (kept(point)) {
        emit watched(point);
        return;
    }
    const auto study = std::make_shared<const OpenedStudy>(*m_study);
    begin(Task::Watching, [this, study, point, row = rowOf(point)]() -> std::function<void()> {
        if (const auto failure = flyAgain(*study, point, row))
            return [this, why = *failure] { emit failed(why); };
        return [this, point] {
            if (kept(point))
                emit watched(point);
        };
    });
}

void StudyRunner::compare(const std::vector<std::size_t>& points, int jobs)
{
    if (!m_study)
        return;
    const auto study = std::make_shared<const OpenedStudy>(*m_study);
    struct Wanted
    {
        std::size_t point;
        std::optional<FlightResult> row;
    };
    std::vector<Wanted> wanted;
    for (const std::size_t point : points)
        if (!kept(point))
            wanted.push_back({point, rowOf(point)});
    const std::size_t count = wanted.size();
    begin(Task::Comparing, [this, study, points, wanted, jobs]() -> std::function<void()> {
        std::vector<std::optional<Message>> failures(wanted.size());
        forEachOfMany(wanted.size(), jobs, [&](std::size_t i) {
            failures[i] = flyAgain(*study, wanted[i].point, wanted[i].row);
            return !m_stops;
        });
        return [this, points, failures] {
            emit compared(points);
            for (const auto& failure : failures)
                if (failure)
                    return emit failed(*failure);
        };
    });
    m_planned = count;
}

double StudyRunner::secondsLeft() const
{
    const std::size_t wanted = m_bestRecorded.wanted > 0 ? m_bestRecorded.wanted : m_planned;
    return m_task == Task::None || wanted == 0
               ? std::numeric_limits<double>::quiet_NaN()
               : ripstop::secondsLeft(1e-3 * double(m_clock.elapsed()), m_flown / double(wanted));
}

} // namespace ripstop
