// The Qt face of the runner: has each change of the document compiled off the window's thread,
// hands what that comes to to the runner, and brings back the newest frame once per displayed one.
// All of it is called from the window's thread, and none of it waits for the others.
//
// It is in one state of each of four kinds, which change independently:
//
//     what it does      Paused --play()--> Playing          by the clock
//                              --playUntil()--> Racing      as fast as it can, to a time
//                              --settle()--> Settling       as fast as it can, until all is still
//                       all of them --halt()--> Paused: pause(), the time, rest, trouble, a problem
//     the run           AtDesign --leaveDesign()--> UnderWay    orders, a cut or a pin, a moment
//                       UnderWay --takeFrame()--> Stuck         the next step would be broken
//                       Stuck    --takeFrame()--> UnderWay      an edit has cured it
//                       all of them --startOver()--> AtDesign
//     the compile       Done --compileSoon()--> Due --post()--> UnderWay --takeCompiled()--> Done
//                       UnderWay --compileSoon()--> Due         edited again meanwhile
//     what is shown     the run --lookAt()--> an instant of a recording --goBack()--> the run
//
// What is asked for while a compile is due or under way becomes Orders, which the runner gets as
// soon as it has that system: giveOrders().
#pragma once

#include "document/follower.h"
#include "run/runner.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <optional>

namespace ripstop {

class Document;

class Player final : public QObject
{
    Q_OBJECT

public:
    explicit Player(Document& document, QObject* parent = nullptr);

    Follower& follower() { return m_follower; }

    bool isPlaying() const { return m_activity != Activity::Paused; }
    double speed() const { return m_speed; }
    // What is shown: the newest instant, or one that is looked back at. Null before the first.
    const std::shared_ptr<const Frame>& frame() const { return m_past ? m_past : m_frame; }
    const std::shared_ptr<const Frame>& newest() const { return m_frame; }

    // Why there is nothing to play ("particle 3 is free and has no mass ..."), or empty.
    QString problem() const;

    bool isCurrent() const; // the newest frame is one of the design as it is now
    std::uint64_t run() const { return m_run; } // that goes on, or is about to begin

    // What these ask for happens in the scene as it is now: they wait for a compile under way.
    void play();
    void pause();
    void toggle();
    void step();                 // one time step; pauses
    void reset();                // back to the design; controls return to zero
    void playUntil(double time); // s; as fast as it can, then pauses exactly there

    // Shows an instant of a recording instead of the run, which pauses; null goes back to the run.
    // Whatever makes the run go on goes back to it, too.
    void lookAt(std::shared_ptr<const Frame> past);
    bool isLookingBack() const { return m_past != nullptr; }

    // A new run of the design as it is now, paused, from a moment of another run.
    void continueFrom(std::shared_ptr<const Moment> moment);

    // Bytes that each run from now on may keep of itself in memory; 0 keeps nothing.
    void setRecordingMemory(std::size_t bytes) { m_runner.setRecordingMemory(bytes); }

    // Simulated seconds per second of the clock; 0 is as fast as it can.
    void setSpeed(double ratio);

    // The command of a control, m, is where it is told to go, within its limit; nudge() moves it by
    // whole steps.
    double commandOf(Id control) const;
    void steer(Id control, double command);
    void nudge(Id control, int steps);

    // What hands have been told since the run began, and what to tell them next.
    const HandCommands& hands() const { return m_hands; }
    void handle(const HandNote::What& what);

    // Runs on, as fast as it can, until all is still or the goal's time is over; then pauses.
    void settle(SettleGoal goal);
    bool isSettling() const { return m_activity == Activity::Settling; }

signals:
    // Samples of the present run; each is emitted before the frame that comes after it.
    void sampled(const ripstop::ProbeSample& sample);
    void frameReady(const std::shared_ptr<const ripstop::Frame>& frame);
    void stateChanged();                               // playing, speed or problem
    void stopped(const QString& why, quint32 culprit); // the simulation cannot go on
    void settled(const ripstop::Settling& end);        // by itself, not by a pause
    void recordingBegan(const std::shared_ptr<ripstop::Recording>& recording); // of a run

private:
    enum class Activity { Paused, Playing, Racing, Settling };
    enum class Run { AtDesign, UnderWay, Stuck }; // under way as soon as it is about to be
    enum class Compile { Due, UnderWay, Done };   // of the document as it is now

    // What the runner is told as soon as it has the system of `generation`.
    struct Orders
    {
        std::uint64_t generation = 0;
        bool play = false;
        int steps = 0;
        std::optional<double> until = std::nullopt; // s
        std::optional<SettleGoal> settle = std::nullopt;
    };

    // --- transitions ---
    void begin(Activity activity, const Orders& orders);
    void halt();
    void leaveDesign(); // unless it has left
    void startOver();   // a new run, paused, from the design as it is now
    void compileSoon();
    void post(); // what is due, to the follower
    void takeCompiled(const Compiled& outcome);
    void takeFrame();
    void goBack(); // to the run, if it is not shown

    void changed(const Edit& applied);
    void passSamples(const Frame& frame);
    void order(Orders orders);
    void giveOrders();
    bool refuse();           // says why nothing can be played, if so
    bool hasArrived() const; // where playUntil() wanted
    bool hasSettled() const; // as the newest frame says
    bool stands() const;     // the newest frame is of the newest compile

    Document& m_document;
    Runner m_runner;
    Follower m_follower;
    std::shared_ptr<const Frame> m_frame;   // the newest
    std::shared_ptr<const Frame> m_past;    // that is looked at
    std::vector<ProbeSample> m_samples;     // not passed on yet
    std::shared_ptr<const Moment> m_moment; // that the next system begins with
    Commands m_commands;
    HandCommands m_hands;
    std::optional<Orders> m_orders; // not yet given
    std::optional<double> m_until;  // s, where playUntil() will pause
    QTimer m_poll;
    Message m_problem;     // in words when it is asked for, as the language may change
    quint32 m_culprit = 0; // of m_problem
    double m_speed = 1.0;
    std::uint64_t m_generation = 0; // of the newest compile asked for
    std::uint64_t m_compiled = 0;   // of the newest compile that came back
    std::uint64_t m_run = 1;
    Activity m_activity = Activity::Paused;
    Run m_runState = Run::AtDesign;
    Compile m_compile = Compile::Done;
    int m_goals = 0; // so far, to tell frames of one from those of the next
};

} // namespace ripstop
