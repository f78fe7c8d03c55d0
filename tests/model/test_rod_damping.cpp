// Rods that stretch and are damped, against Kelvin and Voigt's solid: a spring and a damper side by
// side.
#include "model/systems.h"
#include "registered_test.h"

#include "assembly/finish.h"
#include "simulation/simulation.h"
#include "step/solver_plan.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_rod_damping {

namespace {

constexpr double mass = 1.0;        // kg
constexpr double stiffness = 400.0; // N/m
constexpr double w = 20.0;          // rad/s
constexpr double stretch = 0.1;     // m, at the start

// A weight on a rod of 1 m along x, away from its balance by `stretch`, without weight.
System swinging(double timeStep, Integrator integrator, Solver solver, double dampingTime)
{
    System system = emptySystem(timeStep, integrator);
    system.solver = solver;
    system.substeps = 1;
    addPin(system, Vec3::Zero());
    addParticle(system, {1.0 + stretch, 0.0, 0.0}, mass);
    addRod(system, 0, 1, 1.0, 1.0 / stiffness);
    system.rods.back().dampingTime = dampingTime;
    return system;
}

// m x'' + k (x + t x') = 0 from rest: x0 e^(-z w t) (cos w' t + z w / w' sin w' t), z = w t / 2.
double swingAfter(double time, double dampingTime)
{
    const double z = 0.5 * w * dampingTime;
    const double damped = w * std::sqrt(1.0 - z * z);
    return stretch * std::exp(-z * w * time)
           * (std::cos(damped * time) + z * w / damped * std::sin(damped * time));
}

double errorAfterASecond(System system, double dampingTime)
{
    finish(system);
    const State state = run(system, int(std::lround(1.0 / system.timeStep)));
    return state.position[1].x() - 1.0 - swingAfter(1.0, dampingTime);
}

} // namespace

class TestRodDamping : public QObject
{
    Q_OBJECT

private slots:
    // Two thirds of the energy go within a second; every solver loses them as the formula does.
    void swingsDieAway_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<Solver>("solver");
        QTest::addColumn<double>("timeStep");
        for (const Solver solver : {Solver::Auto, Solver::Direct, Solver::GaussSeidel,
                                    Solver::SmallSteps, Solver::AveragedJacobi})
            QTest::addRow("Euler, %s",
                          std::string(choiceNames<Solver>[std::size_t(solver)]).c_str())
                << Integrator::SemiImplicitEuler << solver << 1e-5;
        for (const Solver solver : {Solver::Auto, Solver::Direct, Solver::GaussSeidel})
            QTest::addRow("BDF2, %s", std::string(choiceNames<Solver>[std::size_t(solver)]).c_str())
                << Integrator::Bdf2 << solver << 1e-3;
    }
    void swingsDieAway()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Solver, solver);
        QFETCH(double, timeStep);
        const double dampingTime = 0.005; // z = 0.05
        const double error =
            errorAfterASecond(swinging(timeStep, integrator, solver, dampingTime), dampingTime);
        QVERIFY2(std::abs(error) < 0.01 * stretch, told(error, 0.0));
    }

    // The stretch that BDF2 looks back to keeps it of second order.
    void keepsTheOrder()
    {
        const double dampingTime = 0.02; // z = 0.2
        const auto error = [&](double timeStep) {
            return errorAfterASecond(
                swinging(timeStep, Integrator::Bdf2, Solver::Auto, dampingTime), dampingTime);
        };
        for (const double timeStep : {1e-3, 5e-4}) {
            const double order = std::log2(error(timeStep) / error(0.5 * timeStep));
            QVERIFY2(isNear(order, 2.0, 0.1), told(order, 2.0));
        }
    }

    // What only turns does not stretch: on a circle the damper takes nothing.
    void turningIsFree_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("Euler") << Integrator::SemiImplicitEuler;
        QTest::newRow("BDF2") << Integrator::Bdf2;
    }
    void turningIsFree()
    {
        QFETCH(Integrator, integrator);
        const double turns = 3.0; // rad/s
        // k s = m w^2 (1 + s)
        const double balance = mass * turns * turns / (stiffness - mass * turns * turns);
        const auto speed = [&](double dampingTime) {
            System system = swinging(1e-3, integrator, Solver::Auto, dampingTime);
            system.start.position[1] = Vec3(1.0 + balance, 0.0, 0.0);
            system.start.velocity[1] = Vec3(0.0, turns * (1.0 + balance), 0.0);
            finish(system);
            return run(system, 2000).velocity[1].norm();
        };
        QVERIFY2(isNear(speed(0.01), speed(0.0), 1e-4 * turns), told(speed(0.01), speed(0.0)));
    }

    // A damper of what is slack would brake it on its way to its length, and hold it on its way
    // back.
    void slackLinesAreFree_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("Euler") << Integrator::SemiImplicitEuler;
        QTest::newRow("BDF2") << Integrator::Bdf2;
    }
    void slackLinesAreFree()
    {
        QFETCH(Integrator, integrator);
        System system = swinging(1e-3, integrator, Solver::Auto, 0.02);
        system.rods.back().resists = Resists::Tension;
        system.start.position[1] = Vec3(0.5, 0.0, 0.0);
        system.start.velocity[1] = Vec3(1.0, 0.0, 0.0);
        finish(system);
        State state = system.start;
        Stepper stepper;
        bool wasTight = false;
        while (state.time < 1.5) {
            stepper.step(system, state);
            const bool isTight = state.position[1].x() > 1.0;
            if (!isTight && !wasTight)
                QVERIFY2(isNear(state.velocity[1].x(), 1.0, 1e-12),
                         told(state.velocity[1].x(), 1.0));
            if (!isTight)
                QVERIFY2(state.rodTension[0] < 1e-9, told(state.rodTension[0], 0.0));
            wasTight |= isTight;
        }
        QVERIFY(wasTight);
        QVERIFY(state.position[1].x() < 1.0); // it is on its way back
        QVERIFY(state.velocity[1].x() < 0.0);
    }

    // What has come to rest has lost k s^2 / 2, all of it to its damper.
    void ledgerHasIt()
    {
        System system = swinging(1e-4, Integrator::Bdf2, Solver::Auto, 0.02);
        askForLedger(system);
        finish(system);
        Simulation simulation(std::make_shared<const System>(system));
        QVERIFY(simulation.runUntil(3.0));
        const double expected = -0.5 * stiffness * stretch * stretch;
        const Work& work = simulation.state().work;
        QVERIFY2(isNear(work.damping, expected, 0.01 * -expected), told(work.damping, expected));
        QVERIFY2(std::abs(work.residual) < 0.01 * -expected, told(work.residual, 0.0));
    }

    // The paper's solver holds rods at their lengths, whatever they are made of.
    void thePaperKnowsNone()
    {
        System damped = swinging(1e-3, Integrator::SemiImplicitEuler, Solver::PaperJacobi, 0.02);
        damped.rods.back().resists = Resists::Both;
        finish(damped);
        const State state = run(damped, 50);
        QVERIFY2(isNear(state.position[1].x(), 1.0, 1e-9), told(state.position[1].x(), 1.0));
    }

    // The error of pulls knows of the damper, or a plunge would count as a solver that misses.
    void accuracyKnowsIt()
    {
        System system = swinging(1e-3, Integrator::SemiImplicitEuler, Solver::Auto, 0.02);
        finish(system);
        State state = system.start;
        Stepper stepper;
        for (int i = 0; i < 100; ++i) {
            stepper.step(system, state);
            QVERIFY2(stepper.accuracy().pulls < 1e-3, told(stepper.accuracy().pulls, 0.0));
        }
    }

    // Bare rods between two pins that never stretch, or stretch without a damper, have nothing to
    // calm them but what Euler loses.
    void bdf2WhereItIsCalm()
    {
        const auto chosen = [](double compliance, double dampingTime) {
            System system = swinging(0.01, Integrator::Auto, Solver::Auto, dampingTime);
            system.substeps = 4;
            addRod(system, 1, addPin(system, {2.0, 0.0, 0.0}), 1.0).dampingTime = dampingTime;
            for (Rod& rod : system.rods) {
                rod.compliance = compliance; // so stiff that it is solved together
                rod.resists = Resists::Tension;
            }
            finish(system);
            return planFor(system);
        };
        const SolverPlan damped = chosen(1e-7, 1e-3);
        QCOMPARE(damped.integrator, Integrator::Bdf2);
        QCOMPARE(damped.least, 1);
        QCOMPARE(chosen(1e-7, 0.0).integrator, Integrator::SemiImplicitEuler);
        QCOMPARE(chosen(1e-7, 0.0).least, 4);
        QCOMPARE(chosen(0.0, 1e-3).integrator, Integrator::SemiImplicitEuler);
    }
};

const RegisteredTest registered("test_rod_damping", runPlain<TestRodDamping>);

} // namespace ripstop::test_rod_damping
#include "test_rod_damping.moc"
