// Opens and flies a study in the background while the window goes on.
//
// One thing at a time: opening, flying what is missing, or flying one point again with all of its
// frames. A new call ends what is under way; rows that are in the ledger stay. Belongs to the
// window's thread, as its signals do.
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

    enum class Task { None, Opening, Flying, Watching };
    Task task() const { return m_task; }

    void open(const std::filesystem::path& file); // then opened() or failed()
    void fly(int jobs);                           // what is missing of the open one
    void watch(std::size_t point);                // then watched() or failed()
    void stop();                                  // and wait for what is under way to end
    void close();

    const OpenedStudy* study() const { return m_study.get(); } // null: none is open
    const StudyFlights& flights() const { return m_flights; }  // of its points
    StudyTally tally() const { return tallyOf(m_flights); }
    double secondsLeft() const; // while flying, as far as can be told; else not a number

signals:
    void opened();
    void grew();  // there are more flights
    void ended(); // of what was under way, whatever came of it
    void failed(const ripstop::Message& why);
    // `isSame`: the last state has the hash that its row has.
    void watched(const std::shared_ptr<ripstop::Recording>& recording, std::size_t point,
                 bool isSame);

private:
    struct Flown
    {
        std::size_t point;
        std::string key;
        FlightResult flight;
    };

    template <typename Work>
    void begin(Task task, Work work);
    void collect();

    std::shared_ptr<OpenedStudy> m_study; // the points of an optimisation become more
    LedgerRows m_rows;
    StudyFlights m_flights;
    Task m_task = Task::None;
    int m_number = 0;          // of what was begun last
    std::size_t m_planned = 0; // since the flying began, as far as it is known
    std::size_t m_done = 0;    // of those
    QElapsedTimer m_clock;     // since it began
    QTimer m_tick;             // while flying
    std::atomic<bool> m_stops = false;
    std::mutex m_mutex;
    std::vector<Flown> m_news; // of the threads that fly
    std::size_t m_newPlan = 0; // and how many they are to fly
    std::jthread m_thread;     // last: it ends before what it uses
};

} // namespace ripstop
