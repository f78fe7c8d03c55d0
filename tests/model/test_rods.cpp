// Rods that resist one way. What one projection must do otherwise is among the cases
// (verify/rods.cpp).
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "measure/diagnostics.h"

#include <QtTest>

namespace ripstop::test_rods {

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
    ThreadPool pool(1);
    const RodTask task{system, solver, sweeps,         {}, system.start.rodTorn, restLength,
                       h,      0,      result.position};
    rods.start(task, system.start.rodTension);
    rods.project(task, pool);
    rods.takeTensions(task, pool, result.multiplier);
    for (double& multiplier : result.multiplier) // so far tensions
        multiplier *= h * h;
    return result;
}

} // namespace

class TestRods : public QObject
{
    Q_OBJECT

private slots:
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

const RegisteredTest registered("test_rods", runPlain<TestRods>);

} // namespace ripstop::test_rods
#include "test_rods.moc"
