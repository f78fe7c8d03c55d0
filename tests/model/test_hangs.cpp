// Weights that hang on rods are still. How far they come down and what the rods carry is among the
// cases (verify/hangs.cpp).
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "measure/diagnostics.h"

#include <QtTest>

namespace ripstop::test_hangs {

class TestHangs : public QObject
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
    // What rests in rods rests: no noise from the order in which they are swept.
    void hangIsStill_data()
    {
        allSolvers("still");
        QTest::newRow("still, direct") << Solver::Direct;
    }
    void hangIsStill()
    {
        QFETCH(Solver, solver);
        System system = emptySystem(1.0 / 240.0);
        system.substeps = 4;
        system.gravity = {0.0, -standardGravity, 0.0};
        system.solver = solver;
        system.viscosity = 5.0;
        addPin(system, Vec3::Zero());
        for (int i = 1; i <= 10; ++i) {
            addParticle(system, {0.0, -0.5 * i, 0.0}, i == 10 ? 5.0 : 0.1);
            addRod(system, i - 1, i, 0.5);
        }
        finish(system);
        Stepper stepper;
        State state = run(system, 2400);
        const double tension = state.rodTension[0];
        for (int i = 0; i < 100; ++i) {
            stepper.step(system, state);
            QVERIFY2(isNear(state.rodTension[0], tension, 1e-6 * tension),
                     told(state.rodTension[0], tension));
            for (const Vec3& v : state.velocity)
                QVERIFY2(v.norm() < 1e-6, told(v.norm(), 0.0));
        }
    }
};

const RegisteredTest registered("test_hangs", runPlain<TestHangs>);

} // namespace ripstop::test_hangs
#include "test_hangs.moc"
