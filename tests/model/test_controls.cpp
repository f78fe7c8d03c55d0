// Controls: corners that are moved, pilots that shift their weight.
//
// Stages: corners that are moved by commands, with and without a rate, alone and together; what
// hangs on them; then weight shift, in which rods change their lengths, against the lengths by
// hand, also with torn rods.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "measure/diagnostics.h"
#include "simulation/simulation.h"
#include "step/inputs.h"

#include <QtTest>

namespace ripstop::test_controls {

namespace {

constexpr std::array integrators{Integrator::ExplicitEuler, Integrator::SemiImplicitEuler,
                                 Integrator::Verlet, Integrator::VelocityVerlet};
constexpr std::array solvers{Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel,
                             Solver::Direct};

Input moving(std::vector<int> targets, const Vec3& axis = {1.0, 0.0, 0.0}, double rate = 0.5)
{
    return {Key(90), ControlKind::Move, axis, 1.0, rate, 0.0, std::move(targets)};
}

// A pilot of 70 kg hung 1 m below a square frame of four pins, by five rods: to the corners and to
// the middle. Rods stand in the system in an order of their own.
System pilotInFrame(Solver solver)
{
    System system = emptySystem(1.0 / 240.0);
    system.substeps = 4;
    system.sweeps = 20;
    system.solver = solver;
    for (const double x : {-1.0, 1.0})
        for (const double z : {-0.8, 0.8})
            addPin(system, {x, 0.0, z}, 2.0);
    addPin(system, Vec3::Zero(), 2.0);
    const int pilot = addParticle(system, {0.1, -1.0, 0.0}, 70.0);
    for (int corner = 4; corner >= 0; --corner) {
        if (corner % 2)
            addRod(system, pilot, corner, distance(system, pilot, corner));
        else
            addRod(system, corner, pilot, distance(system, pilot, corner));
        system.shiftedRods.push_back({int(system.rods.size()) - 1, pilot,
                                      system.start.position[std::size_t(corner)]
                                          - system.start.position[std::size_t(pilot)]});
    }
    system.inputs = {{Key(80), ControlKind::WeightShift, {1.0, 0.0, 0.0}, 0.3, 0.5, 0.0, {pilot}},
                     {Key(81), ControlKind::WeightShift, {0.0, 0.0, 1.0}, 0.3, 0.5, 0.0, {pilot}}};
    finish(system);
    return system;
}

} // namespace

class TestControls : public QObject
{
    Q_OBJECT

    static void everyIntegrator()
    {
        QTest::addColumn<Integrator>("integrator");
        for (const Integrator integrator : integrators)
            QTest::newRow(choiceNames<Integrator>[std::size_t(integrator)].data()) << integrator;
    }

private slots:
    void cornerIsAsFastAsItGoes_data() { everyIntegrator(); }

    // F19: a pinned corner that is moved by key presses of 0.01 m goes where it is told. It is as
    // fast as it goes there, and nothing remembers that once it stands: the 0.01 m are no speed.
    void cornerIsAsFastAsItGoes()
    {
        QFETCH(Integrator, integrator);
        System system = emptySystem(0.01, integrator);
        addPin(system, {0.0, 1.0, 0.0});
        system.inputs = {moving({0})};
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int press = 1; press <= 20; ++press) {
            state.inputCommand[0] = 0.01 * press;
            for (int i = 0; i < 5; ++i) {
                const double before = state.inputValue[0];
                stepper.step(system, state);
                const double speed = (state.inputValue[0] - before) / system.timeStep;
                QVERIFY2(isNear(state.velocity[0], Vec3(speed, 0.0, 0.0), 1e-9),
                         told(state.velocity[0], Vec3(speed, 0.0, 0.0)));
                QVERIFY(speed < (i < 2 ? 0.5 + 1e-9 : 1e-9));
                QCOMPARE(state.drift[0], state.velocity[0]);
                QVERIFY2(isNear(state.position[0], Vec3(state.inputValue[0], 1.0, 0.0), 1e-14),
                         told(state.position[0], Vec3(state.inputValue[0], 1.0, 0.0)));
            }
        }
        QVERIFY2(isNear(state.inputValue[0], 0.2, 1e-14), told(state.inputValue[0], 0.2));
        state.inputCommand[0] = 0.0; // and back
        for (int i = 0; i < 100; ++i)
            stepper.step(system, state);
        QVERIFY2(isNear(state.position[0], Vec3(0.0, 1.0, 0.0), 1e-14),
                 told(state.position[0], Vec3(0.0, 1.0, 0.0)));
    }

    void freeTargetKeepsItsSpeed_data() { everyIntegrator(); }

    // Position and previous position move together: a free particle that flies at 3 m/s still
    // does, 0.1 m further on.
    void freeTargetKeepsItsSpeed()
    {
        QFETCH(Integrator, integrator);
        System system = emptySystem(0.01, integrator);
        addParticle(system, Vec3::Zero(), 1.0, {3.0, -1.0, 0.0});
        system.inputs = {moving({0}, {0.0, 0.6, 0.8})};
        finish(system);
        system.start.inputCommand = {0.1};
        const State state = run(system, 100);
        QVERIFY2(isNear(state.velocity[0], Vec3(3.0, -1.0, 0.0), 1e-12),
                 told(state.velocity[0], Vec3(3.0, -1.0, 0.0)));
        QVERIFY2(isNear(state.position[0], Vec3(3.0, -0.94, 0.08), 1e-12),
                 told(state.position[0], Vec3(3.0, -0.94, 0.08)));
    }

    void rate_data()
    {
        QTest::addColumn<double>("timeStep");
        QTest::addColumn<int>("substeps");
        QTest::newRow("100 Hz") << 0.01 << 1;
        QTest::newRow("100 Hz, 4 substeps") << 0.01 << 4;
        QTest::newRow("1000 Hz") << 0.001 << 1;
    }

    // The rate is in simulated time, whatever the time step: 0.5 m/s takes a command of 0.3 m to
    // 0.1 m in 0.2 s and reaches it after 0.6 s, and not beyond.
    void rate()
    {
        QFETCH(double, timeStep);
        QFETCH(int, substeps);
        System system = emptySystem(timeStep);
        system.substeps = substeps;
        addPin(system, Vec3::Zero());
        system.inputs = {moving({0})};
        finish(system);
        system.start.inputCommand = {0.3};
        const auto after = [&](double seconds) {
            return run(system, int(std::lround(seconds / timeStep))).inputValue[0];
        };
        QVERIFY2(isNear(after(0.2), 0.1, 1e-12), told(after(0.2), 0.1));
        QVERIFY2(isNear(after(0.58), 0.29, 1e-12), told(after(0.58), 0.29));
        QVERIFY2(isNear(after(1.0), 0.3, 1e-12), told(after(1.0), 0.3));
    }

    // A command that moves by itself goes at its own rate and stops at the limit, and takes the
    // value along.
    void automatic()
    {
        System system = emptySystem(0.01);
        addPin(system, Vec3::Zero());
        system.inputs = {moving({0})};
        system.inputs[0].automaticRate = -0.2;
        finish(system);
        const State early = run(system, 200);
        QVERIFY2(isNear(early.position[0].x(), -0.4, 1e-12), told(early.position[0].x(), -0.4));
        const State late = run(system, 1000);
        QVERIFY2(isNear(late.position[0].x(), -1.0, 1e-12), told(late.position[0].x(), -1.0));
        QCOMPARE(late.inputCommand[0], -1.0);
    }

    // Several targets go together, and two controls on one target add up.
    void severalTargets()
    {
        System system = emptySystem(0.01);
        for (int i = 0; i < 3; ++i)
            addPin(system, {double(i), 0.0, 0.0});
        system.inputs = {moving({0, 2}), moving({2}, {0.0, 1.0, 0.0})};
        finish(system);
        system.start.inputCommand = {0.2, 0.3};
        const State state = run(system, 100);
        QVERIFY(isNear(state.position[0], Vec3(0.2, 0.0, 0.0), 1e-12));
        QVERIFY(isNear(state.position[1], Vec3(1.0, 0.0, 0.0), 1e-12));
        QVERIFY(isNear(state.position[2], Vec3(2.2, 0.3, 0.0), 1e-12));
    }

    // What hangs on a hand follows it and calms down: the hand does no work beyond the lift.
    void lineFollowsHand()
    {
        System system = emptySystem(1.0 / 240.0, Integrator::Verlet);
        system.substeps = 4;
        system.gravity = {0.0, -standardGravity, 0.0};
        system.viscosity = 1.0;
        addPin(system, Vec3::Zero());
        for (int i = 1; i <= 5; ++i) {
            addParticle(system, {0.0, -0.2 * i, 0.0}, 0.1);
            addRod(system, i - 1, i, 0.2).resists = Resists::Tension;
        }
        system.inputs = {moving({0}, {1.0, 0.0, 0.0})};
        finish(system);
        system.start.inputCommand = {0.5};
        const State state = run(system, 240 * 20);
        QVERIFY2(isNear(state.position[5], Vec3(0.5, -1.0, 0.0), 1e-3),
                 told(state.position[5], Vec3(0.5, -1.0, 0.0)));
    }

    void commands()
    {
        auto system = std::make_shared<System>(emptySystem(0.01));
        addPin(*system, Vec3::Zero());
        system->inputs = {moving({0}), moving({0}, {0.0, 1.0, 0.0})};
        system->inputs[1].key = Key(91);
        finish(*system);
        Simulation simulation(system);
        simulation.command({{90, 0.2}, {12345, 7.0}}); // one that does not exist is let go by
        QCOMPARE(simulation.state().inputCommand, (std::vector<double>{0.2, 0.0}));
        simulation.command({{91, -9.0}}); // beyond the limit, and the other one keeps its place
        QCOMPARE(simulation.state().inputCommand, (std::vector<double>{0.2, -1.0}));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        simulation.command({{90, nan}, {91, std::numeric_limits<double>::infinity()}});
        QCOMPARE(simulation.state().inputCommand, (std::vector<double>{0.2, -1.0}));
        QVERIFY(simulation.runUntil(1.0));
        QCOMPARE(simulation.frame()->inputCommand, (std::vector<double>{0.2, -1.0}));
        QVERIFY(isNear(simulation.frame()->inputValue[0], 0.2, 1e-12));
        QVERIFY(isNear(simulation.frame()->inputValue[1], -0.5, 1e-12));
    }

    // L_i = |p_i - (P0 + delta)|, delta = (0.2, 0, -0.1) m: front rods get shorter and rear ones
    // longer by themselves (validation 1.4).
    void shiftedLengths()
    {
        const System system = pilotInFrame(Solver::GaussSeidel);
        State state = system.start;
        state.inputValue = {0.2, -0.1};
        std::vector<double> length(system.rods.size());
        fillRestLengths(system, state, length);
        const Vec3 shifted = system.start.position[5] + Vec3(0.2, 0.0, -0.1);
        int shorter = 0;
        for (std::size_t r = 0; r < system.rods.size(); ++r) {
            const Rod& rod = system.rods[r];
            const auto corner = std::size_t(rod.a == 5 ? rod.b : rod.a);
            const double expected = (system.start.position[corner] - shifted).norm();
            QVERIFY2(isNear(length[r], expected, 1e-14), told(length[r], expected));
            shorter += length[r] < rod.restLength;
        }
        QCOMPARE(shorter, 2);
        // and the system itself has not been touched: without a shift all is as designed
        fillRestLengths(system, system.start, length);
        for (std::size_t r = 0; r < system.rods.size(); ++r)
            QCOMPARE(length[r], system.rods[r].restLength);
    }

    void pilotShifts_data()
    {
        QTest::addColumn<Solver>("solver");
        for (const Solver solver : solvers)
            QTest::newRow(choiceNames<Solver>[std::size_t(solver)].data()) << solver;
    }

    // The rods carry the pilot to P0 + delta at the rate of the control, and back, without strain.
    void pilotShifts()
    {
        QFETCH(Solver, solver);
        System system = pilotInFrame(solver);
        system.viscosity = 5.0;
        system.start.inputCommand = {0.2, -0.1};
        State state = run(system, 48); // 0.2 s at 0.5 m/s
        QVERIFY2(isNear(state.inputValue[0], 0.1, 1e-12), told(state.inputValue[0], 0.1));
        state = run(system, state, 720);
        const Vec3 expected = system.start.position[5] + Vec3(0.2, 0.0, -0.1);
        QVERIFY2(isNear(state.position[5], expected, 1e-4), told(state.position[5], expected));
        for (const double strain : strains(system, state))
            QVERIFY2(std::abs(strain) < 1e-4, told(strain, 0.0));
        state.inputCommand = {0.0, 0.0};
        state = run(system, state, 720);
        QVERIFY2(isNear(state.position[5], system.start.position[5], 1e-4),
                 told(state.position[5], system.start.position[5]));
    }

    void shiftAndTear_data() { pilotShifts_data(); }

    // Rods that are torn do not come back when the pilot shifts, and a shift alone tears nothing:
    // strain counts from the length that a rod has now.
    void shiftAndTear()
    {
        QFETCH(Solver, solver);
        System system = pilotInFrame(solver);
        system.gravity = {0.0, -standardGravity, 0.0};
        system.sweeps = 60;
        for (Rod& rod : system.rods)
            rod.tear = {TearRule::Strain, 0.02};
        finish(system);
        system.start.inputCommand = {0.3, 0.0};
        State state = run(system, 480);
        QVERIFY(state.tears.empty());

        for (std::size_t r = 0; r < system.rods.size(); ++r) // all but the rod to the middle
            state.rodTorn[r] = system.rods[r].a != 4 && system.rods[r].b != 4;
        state.inputCommand = {-0.3, 0.0};
        state = run(system, state, 2400);
        QCOMPARE(std::count(state.rodTorn.begin(), state.rodTorn.end(), 1), 4);
        QVERIFY(state.tears.empty());
        // left: a pendulum of the length of the one rod
        const double length =
            (system.start.position[4] - system.start.position[5] - Vec3(-0.3, 0.0, 0.0)).norm();
        const double got = (state.position[5] - state.position[4]).norm();
        QVERIFY2(isNear(got, length, 1e-3), told(got, length));
    }
};

const RegisteredTest registered("test_controls", runPlain<TestControls>);

} // namespace ripstop::test_controls
#include "test_controls.moc"
