// What the thread of a runner does: takes what was asked for between two steps, makes the steps
// that are due, and shows them.
//
// Each turn of the loop begins at a step boundary. It takes updates, commands and goals, finds the
// state that follows from them (runner.h has the table), and then makes one step or sleeps:
//
//     Empty --update--> Resting <--play, pause--> Paced
//                         ^  |                    ^  |
//               reached   |  +--time, steps, rest--- v
//                         +------------------- Hurried
//     any but Empty --a step that would be broken--> Stuck --update--> as asked
//
// All of it runs on one thread, that of the runner; RunnerMail is where it meets the others.
#pragma once

#include "recording/recorder.h"
#include "run/runner_clock.h"
#include "run/settle.h"
#include "simulation/simulation.h"

#include <optional>
#include <stop_token>

namespace ripstop {

struct RunnerMail;

class RunnerLoop
{
public:
    explicit RunnerLoop(RunnerMail& mail)
        : m_mail(mail)
    {}

    void run(const std::stop_token& stop);

private:
    enum class Doing { Empty, Resting, Paced, Hurried, Stuck };

    // What the window has asked for that the clock, a time or a count ends.
    struct Asked
    {
        bool playing;
        int steps;
        double until; // s
    };
    // What of it asks for a step now; several may at once.
    struct Reasons
    {
        bool settles;
        bool hasTime;  // there is a time to play to
        bool hasSteps; // that were asked for
        bool isDue;    // by the clock
    };

    Asked asked() const;
    void takeUpdates();
    void takeCommands();
    void takeGoal();
    Asked takeOrders(const Asked& before);
    Reasons reasonsFor(const Asked& orders) const;
    Doing doingFor(const Reasons& reasons) const;
    void advance(const Asked& orders, const Reasons& reasons);
    void tickOff(const Asked& orders, const Reasons& reasons);
    void rest(Doing doing, const std::stop_token& stop);
    void show();
    void sample();

    RunnerMail& m_mail;
    std::optional<Simulation> m_simulation; // once there is a system
    std::optional<Settler> m_settler;       // while there is a goal
    Recorder m_recorder;
    Timetable m_timetable;
    Pace m_pace;
    RunnerClock::time_point m_framed;
    bool m_isFresh = false; // there is something that no frame has shown
};

} // namespace ripstop
