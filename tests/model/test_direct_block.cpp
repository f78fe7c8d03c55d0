// What the direct solver stands on and how it works beside sweeps: which rods are given to it, and
// a heavy line that carries a net.
//
// Stages: designs of rods for some seconds; a direct block beside sweeps; the rule that chooses
// rods; and the order in which rods are numbered.
#include "assembly/finish.h"
#include "model/heavy_line.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "compile/compile.h"
#include "constraints/direct_choice.h"
#include "simulation/simulation.h"

#include <QtTest>

namespace ripstop::test_direct_block {

namespace {

bool inLine(int particle) { return particle <= 100; }

// A net of particles of 20 g that hangs by its left edge on the lower half of a heavy line.
System netOnHeavyLine(int rows, int columns)
{
    System system = heavyLine(65.0, Vec3(0.0, -1.0, 0.0));
    system.solver = Solver::GaussSeidel;
    system.viscosity = 2.0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int here =
                addParticle(system, {0.1 * (column + 1), -0.1 * (row + 46), 0.0}, 0.02);
            addRod(system, column > 0 ? here - 1 : row + 46, here, 0.1);
            if (row > 0)
                addRod(system, here - columns, here, 0.1);
        }
    finish(system);
    return system;
}

// The rods of the line and those that tie the net to it.
std::vector<int> rodsAtLine(const System& system)
{
    std::vector<int> rods;
    for (std::size_t i = 0; i < system.rods.size(); ++i)
        if (inLine(system.rods[i].a) || inLine(system.rods[i].b))
            rods.push_back(int(i));
    return rods;
}

} // namespace

class TestDirectBlock : public QObject
{
    Q_OBJECT

private slots:
    void designs_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"hang_glider", "delta_kite", "parachute", "rope", "stiffened_rod"})
            QTest::addRow("%s", name) << QString(name);
    }

    // Four seconds of every design of rods: no trouble, and no rod off its length by 0.1 %.
    void designs()
    {
        QFETCH(QString, name);
        auto scene = build(*findBuilder(name.toStdString()), {});
        QVERIFY(bool(scene));
        scene->settings.solver = Solver::Direct;
        const auto system = compile(*scene);
        QVERIFY(bool(system));
        Simulation simulation(*system);
        double worst = 0.0;
        for (int i = 1; i <= 60; ++i) {
            QVERIFY(simulation.runUntil(0.1 * i));
            const State& state = simulation.state();
            for (const Rod& rod : simulation.system().rods) {
                const double strain =
                    (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)]).norm()
                        / rod.restLength
                    - 1.0;
                if (rod.resists != Resists::Tension || strain > 0.0)
                    worst = std::max(worst, std::abs(strain));
            }
        }
        QVERIFY2(worst < 1e-3, told(worst, 0.0));
    }

    void coupling_data()
    {
        QTest::addColumn<int>("substeps");
        QTest::addColumn<int>("sweeps");
        QTest::addColumn<double>("quiet"); // share of the tension
        QTest::newRow("4 substeps of 8 sweeps") << 4 << 8 << 1e-6;
        QTest::newRow("20 substeps of a single sweep") << 20 << 1 << 0.01; // the net's weight
    }

    // A block beside sweeps: the line does not give way, the net neither, and the top carries all.
    // Single sweeps in another order each time make what they hold, the net, flicker.
    void coupling()
    {
        QFETCH(int, substeps);
        QFETCH(int, sweeps);
        QFETCH(double, quiet);
        System system = netOnHeavyLine(8, 4);
        system.substeps = substeps;
        system.sweeps = sweeps;
        system.direct.assign(system.rods.size(), 0);
        for (const int rod : rodsAtLine(system))
            system.direct[std::size_t(rod)] = 1;
        State state = system.start;
        Stepper stepper;
        double lineStrain = 0.0;
        double netStrain = 0.0;
        double mean = 0.0; // N, at the top
        double flicker = 0.0;
        const double expected = (65.0 + 99 * 0.001 + 32 * 0.02) * standardGravity;
        for (int step = 0; step < 1200; ++step) {
            stepper.step(system, state);
            for (std::size_t i = 0; i < system.rods.size(); ++i) {
                const Rod& rod = system.rods[i];
                const double length =
                    (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)])
                        .norm();
                double& worst = inLine(rod.a) && inLine(rod.b) ? lineStrain : netStrain;
                worst = std::max(worst, std::abs(length / rod.restLength - 1.0));
                if (rod.a == 0 && step >= 1000) {
                    mean += state.rodTension[i] / 200;
                    flicker = std::max(flicker, std::abs(state.rodTension[i] / expected - 1.0));
                }
            }
        }
        QVERIFY2(isNear(mean, expected, 1e-3 * expected), told(mean, expected));
        QVERIFY2(flicker <= quiet, told(flicker, quiet));
        QVERIFY2(lineStrain < 1e-3, told(lineStrain, 0.0));
        QVERIFY2(netStrain < 2e-2, told(netStrain, 0.0));
    }

    // What the rule of direct_choice.h says of known networks.
    void choice()
    {
        const System alone = netOnHeavyLine(8, 4); // a small frame: 132 particles
        QCOMPARE(rodsForDirect(alone).size(), alone.rods.size());
        const System large = netOnHeavyLine(20, 40); // 900 particles: the line only
        QVERIFY(rodsForDirect(large) == rodsAtLine(large));
        System even = heavyLine(0.001, Vec3(0.0, -1.0, 0.0)); // n^2 / 10 = 1000 sweeps
        finish(even);
        QCOMPARE(rodsForDirect(even).size(), std::size_t(100));
        System brief = directSystem(0.01, 1); // two particles: 1 sweep
        addParticle(brief, Vec3::Zero(), 1.0);
        addParticle(brief, {1.0, 0.0, 0.0}, 1.0);
        addRod(brief, 0, 1, 1.0);
        finish(brief);
        QVERIFY(rodsForDirect(brief).empty());
    }

    // A ring that only lines hold, and that is numbered before them, has no rods of its own.
    void ringBeforeItsLines()
    {
        System system = directSystem(0.01, 1);
        const int ring = addParticle(system, Vec3::Zero(), 0.001);
        int before = ring;
        for (int i = 1; i <= 60; ++i) {
            const int next = addParticle(system, {0.1 * i, 0.0, 0.0}, 0.02);
            addRod(system, before, next, 0.1);
            before = next;
        }
        addRod(system, before, addPin(system, {6.1, 0.0, 0.0}), 0.1);
        finish(system);
        QCOMPARE(rodsForDirect(system).size(), std::size_t(61)); // n^2 / 10 = 360 sweeps
    }
};

const RegisteredTest registered("test_direct_block", runPlain<TestDirectBlock>);

} // namespace ripstop::test_direct_block
#include "test_direct_block.moc"
