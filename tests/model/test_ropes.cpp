// Ropes at rest: the catenary and the rope that stretches under its own weight (validation R1, R2).
#include "model/systems.h"

#include "measure/diagnostics.h"

#include <QtTest>

using namespace ripstop;

class TestRopes : public QObject
{
    Q_OBJECT

private slots:
    void catenary_data()
    {
        QTest::addColumn<Solver>("solver");
        QTest::addColumn<Resists>("resists");
        QTest::newRow("R1 catenary, gauss_seidel") << Solver::GaussSeidel << Resists::Both;
        QTest::newRow("R1 catenary, averaged_jacobi") << Solver::AveragedJacobi << Resists::Both;
        QTest::newRow("R1 catenary of a line, gauss_seidel")
            << Solver::GaussSeidel << Resists::Tension;
        QTest::newRow("R1 catenary of a line, direct") << Solver::Direct << Resists::Tension;
    }

    // 10 m of rope over a span of 8 m: a = H / w = 3.38201879 m from 8 = 2 a asinh(5 / a), sag
    // 2.65437509 m. 40 rods with the mass lumped on the inner nodes, to 1 %. The end rod carries
    // the weight of 39 nodes, so its tension is sqrt(H^2 + (39/80 w L)^2).
    void catenary()
    {
        QFETCH(Solver, solver);
        QFETCH(Resists, resists);
        const int count = 40;
        const double length = 10.0 / count;
        const double perMetre = 0.2; // kg/m
        const double w = perMetre * standardGravity;
        System system = emptySystem(1.0 / 1000.0);
        system.gravity = {0.0, -standardGravity, 0.0};
        system.solver = solver;
        system.sweeps = 60;
        system.viscosity = 3.0;
        for (int i = 0; i <= count; ++i) {
            // a V between the pins has the right length: 4 m and 3 m are the sides of 5 m
            const double x = -4.0 + 8.0 * i / count;
            const Vec3 place(x, -3.0 + 0.75 * std::abs(x), 0.0);
            if (i == 0 || i == count)
                addPin(system, place);
            else
                addParticle(system, place, perMetre * length);
            if (i > 0)
                addRod(system, i - 1, i, length).resists = resists;
        }
        finish(system);
        const State state = run(system, 8000);
        const double sag = -state.position[count / 2].y();
        QVERIFY2(isNear(sag, 2.65437509, 0.01 * 2.65437509), told(sag, 2.65437509));

        const std::vector<double> tension = tensions(system, state);
        for (int i = 0; i < count; ++i) { // the horizontal force is the same everywhere
            const Vec3 along = state.position[std::size_t(i) + 1] - state.position[std::size_t(i)];
            const double horizontal = tension[std::size_t(i)] * along.x() / along.norm() / w;
            QVERIFY2(isNear(horizontal, 3.38201879, 0.01 * 3.38201879),
                     told(horizontal, 3.38201879));
        }
        const double last = tension[0] / w;
        const double expected = std::hypot(3.38201879, 0.5 * 39.0 / 40.0 * 10.0);
        QVERIFY2(isNear(last, expected, 0.01 * expected), told(last, expected));
    }

    void elasticRope_data()
    {
        QTest::addColumn<LinkKind>("kind");
        QTest::addColumn<Solver>("solver");
        QTest::newRow("R2 elastic rope of springs") << LinkKind::Spring << Solver::GaussSeidel;
        QTest::newRow("R2 elastic rope of rods, gauss_seidel")
            << LinkKind::Rod << Solver::GaussSeidel;
        QTest::newRow("R2 elastic rope of rods, averaged_jacobi")
            << LinkKind::Rod << Solver::AveragedJacobi;
        QTest::newRow("R2 elastic rope of rods, direct") << LinkKind::Rod << Solver::Direct;
    }

    // 1 kg, 10 m, EA = 1e4 N, ten links and ten equal masses: dL = M g L / (2 EA) x 11 / 10.
    void elasticRope()
    {
        QFETCH(LinkKind, kind);
        QFETCH(Solver, solver);
        const int count = 10;
        const double stiffness = 1e4 / 1.0; // N/m of a link of 1 m
        System system = emptySystem(1.0 / 2000.0);
        system.gravity = {0.0, -standardGravity, 0.0};
        system.solver = solver;
        system.sweeps = 200;
        addPin(system, Vec3::Zero());
        for (int i = 1; i <= count; ++i) {
            addParticle(system, {0.0, -1.0 * i, 0.0}, 0.1);
            if (kind == LinkKind::Spring)
                addSpring(system, i - 1, i, 1.0, stiffness, 20.0);
            else
                addRod(system, i - 1, i, 1.0, 1.0 / stiffness);
        }
        system.viscosity = 4.0;
        finish(system);
        const State state = run(system, 10000);
        const double got = -state.position[count].y() - 10.0;
        QVERIFY2(isNear(got, 5.393657e-3, 1e-3 * 5.393657e-3), told(got, 5.393657e-3));
        const double top = tensions(system, state)[0];
        QVERIFY2(isNear(top, standardGravity, 1e-3 * standardGravity), told(top, standardGravity));
    }
};

QTEST_APPLESS_MAIN(TestRopes)
#include "test_ropes.moc"
