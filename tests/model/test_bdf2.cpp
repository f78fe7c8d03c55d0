// BDF2 where all rods are solved together: what goes on from two substeps must not bounce off
// lines, gain by refining, or be blown away.
#include "model/sample_scenes.h"
#include "model/systems.h"
#include "registered_test.h"

#include "assembly/finish.h"
#include "builders/builder.h"
#include "compile/compile.h"
#include "laws/step_limit.h"
#include "measure/diagnostics.h"
#include "step/solver_plan.h"
#include "step/true_swings.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_bdf2 {

namespace {

// 1 kg that a line of 1 m without damping has just been tied to. It swings with w rad/s about where
// it will hang, and so far below that it pulls with twice its weight.
System loaded(double timeStep, double w)
{
    System system = heavySystem(timeStep, Integrator::Bdf2);
    system.solver = Solver::Auto;
    system.substeps = 1;
    addPin(system, Vec3::Zero());
    addRod(system, 0, addParticle(system, -Vec3::UnitY(), 1.0), 1.0, 1.0 / (w * w)).resists =
        Resists::Tension;
    finish(system);
    return system;
}

System together(double timeStep, Integrator integrator = Integrator::Bdf2)
{
    System system = heavySystem(timeStep, integrator);
    system.solver = Solver::Auto;
    system.substeps = 1;
    return system;
}

double afterASecond(const QString& name, Integrator integrator, int substeps,
                    std::string_view wanted)
{
    Scene scene = sample(name);
    scene.settings.integrator = integrator;
    scene.settings.substeps = substeps;
    Simulation simulation(*compile(scene));
    if (!simulation.runUntil(1.0))
        qFatal("%s", simulation.trouble()->message.english().c_str());
    return probe(simulation, wanted);
}

} // namespace

class TestBdf2 : public QObject
{
    Q_OBJECT

private slots:
    // A weight falls half a metre until its line gets tight, which takes its motion: a line holds
    // and does not throw. Differences of second order alone would throw it back with half of its
    // speed, an eighth of a metre high.
    void linesDoNotThrow_data()
    {
        QTest::addColumn<double>("timeStep");
        for (const double timeStep : {1e-2, 1e-3, 1e-4})
            QTest::addRow("%g s", timeStep) << timeStep;
    }
    void linesDoNotThrow()
    {
        QFETCH(double, timeStep);
        System system = together(timeStep);
        addPin(system, Vec3::Zero());
        addParticle(system, Vec3(0.0, -0.5, 0.0), 1.0);
        addRod(system, 0, 1, 1.0);
        system.rods.back().resists = Resists::Tension;
        finish(system);
        State state = system.start;
        Stepper stepper;
        bool isTight = false;
        while (state.time < 1.0) {
            stepper.step(system, state);
            const double y = state.position[1].y();
            isTight |= y < -0.999;
            QVERIFY2(!isTight || y < -0.998, told(y, -1.0));
        }
        QVERIFY(isTight);
        QVERIFY2(state.velocity[1].norm() < 1e-6, told(state.velocity[1].norm(), 0.0));
    }

    // Kites with lines that get slack and tight again: at any number of substeps the flight is the
    // one of Euler with very many.
    void refiningGainsNothing_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"delta_kite", "diamond_kite"})
            QTest::newRow(name) << QString(name);
    }
    void refiningGainsNothing()
    {
        QFETCH(QString, name);
        const double height = afterASecond(name, Integrator::SemiImplicitEuler, 64, "height");
        for (const int substeps : {4, 16}) {
            const double got = afterASecond(name, Integrator::Bdf2, substeps, "height");
            QVERIFY2(isNear(got, height, 0.05), told(got, height));
        }
    }

    // A weight on a spring and a damper, away from its balance, comes to rest within the limit of
    // the step, from no damping to the aperiodic limit; a quarter beyond it one of that leaves.
    void springsStayWithinTheLimit_data()
    {
        QTest::addColumn<double>("ratio"); // of the critical damping
        for (const double ratio : {0.0, 0.1, 0.3, 1.0})
            QTest::addRow("%g", ratio) << ratio;
    }
    void springsStayWithinTheLimit()
    {
        QFETCH(double, ratio);
        const double mass = 0.1, stiffness = 40.0;
        const double damping = 2.0 * ratio * std::sqrt(stiffness * mass);
        const auto farthest = [&](double share) {
            // both ends of a spring move in what the limit is made for; one is pinned here
            const double limit =
                springStepLimit(mass, 0.5 * stiffness, 0.5 * damping, Integrator::Bdf2);
            System system = emptySystem(share * limit, Integrator::Bdf2);
            addPin(system, Vec3::Zero());
            addParticle(system, Vec3(1.1, 0.0, 0.0), mass);
            addSpring(system, 0, 1, 1.0, stiffness, damping);
            finish(system);
            const State state = run(system, 400);
            return std::abs(state.position[1].x() - 1.0);
        };
        QVERIFY2(farthest(0.99) <= 0.1, told(farthest(0.99), 0.1));
        if (ratio == 1.0)
            QVERIFY(farthest(1.25) > 1.0);
    }

    // More particles than are factorised, in a wind from the first substep on.
    void largeSheetsFly()
    {
        System system = together(0.004);
        system.wind = Vec3(0.0, 0.0, 5.0);
        constexpr int n = 32; // a side
        constexpr double cell = 0.03;
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) {
                const Vec3 place(cell * column, -cell * row, 0.0);
                if (row == 0)
                    addPin(system, place);
                else
                    addParticle(system, place, 2e-4);
            }
        const auto tie = [&](int a, int b) {
            Rod& rod = addRod(system, a, b, 0.0, 1e-4);
            rod.restLength =
                (system.start.position[std::size_t(a)] - system.start.position[std::size_t(b)])
                    .norm();
            rod.dampingTime = 1e-3;
        };
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) {
                const int at = n * row + column;
                if (column + 1 < n)
                    tie(at, at + 1);
                if (row + 1 < n)
                    tie(at, at + n);
                if (column + 1 == n || row + 1 == n)
                    continue;
                tie(at, at + n + 1);
                addPanel(system, at, at + n, at + n + 1, AirLaw::LinearNormal, 2.0);
                addPanel(system, at, at + n + 1, at + 1, AirLaw::LinearNormal, 2.0);
            }
        finish(system);
        State state = system.start;
        Stepper stepper;
        for (int i = 0; i < 50; ++i) {
            stepper.step(system, state);
            QVERIFY2(stepper.accuracy().pulls < 0.05, told(stepper.accuracy().pulls, 0.0));
        }
        QVERIFY(state.position.back().z() > 0.1); // it goes with the wind
    }

    // A triangle of a gram and 2 m^2 square to a wind of W: W - v = W / (1 + k W t), k = rho C A /
    // (2 m), which explicit steps of 10 ms would blow up. It does not overtake the
    // wind by more than its error.
    void lightClothGoesWithTheWind()
    {
        const double speed = 8.0, mass = 1e-3;
        System system = together(0.01);
        system.gravity = Vec3::Zero();
        system.wind = Vec3(0.0, speed, 0.0);
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, 2)})
            addParticle(system, place, mass / 3.0);
        for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)})
            addRod(system, a, b,
                   (system.start.position[std::size_t(a)] - system.start.position[std::size_t(b)])
                       .norm());
        addPanel(system, 0, 1, 2, AirLaw::LinearNormal, 2.0);
        finish(system);
        State state = system.start;
        Stepper stepper;
        const double k = system.airDensity * 2.0 * 2.0 / (2.0 * mass);
        while (state.time < 0.5) {
            stepper.step(system, state);
            const double y = state.velocity[0].y();
            QVERIFY2(y > 0.0 && y < 1.001 * speed, told(y, speed));
        }
        const double left = speed / (1.0 + k * speed * state.time);
        QVERIFY2(isNear(speed - state.velocity[0].y(), left, 2e-4 * speed),
                 told(speed - state.velocity[0].y(), left));
    }

    // The sail of a light kite lies still in a steady wind, however fine its mesh is: steps of an
    // eighth find so, too. Loads of where the cloth was foreseen, late by part of a step, drove its
    // trailing edge to and fro at 0.6 m/s.
    void fineSailsDoNotLuff_data()
    {
        QTest::addColumn<int>("stepsOfDefault");
        QTest::newRow("the default step") << 1;
        QTest::newRow("an eighth of it") << 8;
    }
    void fineSailsDoNotLuff()
    {
        QFETCH(int, stepsOfDefault);
        const Builder& delta = *findBuilder("delta_kite");
        Scene scene = *build(delta, newDesign(delta, {{"segments", 20.0}}));
        scene.settings.timeStep /= stepsOfDefault;
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(6.0));
        double fastest = 0.0; // m/s, beside the nose
        double pull = 0.0;    // N, in the mean of a second
        const int steps = int(std::lround(1.0 / scene.settings.timeStep));
        for (int step = 0; step < steps; ++step) {
            QVERIFY(simulation.step());
            const State& state = simulation.state();
            for (const PaddedVec3& velocity : state.velocity)
                fastest = std::max(fastest, Vec3(velocity - state.velocity[0]).norm());
            pull += probe(simulation, "line tension") / steps;
        }
        QVERIFY2(fastest < 0.25, told(fastest, 0.0));
        QVERIFY2(isNear(pull, 11.81, 0.03), told(pull, 11.81)); // of steps of 0.13 ms
    }

    // The first pull on a line decides whether it breaks. It is right within the 1 % that swings
    // are told by, and what it falls between two steps: BDF2 that began with a step of Euler would
    // make it 6 % too little at the fastest of these.
    void firstPullIsTrue_data()
    {
        QTest::addColumn<double>("share"); // of the fastest swing that is told
        for (const double share : {0.25, 0.5, 0.98})
            QTest::addRow("%g", share) << share;
    }
    void firstPullIsTrue()
    {
        QFETCH(double, share);
        constexpr double timeStep = 1.0 / 240.0;
        const double w =
            2.0 * std::numbers::pi * share * fastestTrueSwing(Integrator::Bdf2, true, timeStep);
        const System system = loaded(timeStep, w);
        Stepper stepper;
        State state = system.start;
        double most = 0.0;
        while (state.time < 1.2 * std::numbers::pi / w) {
            stepper.step(system, state);
            most = std::max(most, tensions(system, state)[0]);
        }
        const double between = w * w * timeStep * timeStep / 8.0;
        const double amplitude = most / standardGravity - 1.0;
        QVERIFY2(isNear(amplitude, 1.0, 0.01 + between), told(amplitude, 1.0));
    }

    // Where the solver takes more substeps for a while, and fewer again, BDF2 goes on from the same
    // motion: all changes together take no more than the pi (w h)^3 / 2 that it takes of a swing
    // anyway. To begin anew would take (w h)^2 / 2, 0.3 %, at each of the 48.
    void otherSubstepsTakeNothing()
    {
        constexpr double timeStep = 1.0 / 240.0, w = 18.0;
        const System system = loaded(timeStep, w);
        Stepper stepper;
        State state = system.start;
        double most = 0.0;
        constexpr int steps = 480;
        for (int step = 0; step < steps; ++step) {
            state.substeps = 1 + step / 10 % 2;
            stepper.step(system, state);
            if (step > steps - 90)
                most = std::max(most, tensions(system, state)[0]);
        }
        const double swings = steps * timeStep * w / (2.0 * std::numbers::pi);
        const double loss = swings * 0.5 * std::numbers::pi * std::pow(w * timeStep, 3.0);
        const double between = w * w * timeStep * timeStep / 8.0;
        const double got = 2.0 - most / standardGravity;
        QVERIFY2(got > 0.0 && got < 2.0 * loss + between, told(got, loss));
    }

    // The pendulum that one gets unasked. BDF2 takes pi (w h)^3 / 2 of a swing in each
    // (step/true_swings.h), and twice as much of the height of where it turns; its first substeps
    // are of Euler. Backward Euler would take 2 % of that height each time.
    void pendulumsSwingOn()
    {
        Simulation simulation(*compile(*build(*findBuilder("rope"), {{"cord", 0.0}, // ideal
                                                                     {"segments", 1.0},
                                                                     {"length", 1.0},
                                                                     {"angle", 5.0}})));
        const double w = std::sqrt(standardGravity); // rad/s
        const double period = 2.0 * std::numbers::pi / w;
        const auto turnsAt = [&] { // m above the lowest place, within a period
            const State& state = simulation.state();
            double highest = 0.0, turn = 0.0;
            for (const double end = state.time + period; state.time < end;) {
                if (!simulation.step())
                    qFatal("it did not swing");
                const double height = 1.0 + state.position[1].y() - state.position[0].y();
                if (height > highest) { // it turns so near that its speed tells how much higher
                    highest = height;
                    turn = height + 0.5 * state.velocity[1].squaredNorm() / standardGravity;
                }
            }
            return turn;
        };
        constexpr int swings = 50;
        QVERIFY(simulation.runUntil(0.25 * period));
        const double first = turnsAt();
        QVERIFY(simulation.runUntil((swings + 0.25) * period));
        const double h = simulation.system().timeStep / simulation.frame()->substeps;
        const double loss = swings * std::numbers::pi * std::pow(w * h, 3.0);
        const double got = 1.0 - turnsAt() / first;
        QVERIFY2(isNear(got, loss, 0.1 * loss), told(got, loss));
    }

    // Lines that hang by one end swing; those that are held by both, as tight as they may be, ring
    // where nothing stretches, and so does what closes a loop.
    void whatMayRingIsCalmed_data()
    {
        QTest::addColumn<bool>("heldTwice");
        QTest::addColumn<bool>("crossed");
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("by one end") << false << false << Integrator::Bdf2;
        QTest::newRow("by both ends") << true << false << Integrator::SemiImplicitEuler;
        QTest::newRow("a loop") << false << true << Integrator::SemiImplicitEuler;
    }

    void whatMayRingIsCalmed()
    {
        QFETCH(bool, heldTwice);
        QFETCH(bool, crossed);
        System system = together(0.004, Integrator::Auto);
        const int segments = 5;
        addPin(system, Vec3::Zero());
        for (int i = 1; i < segments; ++i)
            addRod(system, i - 1, addParticle(system, Vec3(i, 0.0, 0.0), 0.1), 1.0);
        const Vec3 end(segments, 0.0, 0.0);
        addRod(system, segments - 1,
               heldTwice ? addPin(system, end) : addParticle(system, end, 0.1), 1.0);
        if (crossed)
            addRod(system, 1, 3, 2.0);
        finish(system);
        QTEST(planFor(system).integrator, "integrator");
    }

    // What the solver makes of a chain that never stretches is soft for a load that is far heavier
    // than its links, and rings; of pendulums it is stiff, however many there are.
    void heavyChainsAreCalmed()
    {
        const auto chosen = [](int lines, int links, double linkMass, double load) {
            System system = together(0.004, Integrator::Auto);
            for (int line = 0; line < lines; ++line) {
                int above = addPin(system, Vec3(line, 0.0, 0.0));
                for (int i = 1; i <= links; ++i) {
                    const int below =
                        addParticle(system, Vec3(line, -0.1 * i, 0.0), i < links ? linkMass : load);
                    addRod(system, above, below, 0.1);
                    above = below;
                }
            }
            finish(system);
            return planFor(system).integrator;
        };
        QCOMPARE(chosen(1, 100, 0.005, 65.0), Integrator::SemiImplicitEuler);
        QCOMPARE(chosen(1, 5, 0.1, 0.1), Integrator::Bdf2);
        QCOMPARE(chosen(60, 1, 1.0, 1.0), Integrator::Bdf2);
    }

    // Light ties beside a pole make it no softer, since the pole does not hang on them.
    void polesWithLightTiesAreNot()
    {
        const Builder& flag = *findBuilder("pole_flag");
        const Scene ideal = *build(flag, {{"cloth", 0.0}});
        const Scene ofCloth = *build(flag, newDesign(flag, {}));
        QCOMPARE(planFor(**compile(ideal)).integrator, Integrator::Bdf2);
        QCOMPARE(planFor(**compile(ofCloth)).integrator, Integrator::Bdf2);
    }

    // As heavy a load as a chain may hold by BDF2 hangs still within half a second.
    void theHeaviestThatIsLeftDoesNotRing()
    {
        constexpr int links = 20;
        constexpr double linkMass = 0.05, load = 10.0; // kg
        System system = together(0.004, Integrator::Auto);
        int above = addPin(system, Vec3::Zero());
        for (int i = 1; i <= links; ++i) {
            const int below =
                addParticle(system, Vec3(0.0, -0.1 * i, 0.0), i < links ? linkMass : load);
            addRod(system, above, below, 0.1);
            above = below;
        }
        finish(system);
        QCOMPARE(planFor(system).integrator, Integrator::Bdf2);
        Stepper stepper;
        State state = system.start;
        const double weight = standardGravity * (load + (links - 1) * linkMass);
        double worst = 0.0;
        for (int step = 0; step < 250; ++step) {
            stepper.step(system, state);
            if (step >= 125)
                worst = std::max(worst, std::abs(state.rodTension[0] / weight - 1.0));
        }
        QVERIFY2(worst < 0.01, qPrintable(QString::number(worst)));
    }
};

const RegisteredTest registered("test_bdf2", runPlain<TestBdf2>);

} // namespace ripstop::test_bdf2
#include "test_bdf2.moc"
