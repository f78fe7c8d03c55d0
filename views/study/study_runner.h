// Opens and flies a study in the background while the window goes on.
//
// One thing at a time: opening, flying what is missing, or flying points again with all of their
// frames, of which the last are kept. A new call ends what is under way; rows that are in the
// ledger stay. Belongs to the window's thread, as its signals do.
#pragma once

#include "study/study_map.h"
#include "study/study_run.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>

namespace ripstop {

class Recording;

class StudyRunner final : public QObject
{
    Q_OBJECT

public:
    explicit StudyRunner(QObject* parent = nullptr);
    ~StudyRunner() override;

    enum class Task { None, Opening, Flying, Watching, Comparing };
    Task task() const { return m_task; }

    void open(const std::filesystem::path& file); // then opened() or failed()
    void fly(int jobs);                           // what is missing of the open one
    void watch(std::size_t point);                // then watched() or failed()
    // Flies those again whose recordings are not kept; then compared().
    void compare(const std::vector<std::size_t>& points, int jobs);
    void stop(); // and wait for what is under way to end
    void close();

    const OpenedStudy* study() const { return m_study.get(); }    // null: none is open
    const StudyFlights& flights() const { return m_flights; }     // of its points
    const OtherBuild& otherBuild() const { return m_otherBuild; } // whose rows were there
    StudyTally tally() const { return tallyOf(m_flights); }

    // A flight that was flown again.
    struct Kept
    {
        RecordedFlight recorded;
        bool isSame = true; // the last state has the hash that its row has
    };
    std::shared_ptr<const Kept> kept(std::size_t point) const; // null: it is not
    std::size_t planned() const { return m_planned; }          // flights of the task, and
    std::size_t done() const { return m_done; }                // how many of them are over
    // Those that are over and the shares of those under way; of the best ones alone while these are
    // flown again. It never becomes less.
    double flown() const { return m_flown; }
    // While flying: of the best flights, which are flown again for their recordings once all others
    // are over. None are wanted before that.
    struct Recorded
    {
        std::size_t done = 0;
        std::size_t wanted = 0;

        bool operator==(const Recorded&) const = default;
    };
    Recorded bestRecorded() const { return m_bestRecorded; }
    double secondsLeft() const; // of what flies, as far as can be told; else not a number

signals:
    void opened();
    void grew();  // there are more flights
    void ended(); // of what was under way, whatever came of it
    void failed(const ripstop::Message& why);
    void watched(std::size_t point); // kept() has it
    void recorded();                 // one more of those that are compared, or of the best
    void progressed();               // flown() is more
    void compared(const std::vector<std::size_t>& points);

private:
    struct Flown
    {
        std::size_t point;
        std::string key;
        FlightResult flight;
    };

    struct FlownAgain
    {
        std::string key;
        std::shared_ptr<const Kept> kept;
    };

    template <typename Work>
    void begin(Task task, Work work);
    std::optional<Message> flyAgain(const OpenedStudy& study, std::size_t point,
                                    const std::optional<FlightResult>& row);
    std::optional<FlightResult> rowOf(std::size_t point) const;
    void collect();
    void collectRecordings();
    void collectBest(Recorded best);
    void collectFlights(std::vector<Flown> news);
    void collectProgress();

    std::shared_ptr<OpenedStudy> m_study; // the points of an optimisation become more
    LedgerRows m_rows;
    OtherBuild m_otherBuild;
    StudyFlights m_flights;
    Task m_task = Task::None;
    int m_number = 0;          // of what was begun last
    std::size_t m_planned = 0; // since the flying began, as far as it is known
    std::size_t m_done = 0;    // of those
    double m_flown = 0.0;      // with those under way
    Recorded m_bestRecorded;
    QElapsedTimer m_clock;          // since it began
    QTimer m_tick;                  // while something is under way
    std::vector<FlownAgain> m_kept; // the newest last
    std::atomic<bool> m_stops = false;
    std::mutex m_mutex;
    std::vector<Flown> m_news; // of the threads that fly
    std::vector<FlownAgain> m_newKept;
    Recorded m_newRecorded;
    StudyProgress m_progress; // of those threads
    std::jthread m_thread;    // last: it ends before what it uses
};

} // namespace ripstop
