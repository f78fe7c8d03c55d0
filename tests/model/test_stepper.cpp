// The step as a whole: substeps, viscosity, pins, changing systems under a running state.
//
// Stages: time and substeps, viscosity and pins on systems of few particles; then one stepper for
// several systems, another time step in flight, and empty systems; at the end the period of a
// pendulum.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "assembly/carry_over.h"
#include "measure/diagnostics.h"

#include <QtTest>

namespace ripstop::test_stepper {

namespace {

constexpr std::array integrators{Integrator::ExplicitEuler, Integrator::SemiImplicitEuler,
                                 Integrator::Verlet, Integrator::VelocityVerlet};
constexpr std::array solvers{Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel,
                             Solver::Direct};

// A pinned ladder of springs and rods in the wind, with all that a step does.
System ladder(Integrator integrator, Solver solver, int rungs = 6)
{
    System system = emptySystem(1.0 / 200.0, integrator);
    system.solver = solver;
    system.gravity = {0.0, -standardGravity, 0.0};
    system.wind = {1.0, 0.0, 2.0};
    system.viscosity = 0.2;
    system.obstacles = {{ColliderShape::Plane,
                         {0.0, -0.25, 0.0},
                         {0.0, 1.0, 0.0},
                         0.0,
                         Response::Contact,
                         0.2,
                         0.3}};
    for (int i = 0; i < rungs; ++i)
        for (const double z : {0.0, 0.1}) {
            if (i == 0)
                addPin(system, {0.0, 0.0, z}, 0.1);
            else
                addParticle(system, {0.1 * i, 0.0, z}, 0.1);
        }
    for (int i = 0; i < rungs; ++i) {
        addRod(system, 2 * i, 2 * i + 1, 0.1);
        if (i + 1 == rungs)
            break;
        addRod(system, 2 * i, 2 * i + 2, 0.1, 1e-6);
        addSpring(system, 2 * i + 1, 2 * i + 3, 0.1, 200.0, 0.1);
        addPanel(system, 2 * i, 2 * i + 2, 2 * i + 1, AirLaw::LinearNormal, 1.2, 0.02);
        addPanel(system, 2 * i + 1, 2 * i + 2, 2 * i + 3, AirLaw::Paper, 1.2);
    }
    system.springs[1].tear = {TearRule::Strain, 0.3};
    return system;
}

} // namespace

class TestStepper : public QObject
{
    Q_OBJECT

    static void everyWay(const char* what)
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<Solver>("solver");
        for (const Integrator integrator : integrators)
            for (const Solver solver : solvers)
                QTest::addRow("%s, %s, %s", what,
                              choiceNames<Integrator>[std::size_t(integrator)].data(),
                              choiceNames<Solver>[std::size_t(solver)].data())
                    << integrator << solver;
    }

private slots:
    // Time runs in whole steps whatever the number of substeps.
    void time()
    {
        for (const int substeps : {1, 3, 7}) {
            System system = emptySystem(0.01);
            system.substeps = substeps;
            addParticle(system, Vec3::Zero(), 1.0, {1.0, 0.0, 0.0});
            finish(system);
            const State state = run(system, 250);
            QCOMPARE(state.step, std::int64_t(250));
            QVERIFY2(isNear(state.time, 2.5, 1e-12), told(state.time, 2.5));
            QVERIFY2(isNear(state.position[0].x(), 2.5, 1e-12), told(state.position[0].x(), 2.5));
        }
    }

    void substeps_data() { everyWay("four substeps are four short steps"); }
    void substeps()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        System one = ladder(integrator, solver);
        one.substeps = 4;
        System four = one;
        four.substeps = 1;
        four.timeStep /= 4.0;
        finish(one);
        finish(four);
        const State a = run(one, 100);
        const State b = run(four, 400);
        for (std::size_t i = 0; i < a.position.size(); ++i) {
            QCOMPARE(a.position[i], b.position[i]);
            QCOMPARE(a.velocity[i], b.velocity[i]);
        }
        QVERIFY(a.tears.size() == b.tears.size());
    }

    void viscosity_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<double>("timeStep");
        for (const Integrator integrator : integrators)
            for (const double timeStep : {0.1, 0.01, 0.001})
                QTest::addRow("%s, %g s", choiceNames<Integrator>[std::size_t(integrator)].data(),
                              timeStep)
                    << integrator << timeStep;
    }

    // Viscosity is a decay per second, whatever the time step: v0 exp(-c t). It acts on velocities
    // only: what is at rest far from the origin stays there (the first paper drags it in).
    void viscosity()
    {
        QFETCH(Integrator, integrator);
        QFETCH(double, timeStep);
        System system = emptySystem(timeStep, integrator);
        system.viscosity = 0.7;
        addParticle(system, Vec3::Zero(), 1.0, {3.0, 0.0, 0.0});
        addParticle(system, {100.0, 50.0, -20.0}, 1.0);
        finish(system);
        const State state = run(system, int(std::lround(2.0 / timeStep)));
        const double expected = 3.0 * std::exp(-1.4);
        QVERIFY2(isNear(state.velocity[0].x(), expected, 1e-12),
                 told(state.velocity[0].x(), expected));
        QCOMPARE(state.position[1], system.start.position[1]);
        // the way is v0 (1 - exp(-c t)) / c within one time step's share of it
        const double way = (3.0 - expected) / 0.7;
        QVERIFY2(isNear(state.position[0].x(), way, 0.7 * timeStep * way),
                 told(state.position[0].x(), way));
    }

    void pins_data() { everyWay("pins"); }

    // Nothing moves a pin: no gravity, spring, rod, air, ground, nor a velocity that it was given.
    void pins()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        System system = ladder(integrator, solver);
        system.start.velocity[0] = {5.0, 5.0, 5.0};
        finish(system);
        const State state = run(system, 200);
        for (const std::size_t i : {0u, 1u}) {
            QCOMPARE(state.position[i], system.start.position[i]);
            QCOMPARE(state.velocity[i], Vec3(Vec3::Zero()));
        }
    }

    void reusedStepper_data() { everyWay("reused"); }

    // A stepper holds scratch only: one that serves two systems in turn does to each what one of
    // its own would do.
    void reusedStepper()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        System small = ladder(integrator, solver, 4);
        System large = ladder(integrator, solver, 9);
        System other = ladder(integrator, solver, 9); // of the same size, but not the same
        for (Rod& rod : other.rods)
            rod.restLength *= 1.02;
        finish(small);
        finish(large);
        finish(other);
        Stepper shared;
        State states[]{small.start, large.start, other.start};
        const System* systems[]{&small, &large, &other};
        for (int i = 0; i < 150; ++i)
            for (const std::size_t k : {0u, 1u, 2u})
                shared.step(*systems[k], states[k]);
        for (const std::size_t k : {0u, 1u, 2u})
            QCOMPARE(stateHash(states[k]), stateHash(run(*systems[k], 150)));
    }

    void anotherTimeStep_data()
    {
        QTest::addColumn<Integrator>("before");
        QTest::addColumn<Integrator>("after");
        QTest::addColumn<int>("substeps");
        const auto verlet = Integrator::Verlet;
        const auto second = Integrator::VelocityVerlet;
        QTest::newRow("Verlet") << verlet << verlet << 1;
        QTest::newRow("Verlet with more substeps") << verlet << verlet << 3;
        QTest::newRow("velocity Verlet") << second << second << 1;
        QTest::newRow("Verlet to velocity Verlet") << verlet << second << 2;
        QTest::newRow("velocity Verlet to Verlet") << second << verlet << 1;
    }

    // The time step and the scheme may change while a projectile flies: both Verlet forms stay
    // exact, so it still lands on p0 + v0 t + g t^2 / 2.
    void anotherTimeStep()
    {
        QFETCH(Integrator, before);
        QFETCH(Integrator, after);
        QFETCH(int, substeps);
        System first = emptySystem(0.01, before);
        first.gravity = {0.0, -standardGravity, 0.0};
        addParticle(first, {1.0, 2.0, 3.0}, 1.0, {4.0, 5.0, 6.0});
        System second = first;
        second.timeStep = 0.004;
        second.substeps = substeps;
        second.integrator = after;
        finish(first);
        finish(second);
        const State half = run(first, 100);
        const State end = run(second, carryOver(first, half, second), 250);
        QVERIFY2(isNear(end.time, 2.0, 1e-12), told(end.time, 2.0));
        const Vec3 expected(9.0, 12.0 - 2.0 * standardGravity, 15.0);
        QVERIFY2(isNear(end.position[0], expected, 1e-12 * expected.norm()),
                 told(end.position[0], expected));
        const Vec3 speed(4.0, 5.0 - 2.0 * standardGravity, 6.0);
        QVERIFY2(isNear(end.velocity[0], speed, 1e-12 * speed.norm()),
                 told(end.velocity[0], speed));
    }

    void empty_data() { everyWay("nothing"); }

    // A system without particles, and one without anything but particles, can be run.
    void empty()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        System nothing = emptySystem(0.01, integrator);
        nothing.solver = solver;
        finish(nothing);
        QCOMPARE(run(nothing, 3).step, std::int64_t(3));
        addParticle(nothing, {1.0, 2.0, 3.0}, 1.0);
        nothing.start.drift.clear();
        finish(nothing);
        QCOMPARE(run(nothing, 3).position[0], Vec3(1.0, 2.0, 3.0));
    }

    void swing_data() { everyWay("swing"); }

    // A pendulum of 1 m from 10 degrees has a period of 2.01023589 s (validation 2.5), to 0.1 % at
    // dt = 1/1000 s, and loses amplitude at the rate exp(-(g/L) h t / 2) that projection costs.
    void swing()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        System system = emptySystem(1.0 / 1000.0, integrator);
        system.solver = solver;
        system.gravity = {0.0, -standardGravity, 0.0};
        const double angle = 10.0 * 3.14159265358979324 / 180.0;
        addPin(system, Vec3::Zero());
        addParticle(system, {std::sin(angle), -std::cos(angle), 0.0}, 1.0);
        addRod(system, 0, 1, 1.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        std::vector<double> crossings; // through the lowest point towards -x
        double amplitude = 0.0;        // amplitude of the last swing
        for (int i = 0; i < 12000; ++i) {
            const double x = state.position[1].x();
            stepper.step(system, state);
            const double y = state.position[1].x();
            if (x > 0.0 && y <= 0.0)
                crossings.push_back(state.time - system.timeStep * y / (y - x));
            if (i > 12000 - 2100)
                amplitude = std::max(amplitude, std::abs(y));
        }
        QVERIFY(crossings.size() >= 5);
        const double period = (crossings.back() - crossings.front()) / double(crossings.size() - 1);
        QVERIFY2(isNear(period, 2.01023589, 1e-3 * 2.01023589), told(period, 2.01023589));
        const double late = 11.0; // s, about when the last swings were measured
        const double expected =
            std::sin(angle) * std::exp(-standardGravity * system.timeStep * late / 2.0);
        const double loss = std::log(std::sin(angle) / amplitude);
        const double expectedLoss = std::log(std::sin(angle) / expected);
        QVERIFY2(isNear(loss, expectedLoss, 0.1 * expectedLoss), told(loss, expectedLoss));
    }
};

const RegisteredTest registered("test_stepper", runPlain<TestStepper>);

} // namespace ripstop::test_stepper
#include "test_stepper.moc"
