// What the direct solver stands on and how it works beside sweeps: its factorisation, which rods
// are given to it, and a heavy line that carries a net.
//
// Stages: the factorisation against a dense one; then designs of rods for some seconds; a direct
// block beside sweeps; the rule that chooses rods; and the order in which rods are numbered.
#include "assembly/finish.h"
#include "model/heavy_line.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "compile/compile.h"
#include "constraints/block_cholesky.h"
#include "constraints/direct_choice.h"
#include "simulation/simulation.h"

#include <Eigen/Cholesky>

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
    // The block factorisation equals a dense factorisation of the same matrix.
    void blockCholesky()
    {
        const int nodes = 20;
        Dice dice(5);
        std::vector<std::pair<int, int>> pairs;
        for (int k = 0; k < 60; ++k) {
            const int i = dice.below(nodes);
            pairs.emplace_back(i, (i + 1 + dice.below(nodes - 1)) % nodes);
        }
        BlockCholesky matrix;
        matrix.analyze(nodes, pairs);
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
        const auto add = [&](BlockCholesky::Block& block, int i, int j, const Eigen::Matrix3d& m) {
            for (int c = 0; c < 3; ++c)
                for (int r = 0; r < 3; ++r)
                    block.column[c][r] += m(r, c);
            dense.block<3, 3>(3 * i, 3 * j) += m;
            if (i != j)
                dense.block<3, 3>(3 * j, 3 * i) += m;
        };
        ThreadPool one(1);
        matrix.setZero(one);
        for (int i = 0; i < nodes; ++i)
            add(matrix.diagonal(std::size_t(i)), i, i,
                dice(0.5, 2.0) * Eigen::Matrix3d::Identity());
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const Vec3 n = dice.vector(1.0);
            const Eigen::Matrix3d block = n * n.transpose();
            const auto [i, j] = pairs[k];
            add(matrix.diagonal(std::size_t(i)), i, i, block);
            add(matrix.diagonal(std::size_t(j)), j, j, block);
            add(matrix.pair(k), i, j, -block);
        }
        std::vector<Row> x(nodes);
        Eigen::VectorXd right(3 * nodes);
        for (int i = 0; i < nodes; ++i)
            for (int c = 0; c < 3; ++c)
                x[std::size_t(i)].v[c] = right[3 * i + c] = dice(-1.0, 1.0);
        QVERIFY(matrix.factorize(one));
        matrix.solve(x);
        const Eigen::VectorXd expected = dense.llt().solve(right);
        for (int i = 0; i < nodes; ++i)
            for (int c = 0; c < 3; ++c)
                QVERIFY2(isNear(x[std::size_t(i)].v[c], expected[3 * i + c], 1e-12),
                         told(x[std::size_t(i)].v[c], expected[3 * i + c]));
    }

    // Threads share the columns, and whoever takes one gathers it in the same order.
    void blockCholeskyOfManyThreads()
    {
        const int side = 40;
        std::vector<std::pair<int, int>> pairs; // of a net with one diagonal
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                for (const auto& [down, along] :
                     {std::pair(0, 1), std::pair(1, 0), std::pair(1, 1)})
                    if (row + down < side && column + along < side)
                        pairs.emplace_back(row * side + column,
                                           (row + down) * side + column + along);
        BlockCholesky matrix;
        matrix.analyze(side * side, pairs);
        const auto fill = [&](ThreadPool& pool, double ground) {
            Dice dice(3);
            matrix.setZero(pool);
            const auto add = [](BlockCholesky::Block& block, const Eigen::Matrix3d& m) {
                for (int c = 0; c < 3; ++c)
                    for (int r = 0; r < 3; ++r)
                        block.column[c][r] += m(r, c);
            };
            for (std::size_t i = 0; i < std::size_t(side * side); ++i)
                add(matrix.diagonal(i), ground * Eigen::Matrix3d::Identity());
            for (std::size_t k = 0; k < pairs.size(); ++k) {
                const Vec3 n = dice.vector(1.0);
                add(matrix.diagonal(std::size_t(pairs[k].first)), n * n.transpose());
                add(matrix.diagonal(std::size_t(pairs[k].second)), n * n.transpose());
                add(matrix.pair(k), -n * n.transpose());
            }
        };
        std::vector<Row> expected;
        for (const int threads : {1, 2, 4}) {
            ThreadPool pool(threads);
            for (int time = 0; time < 20; ++time) {
                fill(pool, 0.01);
                QVERIFY(matrix.factorize(pool));
                std::vector<Row> x(std::size_t(side * side), Row{{1.0, -2.0, 3.0, 0.0}});
                matrix.solve(x);
                if (expected.empty())
                    expected = x;
                for (std::size_t i = 0; i < x.size(); ++i)
                    for (int c = 0; c < 3; ++c)
                        QCOMPARE(x[i].v[c], expected[i].v[c]);
            }
            fill(pool, -8.0); // nobody waits for ever for a column that cannot be
            QVERIFY(!matrix.factorize(pool));
        }
    }

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
