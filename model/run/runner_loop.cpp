// One turn of the loop in order: what was asked for, the state that follows, a step or a sleep.
#include "run/runner_loop.h"

#include "run/runner_mail.h"

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

using namespace std::chrono_literals;

constexpr auto betweenFrames = 15ms; // views take one every 16; more would only cost time
constexpr auto worthAFrame = 2ms;    // before the next step is due

// What depends on the clock is nowhere but in what somebody watches.
//   probe  [probes], or empty
void readClock(std::vector<double>& probe, double realTimeRatio, const System& system)
{
    for (std::size_t i = 0; i < probe.size(); ++i)
        if (system.probes[i].quantity == Quantity::StepsPerSecond)
            probe[i] = realTimeRatio / system.timeStep;
}

} // namespace

void RunnerLoop::run(const std::stop_token& stop)
{
    while (!stop.stop_requested()) {
        const Asked before = asked();
        takeUpdates();
        takeCommands();
        takeGoal();
        const Asked orders = takeOrders(before);
        const Reasons reasons = reasonsFor(orders);
        const Doing doing = doingFor(reasons);
        if (doing == Doing::Hurried || (doing == Doing::Paced && reasons.isDue))
            advance(orders, reasons);
        else
            rest(doing, stop);
    }
}

RunnerLoop::Asked RunnerLoop::asked() const
{
    return {m_mail.playing, m_mail.stepsLeft, m_mail.until};
}

void RunnerLoop::takeUpdates()
{
    std::vector<Update> updates = m_mail.takeUpdates();
    if (updates.empty())
        return;
    const Design design = updates.back().design;
    if (!m_simulation)
        m_simulation.emplace(updates.front().system, Simulation::mostThreads());
    // however fast a slider is pulled, it is one edit between two steps
    m_simulation->load(std::move(updates));
    m_recorder.loaded(*m_simulation, design);
    if (m_settler && m_settler->run() != m_simulation->system().run)
        m_settler.emplace(m_settler->goal(), *m_simulation);
    m_timetable.restart();
    show();
}

void RunnerLoop::takeCommands()
{
    if (!m_simulation)
        return;
    if (const auto commands = m_mail.commands.take())
        m_simulation->command(*commands);
    if (const auto hands = m_mail.hands.take()) {
        m_simulation->handle(*hands);
        m_isFresh = true; // what is held or cut is seen in a pause, too
    }
}

void RunnerLoop::takeGoal()
{
    const auto goal = m_simulation ? m_mail.settle.take() : nullptr;
    if (!goal)
        return;
    m_settler.reset();
    if (*goal)
        m_settler.emplace(**goal, *m_simulation);
    m_isFresh = true;
}

// What was asked for before the updates were taken, and still is after it, is asked for in the
// scene that they make: who loads and then plays is not shown a step of the old one.
RunnerLoop::Asked RunnerLoop::takeOrders(const Asked& before)
{
    m_timetable.setPlaying(before.playing && m_mail.playing);
    if (m_simulation && m_simulation->trouble())
        m_mail.stepsLeft = 0; // steps that cannot be made are not made up for
    return {m_timetable.isPlaying(), std::min(before.steps, m_mail.stepsLeft.load()),
            std::min(before.until, m_mail.until.load())};
}

RunnerLoop::Reasons RunnerLoop::reasonsFor(const Asked& orders) const
{
    const bool hasTime =
        m_simulation
        && !hasReached(m_simulation->state().time, orders.until, m_simulation->system().timeStep);
    return {m_settler && !m_settler->isOver(), hasTime, orders.steps > 0, m_timetable.isDue()};
}

RunnerLoop::Doing RunnerLoop::doingFor(const Reasons& reasons) const
{
    if (!m_simulation)
        return Doing::Empty;
    if (m_simulation->trouble())
        return Doing::Stuck;
    if (reasons.settles || reasons.hasTime || reasons.hasSteps)
        return Doing::Hurried;
    return m_timetable.isPlaying() ? Doing::Paced : Doing::Resting;
}

// One step, and a frame of it where one would be seen.
void RunnerLoop::advance(const Asked& orders, const Reasons& reasons)
{
    m_recorder.setMemory(m_mail.recordingMemory);
    if (m_recorder.beforeStep(*m_simulation))
        m_mail.putRecording(m_recorder.recording());
    m_isFresh = m_simulation->step();
    if (m_isFresh)
        m_recorder.afterStep(*m_simulation);
    if (reasons.settles && m_isFresh)
        m_settler->look(*m_simulation);
    tickOff(orders, reasons);
    const bool hasSettled = reasons.settles && m_settler->isOver();
    if (reasons.hasSteps || hasSettled || m_simulation->trouble()
        || RunnerClock::now() - m_framed > betweenFrames)
        show();
    else
        sample();
}

// Of what was asked for, what the step has done.
void RunnerLoop::tickOff(const Asked& orders, const Reasons& reasons)
{
    const double timeStep = m_simulation->system().timeStep;
    double until = orders.until;
    // unless another time has been asked for meanwhile
    if (reasons.hasTime && hasReached(m_simulation->state().time, until, timeStep))
        m_mail.until.compare_exchange_strong(until, noTime);
    int steps = orders.steps;
    while (reasons.hasSteps && steps > 0 // unless they have been cancelled meanwhile
           && !m_mail.stepsLeft.compare_exchange_weak(steps, steps - 1)) {
    }
    if (reasons.isDue)
        m_timetable.stepped(timeStep, m_mail.speed);
}

void RunnerLoop::rest(Doing doing, const std::stop_token& stop)
{
    if (m_isFresh && (!m_timetable.isPlaying() || m_timetable.left() > worthAFrame))
        show();
    m_mail.sleep(stop, doing == Doing::Paced ? m_timetable.left() : RunnerClock::duration(1s));
}

void RunnerLoop::show()
{
    auto frame = m_simulation->frame();
    if (m_settler)
        frame->settling = m_settler->progress();
    frame->realTimeRatio = m_pace.update(frame->time);
    for (std::vector<double>* const probe : {&frame->probe, &frame->highest})
        readClock(*probe, frame->realTimeRatio, m_simulation->system());
    if (!frame->probe.empty()) // a frame may go unseen, what the probes read may not
        m_mail.putSample({frame->run, frame->layout, frame->time, frame->probe, frame->highest});
    m_mail.frames.put(std::move(frame));
    m_framed = RunnerClock::now();
    m_isFresh = false;
}

void RunnerLoop::sample()
{
    if (m_simulation->system().probes.empty())
        return;
    ProbeSample read = m_simulation->sample();
    const double ratio = m_pace.update(read.time);
    for (std::vector<double>* const probe : {&read.probe, &read.highest})
        readClock(*probe, ratio, m_simulation->system());
    m_mail.putSample(std::move(read));
}

} // namespace ripstop
