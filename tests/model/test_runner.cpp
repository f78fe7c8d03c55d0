// The runner's thread: pacing, mailboxes, edits and resets while it plays.
//
// Stages: the mailbox; standing, stepping and playing until a time; edits while it plays and
// frames that are whole; pace and pauses; commands, trouble, and a prompt stop.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "measure/diagnostics.h"
#include "run/latest_value.h"
#include "run/runner.h"
#include "run/runner_mail.h"
#include "simulation/simulation.h"
#include "system/moment.h"

#include <QtTest>

#include <cstring>
#include <thread>

namespace ripstop::test_runner {

using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// A rope of `count` particles hung from the first one, with a control on that.
std::shared_ptr<System> rope(std::uint64_t generation, std::uint64_t run, int count,
                             double timeStep = 1.0 / 240.0)
{
    auto system = std::make_shared<System>(emptySystem(timeStep));
    system->generation = generation;
    system->run = run;
    system->gravity = {0.0, -standardGravity, 0.0};
    for (int i = 0; i < count; ++i) {
        system->key.push_back(Key(1000 + i));
        if (i == 0)
            addPin(*system, Vec3::Zero());
        else
            addParticle(*system, {0.1 * i, 0.0, 0.0}, 0.01);
        if (i > 0)
            addRod(*system, i - 1, i, 0.1);
    }
    system->inputs = {{Key(77), ControlKind::Move, {0.0, 0.0, 1.0}, 1.0, 0.5, 0.0, {0}}};
    finish(*system);
    return system;
}

// One that blows up within a few steps.
std::shared_ptr<System> unstable(std::uint64_t generation, std::uint64_t run)
{
    auto system = std::make_shared<System>(emptySystem(0.01));
    system->generation = generation;
    system->run = run;
    addPin(*system, Vec3::Zero());
    addParticle(*system, {1.1, 0.0, 0.0}, 0.001);
    addSpring(*system, 0, 1, 1.0, 1e4);
    system->key = {Key(1000), Key(1001)};
    finish(*system);
    return system;
}

// The first frame that `wanted` likes, or null after ten seconds.
std::shared_ptr<const Frame> waitFor(Runner& runner, auto wanted)
{
    const auto start = Clock::now();
    while (secondsSince(start) < 10.0) {
        if (auto frame = runner.takeFrame(); frame && wanted(*frame))
            return frame;
        std::this_thread::sleep_for(1ms);
    }
    return nullptr;
}

std::shared_ptr<const Frame> waitForStep(Runner& runner, std::int64_t step)
{
    return waitFor(runner, [=](const Frame& frame) { return frame.step >= step; });
}

bool samePositions(const Frame& frame, const State& state)
{
    return std::equal(frame.position.begin(), frame.position.end(), state.position.begin(),
                      state.position.end());
}

} // namespace

class TestRunner : public QObject
{
    Q_OBJECT

private slots:
    void latestValue()
    {
        LatestValue<Frame> box;
        const int last = 20000;
        std::jthread writer([&] {
            for (int i = 1; i <= last; ++i) {
                auto frame = std::make_shared<Frame>();
                frame->time = i;
                frame->position.assign(64, {double(i), 0.0, 0.0});
                box.put(std::move(frame));
            }
        });
        double seen = 0.0;
        while (seen < last)
            if (const auto frame = box.take()) {
                QVERIFY(frame->time > seen);
                for (const Vec3& x : frame->position)
                    QCOMPARE(x.x(), frame->time);
                seen = frame->time;
            }
        QVERIFY(!box.take());
    }

    // A run goes on from its moment also when the design changes before it could begin.
    void momentsWaitForTheNewestSystem()
    {
        const auto moment = std::make_shared<const Moment>();
        RunnerMail mail;
        mail.putUpdate({.system = rope(1, 1, 5), .patch = {}, .moment = moment});
        mail.putUpdate({.system = rope(2, 1, 6), .patch = {}});
        const std::vector<Update> sameRun = mail.takeUpdates();
        QCOMPARE(sameRun.size(), std::size_t(1));
        QCOMPARE(sameRun[0].system->generation, std::uint64_t(2));
        QCOMPARE(sameRun[0].moment, moment);

        mail.putUpdate({.system = rope(3, 1, 5), .patch = {}, .moment = moment});
        mail.putUpdate({.system = rope(4, 2, 5), .patch = {}}); // a new run
        const std::vector<Update> newRun = mail.takeUpdates();
        QCOMPARE(newRun.size(), std::size_t(1));
        QVERIFY(!newRun[0].moment);
    }

    // Without orders it stands: one frame of the start, and no more.
    void standsUntilTold()
    {
        Runner runner;
        QVERIFY(!runner.takeFrame());
        runner.load(rope(1, 1, 5));
        const auto start = waitForStep(runner, 0);
        QVERIFY(start);
        QCOMPARE(start->step, std::int64_t(0));
        QCOMPARE(start->generation, std::uint64_t(1));
        std::this_thread::sleep_for(50ms);
        QVERIFY(!runner.takeFrame());
    }

    void singleSteps()
    {
        Runner runner;
        runner.stepOnce(); // before there is anything to step
        runner.load(rope(1, 1, 5));
        for (int i = 0; i < 6; ++i)
            runner.stepOnce();
        QVERIFY(waitForStep(runner, 7));
        std::this_thread::sleep_for(30ms);
        const auto more = runner.takeFrame();
        QVERIFY(!more || more->step == 7);
    }

    void playsUntil_data()
    {
        QTest::addColumn<double>("time");
        QTest::addColumn<double>("timeStep");
        QTest::addColumn<int>("steps");
        QTest::newRow("whole steps") << 1.0 << 1.0 / 240.0 << 240;
        QTest::newRow("nearest step below") << 0.1234 << 0.01 << 12;
        QTest::newRow("nearest step above") << 0.1272 << 0.01 << 13;
        QTest::newRow("midway") << 0.125 << 0.01 << 12;
        QTest::newRow("midway, exact in binary") << 0.6875 << 0.125 << 5;
        QTest::newRow("less than half a step") << 0.004 << 0.01 << 0;
        QTest::newRow("many steps") << 30.0 << 0.001 << 30000;
        QTest::newRow("the past") << -1.0 << 0.01 << 0;
    }

    // The window and the command line stop at the same step, with the same bits.
    void playsUntil()
    {
        QFETCH(double, time);
        QFETCH(double, timeStep);
        QFETCH(int, steps);
        const auto system = rope(1, 1, 4, timeStep);
        Simulation simulation(system);
        QVERIFY(simulation.runUntil(time));
        QCOMPARE(simulation.state().step, std::int64_t(steps));
        QVERIFY(simulation.runUntil(time)); // nothing is left to do
        QCOMPARE(simulation.state().step, std::int64_t(steps));

        Runner runner;
        runner.load(system);
        runner.playUntil(time);
        const auto frame = waitForStep(runner, steps);
        QVERIFY(frame);
        QCOMPARE(frame->step, std::int64_t(steps));
        QVERIFY(samePositions(*frame, simulation.state()));
        std::this_thread::sleep_for(20ms);
        const auto more = runner.takeFrame();
        QVERIFY(!more || more->step == steps);
    }

    // One time after another, also when the next comes while the last is being reached.
    void playsOn()
    {
        Runner runner;
        runner.load(rope(1, 1, 4, 0.001));
        for (int i = 1; i <= 300; ++i) {
            runner.playUntil(0.01 * i);
            if (i % 3 == 0) {
                const auto frame = waitForStep(runner, 10 * i);
                QVERIFY2(frame, "a time that was asked for is reached");
                QCOMPARE(frame->step, std::int64_t(10 * i));
            }
        }
    }

    void editsKeepTheMotion()
    {
        Runner runner;
        runner.load(rope(1, 1, 20));
        QVERIFY(waitForStep(runner, 0));
        runner.setPlaying(true);
        QVERIFY(waitForStep(runner, 24));
        for (std::uint64_t g = 2; g <= 40; ++g) { // faster than the runner collects them
            runner.load(rope(g, 1, 20 + int(g % 5), 1.0 / double(200 + g)));
            std::this_thread::sleep_for(1ms);
        }
        const auto frame = waitFor(runner, [](const Frame& f) { return f.generation == 40; });
        QVERIFY(frame);
        QCOMPARE(frame->position.size(), std::size_t(20));
        QVERIFY(frame->time > 0.05);
        QVERIFY(frame->position[19].y() < -0.001); // still falling, not started over

        runner.load(rope(41, 2, 20));
        runner.load(rope(42, 2, 20)); // an edit right behind a reset must not undo the reset
        const auto again = waitFor(runner, [](const Frame& f) { return f.generation == 42; });
        QVERIFY(again && again->time < frame->time);
        QCOMPARE(again->run, std::uint64_t(2));
    }

    // Every frame fits its own layout, whatever is loaded meanwhile.
    void framesAreWhole()
    {
        Runner runner;
        runner.setSpeed(0.0);
        runner.setPlaying(true);
        std::jthread editor([&](const std::stop_token& stop) {
            for (std::uint64_t g = 1; !stop.stop_requested(); ++g) {
                runner.load(rope(g, g / 7, 3 + int(g % 11)));
                std::this_thread::sleep_for(500us);
            }
        });
        std::uint64_t newest = 0;
        for (int seen = 0; seen < 100;) {
            const auto frame = runner.takeFrame();
            if (!frame)
                continue;
            ++seen;
            QVERIFY(frame->generation >= newest);
            newest = frame->generation;
            QCOMPARE(frame->position.size(), std::size_t(3 + frame->generation % 11));
            QCOMPARE(frame->layout->particleId.size(), frame->position.size());
            QCOMPARE(frame->layout->links.size(), frame->tension.size());
            QCOMPARE(frame->torn.size(), frame->strain.size());
        }
    }

    // Paced: never ahead of the clock, at any speed.
    void pace()
    {
        for (const double speed : {1.0, 0.25}) {
            Runner runner;
            runner.setSpeed(speed);
            runner.load(rope(1, 1, 5, 0.01));
            QVERIFY(waitForStep(runner, 0));
            const auto start = Clock::now();
            runner.setPlaying(true);
            const auto frame = waitForStep(runner, 5);
            QVERIFY(frame);
            QVERIFY2(frame->time <= speed * secondsSince(start) + 0.011,
                     told(frame->time, speed * secondsSince(start)));
        }
    }

    // The time of a pause is not made up for.
    void pause()
    {
        Runner runner;
        runner.load(rope(1, 1, 5, 0.001));
        runner.setPlaying(true);
        auto last = waitForStep(runner, 20);
        QVERIFY(last);
        runner.setPlaying(false);
        std::this_thread::sleep_for(100ms);
        if (auto standing = runner.takeFrame())
            last = std::move(standing);
        std::this_thread::sleep_for(200ms);
        QVERIFY(!runner.takeFrame());
        const auto start = Clock::now();
        runner.setPlaying(true);
        const auto frame = waitForStep(runner, last->step + 1);
        QVERIFY(frame);
        QVERIFY2(frame->time - last->time <= secondsSince(start) + 0.002,
                 told(frame->time - last->time, secondsSince(start)));
    }

    void asFastAsItCan()
    {
        Runner runner;
        runner.setSpeed(0.0);
        runner.load(rope(1, 1, 3, 0.1));
        const auto start = Clock::now();
        runner.setPlaying(true);
        const auto frame = waitForStep(runner, 1000); // 100 s
        QVERIFY(frame);
        QVERIFY(secondsSince(start) < 10.0);
    }

    void commandsWhilePlaying()
    {
        Runner runner;
        runner.setSpeed(0.0);
        runner.load(rope(1, 1, 5, 0.01));
        runner.setPlaying(true);
        runner.command({{77, 0.1}});
        runner.command({{77, 0.3}}); // the newest counts
        const auto there = waitFor(runner, [](const Frame& f) {
            return !f.inputValue.empty() && std::abs(f.inputValue[0] - 0.3) < 1e-9;
        });
        QVERIFY(there);
        QVERIFY(isNear(there->position[0], Vec3(0.0, 0.0, 0.3), 1e-9));
        runner.load(rope(2, 1, 6, 0.01)); // kept through an edit
        const auto edited = waitFor(runner, [](const Frame& f) { return f.generation == 2; });
        QVERIFY(edited);
        QVERIFY(isNear(edited->inputValue[0], 0.3, 1e-9));
        QVERIFY(isNear(edited->position[0], Vec3(0.0, 0.0, 0.3), 1e-9));
    }

    // Trouble ends the run with a frame that says why; steps asked for meanwhile are dropped; an
    // edit that cures it goes on when it is told to.
    void trouble()
    {
        Runner runner;
        runner.setSpeed(0.0);
        runner.load(unstable(1, 1));
        runner.setPlaying(true);
        const auto stopped = waitFor(runner, [](const Frame& f) { return !f.stopped.empty(); });
        QVERIFY(stopped);
        QCOMPARE(stopped->culprit, std::uint32_t(1001));
        for (const Vec3& x : stopped->position)
            QVERIFY(x.allFinite());
        runner.setPlaying(false);
        for (int i = 0; i < 5; ++i)
            runner.stepOnce();
        std::this_thread::sleep_for(50ms);
        auto cured = unstable(2, 1);
        cured->springs[0].stiffness = 0.0;
        runner.load(cured);
        const auto frame = waitFor(runner, [](const Frame& f) { return f.generation == 2; });
        QVERIFY(frame);
        QVERIFY(frame->stopped.empty());
        std::this_thread::sleep_for(50ms);
        const auto more = runner.takeFrame();
        QVERIFY(!more || more->step == stopped->step);
        runner.stepOnce();
        QVERIFY(waitForStep(runner, stopped->step + 1));
    }

    void stopsPromptly_data()
    {
        QTest::addColumn<bool>("busy");
        QTest::newRow("idle") << false;
        QTest::newRow("far from where it shall play to") << true;
    }
    void stopsPromptly()
    {
        QFETCH(bool, busy);
        Clock::time_point before;
        {
            Runner runner;
            runner.load(rope(1, 1, 10));
            if (busy)
                runner.playUntil(1e9);
            QVERIFY(waitForStep(runner, busy ? 10 : 0));
            before = Clock::now();
        }
        QVERIFY(secondsSince(before) < 0.5);
    }
};

const RegisteredTest registered("test_runner", runPlain<TestRunner>);

} // namespace ripstop::test_runner
#include "test_runner.moc"
