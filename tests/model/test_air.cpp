// Air on panels: who carries the load, and panels without any. What the laws of the air must give
// is among the cases (verify/air.cpp, verify/air_laws.cpp).
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "measure/diagnostics.h"

#include <QtTest>

namespace ripstop::test_air {

namespace {

// A right triangle with two legs of this length in the xz plane.
std::array<Vec3, 3> triangle(double leg)
{
    return {Vec3::Zero(), Vec3(0.0, 0.0, leg), Vec3(leg, 0.0, 0.0)};
}

} // namespace

class TestAir : public QObject
{
    Q_OBJECT

private slots:
    // The corners carry a third each: one explicit step of a second turns load into velocity.
    void thirds()
    {
        System system = emptySystem(1.0, Integrator::ExplicitEuler);
        system.wind = {1.0, 2.0, 3.0};
        for (const Vec3& corner : triangle(0.6))
            addParticle(system, corner, 0.5);
        addPanel(system, 0, 1, 2, AirLaw::LinearNormal, 2.0, 0.02);
        finish(system);
        const Vec3 load = panelLoads(system, system.start)[0];
        QVERIFY(load.norm() > 0.1);
        for (const Vec3& v : run(system, 1).velocity)
            QVERIFY2(isNear(0.5 * v, load / 3.0, 1e-14), told(0.5 * v, load / 3.0));
    }

    // A panel without area, without law or in a calm has no load and does no harm.
    void nothing_data()
    {
        QTest::addColumn<AirLaw>("law");
        QTest::addColumn<double>("leg");  // m
        QTest::addColumn<double>("wind"); // m/s
        QTest::newRow("no law") << AirLaw::None << 1.0 << 10.0;
        QTest::newRow("no area, paper") << AirLaw::Paper << 0.0 << 10.0;
        QTest::newRow("no area, linear normal") << AirLaw::LinearNormal << 0.0 << 10.0;
        QTest::newRow("calm, paper") << AirLaw::Paper << 1.0 << 0.0;
        QTest::newRow("calm, linear normal") << AirLaw::LinearNormal << 1.0 << 0.0;
    }
    void nothing()
    {
        QFETCH(AirLaw, law);
        QFETCH(double, leg);
        QFETCH(double, wind);
        System system = emptySystem(0.01);
        system.wind = {0.0, wind, 0.0};
        for (const Vec3& corner : triangle(leg))
            addParticle(system, corner, 0.1);
        addPanel(system, 0, 1, 2, law, 2.0, 0.02);
        addPanel(system, 0, 1, 1, law, 2.0, 0.02); // two corners are one
        finish(system);
        const State state = run(system, 10);
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(state.position[i], system.start.position[i]);
    }

    // Panels that are gone meet no air and have no area.
    void gone()
    {
        System system = emptySystem(0.01);
        system.wind = {0.0, 10.0, 0.0};
        for (const Vec3& corner : triangle(1.0))
            addParticle(system, corner, 0.1);
        addPanel(system, 0, 1, 2, AirLaw::Paper, 2.0, 0.02);
        finish(system);
        QCOMPARE(fabricArea(system, system.start), 0.5);
        system.start.panelGone[0] = 1;
        QCOMPARE(fabricArea(system, system.start), 0.0);
        QCOMPARE(panelLoads(system, system.start)[0], Vec3(Vec3::Zero()));
        QCOMPARE(run(system, 10).position[1], system.start.position[1]);
    }
};

const RegisteredTest registered("test_air", runPlain<TestAir>);

} // namespace ripstop::test_air
#include "test_air.moc"
