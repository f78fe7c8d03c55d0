// One projection of rods against theory (validation K1, K3 to K6).
#include "model/systems.h"

#include "measure/diagnostics.h"

#include <QtTest>

#include <numbers>
#include <numeric>

using namespace ripstop;

namespace {

struct Projected
{
    std::vector<PaddedVec3> position;
    std::vector<double> multiplier; // kg m
};

// The positions of `system.start` after so many sweeps of its solver, with nothing else done.
Projected project(System system, Solver solver, int sweeps, double h = 1.0)
{
    system.solver = solver;
    system.sweeps = sweeps;
    finish(system);
    std::vector<double> restLength;
    for (const Rod& rod : system.rods)
        restLength.push_back(rod.restLength);
    Projected result{system.start.position, std::vector<double>(system.rods.size(), 0.0)};
    RodSolver rods;
    Crew crew(1);
    const RodTask task{system, solver, sweeps,         {}, system.start.rodTorn, restLength,
                       h,      0,      result.position};
    rods.start(task, system.start.rodTension);
    rods.project(task, crew);
    rods.takeTensions(task, result.multiplier);
    for (double& multiplier : result.multiplier) // so far tensions
        multiplier *= h * h;
    return result;
}

double displacement(int i, double share) // m, of the K1 chain
{
    return 1e-3 * std::sin(std::numbers::pi * i * share);
}

System chain(int nodes, double spacing)
{
    System system = emptySystem(0.01);
    for (int i = 0; i < nodes; ++i) {
        addParticle(system, {spacing * i, 0.0, 0.0}, 1.0);
        if (i > 0)
            addRod(system, i - 1, i, spacing);
    }
    return system;
}

// 20 x 20 particles, 0.1 m apart, 760 structural rods and 361 diagonals, shaken by up to 2 cm.
System shakenCloth()
{
    System system = emptySystem(0.01);
    const int side = 20;
    Dice dice(7);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            addParticle(system, Vec3(0.1 * i, 0.0, 0.1 * j) + dice.vector(0.02), 1.0);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const int here = j * side + i;
            if (i + 1 < side)
                addRod(system, here, here + 1, 0.1);
            if (j + 1 < side)
                addRod(system, here, here + side, 0.1);
            if (i + 1 < side && j + 1 < side)
                addRod(system, here, here + side + 1, 0.1 * std::sqrt(2.0));
        }
    return system;
}

} // namespace

class TestRods : public QObject
{
    Q_OBJECT

    static void allSolvers(const char* what)
    {
        QTest::addColumn<Solver>("solver");
        for (const Solver solver :
             {Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel})
            QTest::addRow("%s, %s", what, choiceNames<Solver>[std::size_t(solver)].data())
                << solver;
    }

private slots:
    void diffusion_data()
    {
        QTest::addColumn<Solver>("solver");
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("factor");
        for (const Solver solver : {Solver::AveragedJacobi, Solver::PaperJacobi}) {
            const char* name = choiceNames<Solver>[std::size_t(solver)].data();
            QTest::addRow("K1 N = 5, %s", name) << solver << 5 << 0.904508;
            QTest::addRow("K1 N = 14, %s", name) << solver << 14 << 0.987464;
            QTest::addRow("K1 N = 15, %s", name) << solver << 15 << 0.989074;
            QTest::addRow("K1 N = 30, %s", name) << solver << 30 << 0.997261;
        }
    }

    // Inside a chain, averaged Jacobi is diffusion with number 1/4: u' = u + (u- - 2 u + u+) / 4.
    // The mode sin(pi i / N), at rest at both ends of N rods, then keeps 1 - (1 - cos(pi/N)) / 2
    // per sweep. The chain is continued beyond the nodes of rest, which stay by symmetry, so that
    // no free end is felt within the ten sweeps.
    void diffusion()
    {
        QFETCH(Solver, solver);
        QFETCH(int, count);
        QFETCH(double, factor);
        const double exact = 1.0 - (1.0 - std::cos(std::numbers::pi / count)) / 2.0;
        QVERIFY(isNear(exact, factor, 1e-6));
        const int margin = 12;
        System system = chain(count + 1 + 2 * margin, 1.0);
        for (int i = 0; i <= count + 2 * margin; ++i)
            system.start.position[std::size_t(i)].x() += displacement(i - margin, 1.0 / count);
        const Projected after = project(system, solver, 10);
        for (int i = 1; i < count; ++i) {
            const double left = after.position[std::size_t(i + margin)].x() - (i + margin);
            const double expected = displacement(i, 1.0 / count) * std::pow(exact, 10);
            QVERIFY2(isNear(left, expected, 1e-12), told(left, expected));
        }
    }

    // Half of the slowest mode is left after the paper's 55 sweeps at N = 14.
    void halfIsLeft()
    {
        const double left = std::pow(1.0 - (1.0 - std::cos(std::numbers::pi / 14)) / 2.0, 55);
        QVERIFY(isNear(left, 0.5, 0.001));
        const int margin = 60;
        System system = chain(15 + 2 * margin, 1.0);
        for (int i = 0; i < 15 + 2 * margin; ++i)
            system.start.position[std::size_t(i)].x() += displacement(i - margin, 1.0 / 14);
        const Projected after = project(system, Solver::AveragedJacobi, 55);
        const double ratio = (after.position[std::size_t(margin + 7)].x() - (margin + 7)) / 1e-3;
        QVERIFY2(isNear(ratio, left, 1e-9), told(ratio, left));
    }

    void pinnedDiffusion_data()
    {
        QTest::addColumn<Solver>("solver");
        QTest::addColumn<int>("count");
        for (const int count : {5, 14, 30})
            for (const Solver solver : {Solver::AveragedJacobi, Solver::PaperJacobi})
                QTest::addRow("K1 between pins, N = %d, %s", count,
                              choiceNames<Solver>[std::size_t(solver)].data())
                    << solver << count;
    }

    // A pin takes no share of a correction, so the last rod pulls its free end twice as hard and
    // counts as half a rod: sin(pi (i - 1/2) / (N - 1)) is the slowest mode between two pins.
    void pinnedDiffusion()
    {
        QFETCH(Solver, solver);
        QFETCH(int, count);
        const double share = 1.0 / (count - 1);
        const double factor = 1.0 - (1.0 - std::cos(std::numbers::pi * share)) / 2.0;
        System system = chain(count + 1, 1.0);
        system.inverseMass.front() = system.inverseMass.back() = 0.0;
        for (int i = 1; i < count; ++i)
            system.start.position[std::size_t(i)].x() +=
                1e-3 * std::sin(std::numbers::pi * (i - 0.5) * share);
        const Projected after = project(system, solver, 10);
        for (int i = 1; i < count; ++i) {
            const double left = after.position[std::size_t(i)].x() - i;
            const double expected =
                1e-3 * std::sin(std::numbers::pi * (i - 0.5) * share) * std::pow(factor, 10);
            QVERIFY2(isNear(left, expected, 1e-12), told(left, expected));
        }
    }

    void momentumOfPath()
    {
        // K3: a - b - c of equal masses, ab stretched by s, bc as it should be. The paper's
        // averaging moves the centre of mass by s / 12 in the first sweep and not again.
        const double s = 0.3;
        System system = emptySystem(0.01);
        for (const double x : {0.0, 1.0 + s, 2.0 + s})
            addParticle(system, {x, 0.0, 0.0}, 1.0);
        addRod(system, 0, 1, 1.0);
        addRod(system, 1, 2, 1.0);
        const auto shift = [&](Solver solver, int sweeps) {
            const Projected after = project(system, solver, sweeps);
            System counted = system;
            finish(counted);
            return std::abs((centerOfMass(counted, after.position)
                             - centerOfMass(counted, system.start.position))
                                .x());
        };
        QVERIFY2(isNear(shift(Solver::PaperJacobi, 1), s / 12.0, 1e-14),
                 told(shift(Solver::PaperJacobi, 1), s / 12.0));
        QVERIFY2(isNear(shift(Solver::PaperJacobi, 55), 0.025, 1e-14),
                 told(shift(Solver::PaperJacobi, 55), 0.025));
        for (const Solver solver : {Solver::AveragedJacobi, Solver::GaussSeidel, Solver::Direct})
            for (const int sweeps : {1, 55})
                QVERIFY2(shift(solver, sweeps) < 1e-14, told(shift(solver, sweeps), 0.0));
    }

    void momentumOfNet_data()
    {
        QTest::addColumn<Solver>("solver");
        QTest::newRow("K3 shaken net, averaged_jacobi") << Solver::AveragedJacobi;
        QTest::newRow("K3 shaken net, gauss_seidel") << Solver::GaussSeidel;
        QTest::newRow("K3 shaken net, direct") << Solver::Direct;
    }
    void momentumOfNet()
    {
        QFETCH(Solver, solver);
        System system = shakenCloth();
        for (std::size_t i = 0; i < system.mass.size(); ++i) {
            system.mass[i] = 0.5 + 0.01 * double(i % 37);
            system.inverseMass[i] = 1.0 / system.mass[i];
        }
        const Projected after = project(system, solver, 55);
        const Vec3 before = centerOfMass(system, system.start.position);
        QVERIFY2(isNear(centerOfMass(system, after.position), before, 1e-14),
                 told(centerOfMass(system, after.position), before));
    }

    void orderOfRods_data()
    {
        QTest::addColumn<Solver>("solver");
        QTest::newRow("K4 order of rods, averaged_jacobi") << Solver::AveragedJacobi;
        QTest::newRow("K4 order of rods, paper_jacobi") << Solver::PaperJacobi;
    }

    // Averaging does not mind in what order the 1121 rods come: 55 sweeps agree to 1e-14 m.
    void orderOfRods()
    {
        QFETCH(Solver, solver);
        System system = shakenCloth();
        QCOMPARE(system.rods.size(), std::size_t(1121));
        const Projected first = project(system, solver, 55);
        Dice dice(3);
        for (int shuffle = 0; shuffle < 3; ++shuffle) {
            for (std::size_t i = system.rods.size(); i > 1; --i)
                std::swap(system.rods[i - 1], system.rods[std::size_t(dice.below(int(i)))]);
            const Projected other = project(system, solver, 55);
            for (std::size_t i = 0; i < first.position.size(); ++i)
                QVERIFY2(isNear(other.position[i], first.position[i], 1e-14),
                         told(other.position[i], first.position[i]));
        }
    }

    void massWeighted_data() { allSolvers("K5 masses 1 and 3"); }
    void massWeighted()
    {
        QFETCH(Solver, solver);
        const double s = 0.2;
        System system = emptySystem(0.01);
        addParticle(system, {0.0, 0.0, 0.0}, 1.0);
        addParticle(system, {1.0 + s, 0.0, 0.0}, 3.0);
        addRod(system, 0, 1, 1.0);
        const Projected after = project(system, solver, 1);
        QVERIFY2(isNear(after.position[0], Vec3(0.75 * s, 0.0, 0.0), 1e-14),
                 told(after.position[0].x(), 0.75 * s));
        QVERIFY2(isNear(after.position[1], Vec3(1.0 + 0.75 * s, 0.0, 0.0), 1e-14),
                 told(after.position[1].x(), 1.0 + 0.75 * s));
    }

    void degenerate_data()
    {
        allSolvers("K6 degenerate");
        QTest::newRow("K6 degenerate, direct") << Solver::Direct;
    }

    // Coincident ends, a particle without rods, two pins, two pins at one place: no NaN, no motion.
    void degenerate()
    {
        QFETCH(Solver, solver);
        System system = emptySystem(0.01);
        addParticle(system, {1.0, 1.0, 1.0}, 1.0); // 0 and 1 coincide
        addParticle(system, {1.0, 1.0, 1.0}, 1.0);
        addRod(system, 0, 1, 0.5);
        addParticle(system, {4.0, 0.0, 0.0}, 1.0); // 2 has no rods
        addPin(system, {5.0, 0.0, 0.0});           // 3 and 4 are pins, 1 m apart
        addPin(system, {6.0, 0.0, 0.0});
        addRod(system, 3, 4, 0.5);
        addPin(system, {6.0, 0.0, 0.0}); // 5 is a pin at the place of 4
        addRod(system, 4, 5, 0.5);
        addRod(system, 4, 5, 0.0);
        system.solver = solver;
        finish(system);
        for (const Integrator integrator :
             {Integrator::ExplicitEuler, Integrator::SemiImplicitEuler, Integrator::Verlet,
              Integrator::VelocityVerlet}) {
            system.integrator = integrator;
            const State after = run(system, 20);
            for (std::size_t i = 0; i < after.position.size(); ++i) {
                QCOMPARE(after.position[i], system.start.position[i]);
                QCOMPARE(after.velocity[i], Vec3(Vec3::Zero()));
            }
            for (const double tension : after.rodTension)
                QCOMPARE(tension, 0.0);
        }
    }

    void oneWay_data()
    {
        QTest::addColumn<Solver>("solver");
        QTest::addColumn<Resists>("resists");
        QTest::addColumn<double>("length"); // m, rest length is 1
        QTest::addColumn<bool>("acts");
        for (const Solver solver :
             {Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel}) {
            const char* name = choiceNames<Solver>[std::size_t(solver)].data();
            QTest::addRow("long line, %s", name) << solver << Resists::Tension << 1.2 << true;
            QTest::addRow("short line, %s", name) << solver << Resists::Tension << 0.8 << false;
            QTest::addRow("long strut, %s", name) << solver << Resists::Compression << 1.2 << false;
            QTest::addRow("short strut, %s", name) << solver << Resists::Compression << 0.8 << true;
        }
    }

    void oneWay()
    {
        QFETCH(Solver, solver);
        QFETCH(Resists, resists);
        QFETCH(double, length);
        QFETCH(bool, acts);
        System system = emptySystem(0.01);
        addParticle(system, Vec3::Zero(), 1.0);
        addParticle(system, {length, 0.0, 0.0}, 1.0);
        addRod(system, 0, 1, 1.0).resists = resists;
        const Projected after = project(system, solver, 5);
        const double got = (after.position[1] - after.position[0]).norm();
        QVERIFY2(isNear(got, acts ? 1.0 : length, 1e-12), told(got, acts ? 1.0 : length));
        QCOMPARE(after.multiplier[0] != 0.0, acts);
    }
};

QTEST_APPLESS_MAIN(TestRods)
#include "test_rods.moc"
