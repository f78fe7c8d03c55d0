// What the steps of the last ten seconds took is told until it is over, and as a share of the
// motion where that dies away by it.
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "model/systems.h"
#include "registered_test.h"
#include "simulation/recent_damping.h"
#include "step/stepper.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <vector>

namespace ripstop::test_recent_damping {

namespace {

constexpr double timeStep = 1.0 / 240.0;
constexpr int perSecond = 240;

// Two weights that go round each other on a rod that gives way a little, so many times in a second.
System bola(double turns)
{
    System system = emptySystem(timeStep, Integrator::Bdf2);
    system.solver = Solver::Direct;
    const double speed = std::numbers::pi * turns; // m/s, at half a metre
    addParticle(system, {-0.5, 0.0, 0.0}, 1.0, {0.0, -speed, 0.0});
    addParticle(system, {0.5, 0.0, 0.0}, 1.0, {0.0, speed, 0.0});
    addRod(system, 0, 1, 1.0, 1e-5);
    return system;
}

// The same on a chain of ten rods that never stretch, by Euler's method.
System chainOfRods(double turns)
{
    System system = emptySystem(timeStep);
    system.solver = Solver::Direct;
    constexpr int rods = 10;
    for (int i = 0; i <= rods; ++i) {
        const double x = double(i) / rods - 0.5;
        addParticle(system, {x, 0.0, 0.0}, i == 0 || i == rods ? 1.0 : 1e-3,
                    {0.0, 2.0 * std::numbers::pi * turns * x, 0.0});
    }
    for (int i = 0; i < rods; ++i)
        addRod(system, i, i + 1, 1.0 / rods);
    return system;
}

struct Flown
{
    RecentDamping damping;
    std::vector<double> kinetic; // [steps] J
};

Flown flown(System& system, int steps)
{
    finish(system);
    Flown flown;
    Stepper stepper;
    State state = system.start;
    for (int i = 0; i < steps; ++i) {
        stepper.step(system, state);
        flown.damping.add(stepper.numericalDamping(), system, state);
        flown.kinetic.push_back(kineticEnergy(system, state));
    }
    return flown;
}

} // namespace

class TestRecentDamping : public QObject
{
    Q_OBJECT

private slots:
    // To a second.
    void forgets()
    {
        System system = emptySystem(timeStep);
        addParticle(system, Vec3::Zero(), 1.0, Vec3::UnitX());
        finish(system);
        RecentDamping damping;
        for (int i = 0; i < perSecond; ++i)
            damping.add({0.5 * std::numbers::pi, 1.0}, system, system.start);
        const auto rest = [&](double seconds) {
            for (int i = 0; i < int(std::round(seconds / timeStep)); ++i)
                damping.add({0.0, 1.0}, system, system.start);
            return damping.ratio();
        };
        const auto isNear = [](double got, double expected) {
            return std::abs(got - expected) < 1e-9;
        };
        QVERIFY(isNear(damping.ratio(), 0.5));
        QVERIFY(isNear(rest(1.0), 0.25));
        QVERIFY(isNear(rest(8.0), 0.05));
        QCOMPARE(rest(1.5), 0.0);
    }

    // Of the four and four full seconds before the last one, BDF2 takes about a quarter of the
    // energy of what goes round five times in a second, far below a hundredth of critical; and
    // Euler's method an eighth of what does so once in two.
    void dyingAwayIsTold_data()
    {
        QTest::addColumn<System>("made");
        QTest::addColumn<double>("ratio"); // of a swing of as many turns
        const auto angle = [](double turns) { return 2.0 * std::numbers::pi * turns * timeStep; };
        QTest::newRow("one rod, BDF2") << bola(5.0) << std::pow(angle(5.0), 3.0) / 4.0;
        QTest::newRow("ten rods that never stretch, Euler") << chainOfRods(0.5) << angle(0.5) / 2.0;
    }
    void dyingAwayIsTold()
    {
        QFETCH(const System, made);
        QFETCH(const double, ratio);
        System system = made;
        const Flown flown = test_recent_damping::flown(system, 10 * perSecond + 1);
        const std::size_t first = 2 * perSecond - 1;
        const std::size_t last = 10 * perSecond - 1;
        const double lost = 1.0 - flown.kinetic[last] / flown.kinetic[first];
        QVERIFY2(std::abs(flown.damping.lost() - lost) < 0.05 * lost,
                 qPrintable(QString("%1, expected %2").arg(flown.damping.lost()).arg(lost)));
        const double told = flown.damping.ratio();
        QVERIFY2(told < 1.1 * ratio && told < 0.01,
                 qPrintable(QString("%1, expected %2").arg(told).arg(ratio)));
    }

    // What is slow keeps its energy.
    void slowMotionKeepsOn()
    {
        System system = bola(0.5);
        QVERIFY(flown(system, 10 * perSecond).damping.lost() < 0.001);
    }

    // Beside a damper that takes far more, the steps are not to blame.
    void dampersAreNotTheSteps()
    {
        System system = bola(5.0);
        const int pin = addPin(system, {0.0, 0.0, 5.0});
        const int weight = addParticle(system, {0.0, 0.0, 11.0}, 50.0);
        Spring& spring = addSpring(system, pin, weight, 1.0, 100.0);
        spring.damping = 10.0;
        QCOMPARE(flown(system, 10 * perSecond).damping.lost(), 0.0);
    }

    // Millimetres in a second are the rest of a motion.
    void restIsNothing()
    {
        for (const auto& [speed, expected] : {std::pair(0.02, 0.5), std::pair(0.005, 0.0)}) {
            System system = emptySystem(timeStep);
            addParticle(system, Vec3::Zero(), 1.0, speed * Vec3::UnitX());
            finish(system);
            RecentDamping damping;
            for (int i = 0; i < perSecond; ++i)
                damping.add({0.5 * std::numbers::pi, 1.0}, system, system.start);
            QVERIFY(std::abs(damping.ratio() - expected) < 1e-9);
        }
    }

    // Before there are two full seconds nothing can be told.
    void beginsWithNothing()
    {
        QCOMPARE(RecentDamping().lost(), 0.0);
        System system = bola(5.0);
        QCOMPARE(flown(system, 2 * perSecond).damping.lost(), 0.0);
    }
};

const RegisteredTest registered("test_recent_damping", runPlain<TestRecentDamping>);

} // namespace ripstop::test_recent_damping
#include "test_recent_damping.moc"
