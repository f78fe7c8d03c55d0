// When a run hangs still: what swings is told from what rests, and kinetic damping gets there.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"
#include "run/settle.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_settler {

namespace {

std::shared_ptr<const System> shared(System system)
{
    return std::make_shared<const System>(std::move(system));
}

} // namespace

class TestSettler : public QObject
{
    Q_OBJECT

private slots:
    // A pendulum that loses its swing settles straight below its pin; with kinetic damping so does
    // one that would swing for ever.
    void settles_data()
    {
        QTest::addColumn<double>("viscosity"); // 1/s
        QTest::addColumn<bool>("damped");
        QTest::addColumn<Settling::Outcome>("outcome");
        QTest::newRow("in syrup") << 3.0 << false << Settling::Outcome::Still;
        QTest::newRow("without end") << 0.0 << false << Settling::Outcome::GaveUp;
        QTest::newRow("by kinetic damping") << 0.0 << true << Settling::Outcome::Still;
    }
    void settles()
    {
        QFETCH(double, viscosity);
        QFETCH(bool, damped);
        QFETCH(Settling::Outcome, outcome);
        System system = heavySystem(1.0 / 240.0);
        system.viscosity = viscosity;
        addPin(system, Vec3::Zero());
        addParticle(system, {0.6, -0.8, 0.0}, 0.1);
        addRod(system, 0, 1, 1.0);
        finish(system);
        Simulation simulation(shared(std::move(system)));
        const SettleGoal goal{.speed = 1e-3, .during = 0.5, .within = 20.0, .damped = damped};
        Settler settler(goal, simulation);
        while (!settler.isOver()) {
            QVERIFY(simulation.step());
            settler.look(simulation);
        }
        QCOMPARE(settler.progress().outcome, outcome);
        const Vec3 place = simulation.state().position[1];
        if (outcome == Settling::Outcome::Still)
            QVERIFY2(isNear(place, Vec3(0.0, -1.0, 0.0), 2e-3), told(place, Vec3(0.0, -1.0, 0.0)));
        else
            QCOMPARE(settler.progress().since >= 20.0 - 1e-6, true);
    }

    // A weight on a line of 100 m, let go 0.30 m aside, is slower than 0.01 m/s for 0.7 s at each
    // turning point and has up to 0.30 m sqrt(g / L) = 0.094 m/s between them. It takes pi sqrt(L /
    // g) = 10.03 s from one to the other; a swing that never has more than the goal is still then.
    void aTurningPointIsNoRest_data()
    {
        QTest::addColumn<double>("aside"); // m
        QTest::addColumn<bool>("isStill");
        QTest::newRow("faster than the goal") << 0.30 << false;
        QTest::newRow("a little faster") << 0.034 << false;
        QTest::newRow("slower than the goal") << 0.030 << true;
    }
    void aTurningPointIsNoRest()
    {
        QFETCH(double, aside);
        QFETCH(bool, isStill);
        System system = heavySystem(1.0 / 240.0);
        addPin(system, Vec3::Zero());
        addParticle(system, {aside, -std::sqrt(1e4 - aside * aside), 0.0}, 1.0);
        addRod(system, 0, 1, 100.0);
        finish(system);
        Simulation simulation(shared(std::move(system)));
        Settler settler({.speed = 0.01, .within = 45.0}, simulation);
        while (!settler.isOver()) {
            QVERIFY(simulation.step());
            settler.look(simulation);
        }
        QCOMPARE(settler.progress().outcome == Settling::Outcome::Still, isStill);
        if (isStill)
            QVERIFY2(std::abs(settler.progress().since - 10.03) < 0.02,
                     told(settler.progress().since, 10.03));
    }

    // A mass that swings up and down stands still at its turning points. Who gives up at one tells
    // how fast it was before, not that it is slow enough: 0.01 m at w = sqrt(k / m) = 10 rad/s.
    void tellsWhatWasTooFast()
    {
        System system = emptySystem(1.0 / 960.0);
        addPin(system, Vec3::Zero());
        addParticle(system, {1.01, 0.0, 0.0}, 1.0);
        addSpring(system, 0, 1, 1.0, 100.0);
        finish(system);
        Simulation simulation(shared(std::move(system)));
        const double period = 2.0 * std::numbers::pi / 10.0;
        Settler settler({.speed = 0.02, .during = 0.5, .within = 3.0 * period}, simulation);
        while (!settler.isOver()) {
            QVERIFY(simulation.step());
            settler.look(simulation);
        }
        QCOMPARE(settler.progress().outcome, Settling::Outcome::GaveUp);
        QVERIFY(simulation.state().velocity[1].norm() < 0.01);
        QVERIFY(settler.progress().speed > 0.02 && settler.progress().speed < 0.1 + 1e-3);
    }
};

const RegisteredTest registered("test_settler", runPlain<TestSettler>);

} // namespace ripstop::test_settler
#include "test_settler.moc"
