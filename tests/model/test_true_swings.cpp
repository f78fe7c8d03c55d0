// Up to which frequency a step says that it tells swings truly, against swings: a mass on a spring,
// and on a rod that gives way as much, with each integrator. At that frequency it swings at the
// right rate, and loses no more of its height than is said; half as fast again it does not.
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "model/systems.h"
#include "registered_test.h"
#include "simulation/recent_damping.h"
#include "step/numerical_damping.h"
#include "step/stepper.h"
#include "step/true_swings.h"

#include <QtTest>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace ripstop::test_true_swings {

namespace {

constexpr double timeStep = 1.0 / 240.0;
constexpr int periods = 10;
constexpr int bob = 1; // the particle that swings

struct Swing
{
    double frequency; // over the true one
    double loss;      // of its height from one swing to the next; negative where it grows
};

// Zeros are looked for between steps, and sizes compared over as many periods each.
Swing swingOf(const std::vector<double>& way, double frequency)
{
    std::vector<double> zeros; // steps
    for (std::size_t i = 1; i < way.size(); ++i)
        if (way[i - 1] < 0.0 && way[i] >= 0.0)
            zeros.push_back(double(i) - way[i] / (way[i] - way[i - 1]));
    const double period = (zeros.back() - zeros.front()) / double(zeros.size() - 1) * timeStep;
    const auto size = [&](std::size_t window) {
        const auto steps = std::size_t(std::round(periods / frequency / timeStep));
        double square = 0.0;
        for (std::size_t i = window * steps; i < (window + 1) * steps; ++i)
            square += way[i] * way[i];
        return std::sqrt(square);
    };
    return {1.0 / (period * frequency), 1.0 - std::pow(size(1) / size(0), 1.0 / periods)};
}

// A mass that is held by a pin, and begins where it turns.
System swinging(Integrator integrator, bool held, double frequency)
{
    System system = emptySystem(timeStep, integrator);
    const double omega = 2.0 * std::numbers::pi * frequency;
    const double stiffness = omega * omega; // N/m, of 1 kg
    const int pin = addPin(system, Vec3::Zero());
    addParticle(system, {1.001, 0.0, 0.0}, 1.0);
    if (held) {
        system.solver = Solver::Direct;
        addRod(system, pin, bob, 1.0, 1.0 / stiffness);
    } else {
        addSpring(system, pin, bob, 1.0, stiffness);
    }
    finish(system);
    return system;
}

Swing swingOf(Integrator integrator, bool held, double frequency)
{
    const System system = swinging(integrator, held, frequency);
    Stepper stepper;
    State state = system.start;
    std::vector<double> way;
    const auto steps = std::size_t(2.2 * periods / frequency / timeStep);
    for (std::size_t i = 0; i < steps; ++i) {
        way.push_back(state.position[std::size_t(bob)].x() - 1.0);
        stepper.step(system, state);
    }
    return swingOf(way, frequency);
}

double dampingOf(std::complex<double> root) { return -std::log(std::abs(root)) / std::arg(root); }

// Of a swing by the angle w h in a substep, 1: see measuresItsDamping().
double dampingOfEuler(double angle) { return dampingOf(1.0 / std::complex(1.0, -angle)); }

double dampingOfBdf2(double angle)
{
    const std::complex a(3.0, -2.0 * angle); // (3/2 - i w h) r^2 - 2 r + 1/2 = 0
    return dampingOf((2.0 + std::sqrt(4.0 - a)) / a);
}

// What so many steps say that they damp.
double ratioOf(const System& system, int steps)
{
    Stepper stepper;
    State state = system.start;
    RecentDamping damping;
    for (int i = 0; i < steps; ++i) {
        stepper.step(system, state);
        damping.add(stepper.numericalDamping(), system, state);
    }
    return damping.ratio();
}

} // namespace

class TestTrueSwings : public QObject
{
    Q_OBJECT

private slots:
    void tellsTheFastest_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<bool>("held");
        const auto row = [](Integrator integrator, bool held) {
            QTest::addRow("%s, %s", choiceNames<Integrator>[std::size_t(integrator)].data(),
                          held ? "rod" : "spring")
                << integrator << held;
        };
        for (const Integrator integrator :
             {Integrator::ExplicitEuler, Integrator::SemiImplicitEuler, Integrator::Verlet,
              Integrator::VelocityVerlet, Integrator::RungeKutta4})
            row(integrator, false);
        for (const Integrator integrator :
             {Integrator::SemiImplicitEuler, Integrator::ImplicitEuler, Integrator::Bdf2})
            row(integrator, true);
    }

    void tellsTheFastest()
    {
        QFETCH(Integrator, integrator);
        QFETCH(bool, held);
        const double fastest = fastestTrueSwing(integrator, held, timeStep);
        const auto errorAt = [&](double frequency) {
            const Swing swing = swingOf(integrator, held, frequency);
            return std::max(std::abs(swing.frequency - 1.0), std::abs(swing.loss));
        };
        const double at = errorAt(fastest);
        QVERIFY2(at < 0.011, qPrintable(QString::number(at)));
        const double above = errorAt(1.5 * fastest);
        QVERIFY2(above > 0.012, qPrintable(QString::number(above)));
    }

    // What the steps say that they damp is what they do, by the roots r of the methods for w h
    // (Hairer and Wanner 1996, section V.1): -ln |r| / arg r of the critical damping, about w h / 2
    // with backward Euler and (w h)^3 / 4 with BDF2; and nothing of what springs alone move.
    void measuresItsDamping_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<bool>("held");
        QTest::addColumn<double>("angle"); // w h, rad
        QTest::addColumn<double>("ratio");
        QTest::newRow("Euler") << Integrator::SemiImplicitEuler << true << 0.05
                               << dampingOfEuler(0.05);
        QTest::newRow("implicit Euler")
            << Integrator::ImplicitEuler << true << 0.05 << dampingOfEuler(0.05);
        QTest::newRow("BDF2") << Integrator::Bdf2 << true << 0.1 << dampingOfBdf2(0.1);
        QTest::newRow("BDF2, faster") << Integrator::Bdf2 << true << 0.2 << dampingOfBdf2(0.2);
        QTest::newRow("a spring") << Integrator::SemiImplicitEuler << false << 0.05 << 0.0;
    }

    void measuresItsDamping()
    {
        QFETCH(Integrator, integrator);
        QFETCH(bool, held);
        QFETCH(double, angle);
        QFETCH(double, ratio);
        const double frequency = angle / timeStep / (2.0 * std::numbers::pi);
        System system = swinging(integrator, held, frequency);
        system.start.position[bob].x() = 1.1;
        const double got = ratioOf(system, int(5 * 2.0 * std::numbers::pi / angle));
        QVERIFY2(std::abs(got - ratio) <= 0.05 * ratio, qPrintable(QString::number(got)));
    }

    // What goes round on what pulls as a spring of no length does swings along two axes, each as
    // fast as the other.
    void measuresRoundSwings()
    {
        const double angle = 0.1; // w h, rad
        const double omega = angle / timeStep;
        System system = emptySystem(timeStep, Integrator::Bdf2);
        system.solver = Solver::Direct;
        const double radius = 1.0, length = 1e-6;
        addPin(system, Vec3::Zero());
        addParticle(system, {radius, 0.0, 0.0}, 1.0, {0.0, 0.0, omega * radius});
        addRod(system, 0, bob, length, 1.0 / (omega * omega));
        finish(system);
        const double ratio = dampingOfBdf2(angle);
        const double got = ratioOf(system, int(10.0 * std::numbers::pi / angle));
        QVERIFY2(std::abs(got - ratio) <= 0.05 * ratio, qPrintable(QString::number(got)));
    }

    // A frame of three rods that spins about its middle has all of its energy in its motion, so
    // that it loses twice the share of it that a swing would: ln(E0 / E) = 4 z by the angle. That
    // is so whether its rods never stretch or give way a little.
    void measuresTurning_data()
    {
        QTest::addColumn<double>("compliance"); // m/N
        QTest::newRow("rods that never stretch") << 0.0;
        QTest::newRow("rods that give way") << 1e-7;
    }

    void measuresTurning()
    {
        QFETCH(double, compliance);
        const double angle = 0.2; // in a step, rad
        const double omega = angle / timeStep;
        System system = emptySystem(timeStep, Integrator::Bdf2);
        system.solver = Solver::Direct;
        for (int i = 0; i < 3; ++i) {
            const double at = 2.0 / 3.0 * std::numbers::pi * i;
            addParticle(system, {std::cos(at), 0.0, std::sin(at)}, 1.0,
                        {-omega * std::sin(at), 0.0, omega * std::cos(at)});
        }
        for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}})
            addRod(system, a, b, distance(system, a, b), compliance);
        finish(system);
        Stepper stepper;
        State state = system.start;
        const auto go = [&](int steps) {
            RecentDamping damping;
            for (int i = 0; i < steps; ++i) {
                stepper.step(system, state);
                damping.add(stepper.numericalDamping(), system, state);
            }
            return damping.ratio();
        };
        go(50); // until it spins steadily
        const double before = kineticEnergy(system, state);
        constexpr int steps = 300;
        const double got = go(steps);
        const double lost = std::log(before / kineticEnergy(system, state));
        const double speed = std::sqrt(kineticEnergy(system, state) / 1.5); // m/s, about
        const double ratio = lost / (4.0 * speed * timeStep * steps);
        QVERIFY2(std::abs(got - ratio) <= 0.1 * ratio,
                 qPrintable(QString("%1, expected %2").arg(got).arg(ratio)));
    }

    // At rest nothing is damped, however rounding turns it.
    void restIsNotDamped()
    {
        System system = swinging(Integrator::SemiImplicitEuler, true, 5.0);
        system.start.position[bob] = Vec3(1.0, 0.0, 0.0);
        QVERIFY(ratioOf(system, 240) < 1e-6);
    }

    // The step that a new scene gets says so of itself: a cord that is solved together by BDF2.
    void stepperSaysIt()
    {
        System system = emptySystem(timeStep, Integrator::Bdf2);
        system.solver = Solver::Direct;
        addPin(system, Vec3::Zero());
        addRod(system, 0, addParticle(system, {1.0, 0.0, 0.0}, 1.0), 1.0, 1e-4);
        finish(system);
        Stepper stepper;
        State state = system.start;
        QCOMPARE(stepper.fastestTrueSwing(system, state), 0.0); // it has not chosen yet
        stepper.step(system, state);
        QCOMPARE(stepper.fastestTrueSwing(system, state),
                 fastestTrueSwing(Integrator::Bdf2, true, timeStep));
    }
};

const RegisteredTest registered("test_true_swings", runWithCore<TestTrueSwings>);

} // namespace ripstop::test_true_swings
#include "test_true_swings.moc"
