// What stops a simulation, and what it says.
//
// Stages: a step that is too long is stopped with element, time and cause, and goes on after a
// cure; then explicit Euler, numbers that are none, mass ratios, and torn springs that are not to
// blame.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "measure/diagnostics.h"
#include "simulation/simulation.h"
#include "step/watchdog.h"

#include <QtTest>

namespace ripstop::test_watchdog {

namespace {

// A weight on a spring of this stiffness, stretched by 1 cm; its key is 42.
std::shared_ptr<System> spring(double stiffness, double timeStep,
                               Integrator integrator = Integrator::SemiImplicitEuler)
{
    auto system = std::make_shared<System>(emptySystem(timeStep, integrator));
    addPin(*system, Vec3::Zero());
    addParticle(*system, {1.01, 0.0, 0.0}, 1.0);
    addSpring(*system, 0, 1, 1.0, stiffness);
    system->key = {Key(41), Key(42)};
    finish(*system);
    return system;
}

QString messageOf(const System& system, const State& before, const State& after)
{
    const auto trouble = findTrouble(system, before, after, system.substeps);
    return trouble ? QString::fromStdString(trouble->message.english()) : QString();
}

} // namespace

class TestWatchdog : public QObject
{
    Q_OBJECT

private slots:
    void stepTooLong_data()
    {
        QTest::addColumn<double>("factor"); // multiple of the longest stable step
        QTest::addColumn<bool>("stops");
        QTest::newRow("just below the limit") << 0.99 << false;
        QTest::newRow("just above the limit") << 1.02 << true;
        QTest::newRow("far above the limit") << 5.0 << true;
    }

    // One weight on one spring, the other end pinned: unstable from dt = 2 sqrt(m / k) on. The
    // bound that the message tells is the safe one, sqrt(2 m / k).
    void stepTooLong()
    {
        QFETCH(double, factor);
        QFETCH(bool, stops);
        const double stiffness = 1e4;
        const double limit = 2.0 * std::sqrt(1.0 / stiffness);
        Simulation simulation(spring(stiffness, factor * limit));
        const bool done = simulation.runUntil(2000 * factor * limit);
        QCOMPARE(done, !stops);
        QCOMPARE(simulation.trouble().has_value(), stops);
        if (!stops)
            return;

        // stopped at the last good state
        const State& state = simulation.state();
        for (const Vec3& x : state.position)
            QVERIFY(x.allFinite());
        for (const Vec3& v : state.velocity)
            QVERIFY(v.norm() <= simulation.system().speedLimit);
        const std::uint64_t hash = stateHash(state);
        QVERIFY(!simulation.step());
        QCOMPARE(stateHash(simulation.state()), hash);

        // the message names element, time and cause
        const QString message = QString::fromStdString(simulation.trouble()->message.english());
        QCOMPARE(simulation.trouble()->particle, Key(42));
        QVERIFY2(message.contains("42"), qPrintable(message));
        QVERIFY2(message.contains("time step") || message.contains("substep"), qPrintable(message));
        QVERIFY2(message.contains("0.0141"), qPrintable(message)); // sqrt(2 m / k)
        QVERIFY2(
            isNear(simulation.trouble()->time, state.time + simulation.system().timeStep, 1e-9),
            told(simulation.trouble()->time, state.time));
        const auto frame = simulation.frame();
        QCOMPARE(QString::fromStdString(frame->stopped.english()), message);
        QCOMPARE(frame->culprit, std::uint32_t(42));
        QCOMPARE(frame->time, state.time);
    }

    // An edit that cures the trouble lets the simulation go on from the last good state.
    void cured()
    {
        Simulation simulation(spring(1e4, 0.1));
        QVERIFY(!simulation.runUntil(100.0));
        const double time = simulation.state().time;
        auto softer = spring(1.0, 0.1);
        softer->viscosity = 1.0;
        simulation.load(softer);
        QVERIFY(!simulation.trouble());
        QCOMPARE(simulation.state().time, time);
        QVERIFY(simulation.frame()->stopped.empty());
        QVERIFY(simulation.runUntil(time + 10.0));
        QVERIFY(isNear(simulation.state().time, time + 10.0, 1e-9));
    }

    void explicitEuler()
    {
        Simulation simulation(spring(1e4, 0.01, Integrator::ExplicitEuler));
        QVERIFY(!simulation.runUntil(100.0));
        const QString message = QString::fromStdString(simulation.trouble()->message.english());
        QVERIFY2(message.contains("xplicit Euler"), qPrintable(message));
    }

    void broken_data()
    {
        QTest::addColumn<Vec3>("position");
        QTest::addColumn<Vec3>("velocity");
        QTest::addColumn<bool>("found");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double infinity = std::numeric_limits<double>::infinity();
        const Vec3 zero = Vec3::Zero();
        QTest::newRow("at rest") << zero << zero << false;
        QTest::newRow("at the speed limit") << zero << Vec3(0.0, 0.0, 1000.0) << false;
        QTest::newRow("above the speed limit") << zero << Vec3(0.0, 0.0, 1000.1) << true;
        QTest::newRow("position not a number") << Vec3(0.0, nan, 0.0) << zero << true;
        QTest::newRow("position infinite") << Vec3(infinity, 0.0, 0.0) << zero << true;
        QTest::newRow("velocity not a number") << zero << Vec3(nan, 0.0, 0.0) << true;
        QTest::newRow("velocity infinite") << zero << Vec3(0.0, -infinity, 0.0) << true;
        QTest::newRow("square out of range") << zero << Vec3(1e200, 0.0, 0.0) << true;
    }
    void broken()
    {
        QFETCH(Vec3, position);
        QFETCH(Vec3, velocity);
        QFETCH(bool, found);
        System system = emptySystem(0.01);
        addParticle(system, Vec3::Zero(), 1.0);
        addParticle(system, Vec3::Zero(), 1.0);
        system.key = {Key(5), Key(6)};
        finish(system);
        State after = system.start;
        after.position[1] = position;
        after.velocity[1] = velocity;
        const auto trouble = findTrouble(system, system.start, after, system.substeps);
        QCOMPARE(trouble.has_value(), found);
        if (found)
            QCOMPARE(trouble->particle, Key(6));
    }

    // A gram beside a tonne on a rod: the mass ratio is the likely cause.
    void massRatio()
    {
        System system = emptySystem(0.01);
        addParticle(system, Vec3::Zero(), 1e-3);
        addParticle(system, {1.0, 0.0, 0.0}, 1e3);
        addRod(system, 0, 1, 1.0);
        finish(system);
        State after = system.start;
        after.velocity[0] = {2000.0, 0.0, 0.0};
        const QString message = messageOf(system, system.start, after);
        QVERIFY2(message.contains("1000000") && message.contains("mass"), qPrintable(message));
    }

    // A torn spring is not blamed for a step that was too long for it.
    void tornSpringIsInnocent()
    {
        const auto system = spring(1e8, 0.01);
        State before = system->start;
        before.springTorn[0] = 1;
        State after = before;
        after.velocity[1] = {2000.0, 0.0, 0.0};
        const QString message = messageOf(*system, before, after);
        QVERIFY2(!message.isEmpty() && !message.contains("springs allow"), qPrintable(message));
    }
};

const RegisteredTest registered("test_watchdog", runPlain<TestWatchdog>);

} // namespace ripstop::test_watchdog
#include "test_watchdog.moc"
