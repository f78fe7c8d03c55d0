// Air on fabric of fixed shape (validation A1, A2, A5 to A7, and A4 for the linear-normal law).
#include "model/systems.h"

#include "measure/diagnostics.h"
#include "sim/panel_load.h"

#include <Eigen/Geometry>

#include <QtTest>

#include <numbers>

using namespace ripstop;

namespace {

constexpr double density = 1.225; // kg/m^3

MaterialAir panelOf(AirLaw law, double coefficient, double friction = 0.0)
{
    MaterialAir air;
    air.law = law;
    air.normalCoefficient = coefficient;
    air.skinFriction = friction;
    return air;
}

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
    void terminal_data()
    {
        QTest::addColumn<double>("mass");        // kg
        QTest::addColumn<double>("area");        // m^2
        QTest::addColumn<double>("coefficient"); // 1
        QTest::addColumn<double>("speed");       // m/s
        const auto row = [](const char* name, double mass, double area, double c, double speed) {
            QTest::newRow(name) << mass << area << c << speed;
        };
        row("A1 1 kg, 1 m2, C = 4", 1.0, 1.0, 4.0, 2.000678);
        row("A1 1 kg, 1 m2, C = 2", 1.0, 1.0, 2.0, 2.829387);
        row("A1 1 kg, 1 m2, C = 1.28", 1.0, 1.0, 1.28, 3.536733);
        row("A1 1 kg, 1 m2, C = 1.17", 1.0, 1.0, 1.17, 3.699256);
        row("A1 1 kg, 1 m2, C = 1", 1.0, 1.0, 1.0, 4.001357);
        row("A1 50 g, legs of 1 m, C = 4", 0.05, 0.5, 4.0, 0.63267);
        row("A1 50 g, legs of 1 m, C = 2", 0.05, 0.5, 2.0, 0.89473);
        row("A1 50 g, legs of 1 m, C = 1.17", 0.05, 0.5, 1.17, 1.16981);
        row("A1 100 g, area of a disc of 1 m, C = 1.17", 0.1, std::numbers::pi / 4.0, 1.17,
            1.319986);
    }

    // A triangle that falls flat ends at sqrt(2 m g / (rho C A)), under both laws, to 1e-6.
    void terminal()
    {
        QFETCH(double, mass);
        QFETCH(double, area);
        QFETCH(double, coefficient);
        QFETCH(double, speed);
        for (const AirLaw law : {AirLaw::Paper, AirLaw::LinearNormal}) {
            System system = emptySystem(1.0 / 1000.0);
            system.gravity = {0.0, -standardGravity, 0.0};
            for (const Vec3& corner : triangle(std::sqrt(2.0 * area)))
                addParticle(system, corner, mass / 3.0);
            addPanel(system, 0, 1, 2, law, coefficient);
            finish(system);
            const State state = run(system, 5000);
            for (const Vec3& v : state.velocity) {
                const double digits = speed < 1.2 ? 0.5e-5 : 1e-6; // as printed
                QVERIFY2(isNear(-v.y(), speed, digits), told(-v.y(), speed));
                const double exact =
                    std::sqrt(2.0 * mass * standardGravity / (density * coefficient * area));
                QVERIFY2(isNear(-v.y(), exact, 1e-6), told(-v.y(), exact));
            }
        }
    }

    void broadside_data()
    {
        QTest::addColumn<AirLaw>("law");
        QTest::newRow("A1 broadside, paper") << AirLaw::Paper;
        QTest::newRow("A1 broadside, linear normal") << AirLaw::LinearNormal;
    }

    // F = 1/2 rho C A V^2 along the wind.
    void broadside()
    {
        QFETCH(AirLaw, law);
        const auto [a, b, c] = triangle(1.0);
        const Vec3 got = panelLoad(panelOf(law, 1.17), a, b, c, {0.0, 7.0, 0.0}, density);
        const Vec3 expected(0.0, 0.5 * density * 1.17 * 0.5 * 49.0, 0.0);
        QVERIFY2(isNear(got, expected, 1e-12 * expected.norm()), told(got, expected));
    }

    void incidence_data()
    {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {5.0, 10.0, 30.0, 45.0, 60.0, 90.0})
            QTest::addRow("A4 flat plate at %g degrees", degrees) << degrees;
    }

    // C_N = 4 sin^2 for the paper's law and 2 sin for the plate, as in the table of section 3.6.
    void incidence()
    {
        QFETCH(double, degrees);
        const double alpha = degrees * std::numbers::pi / 180.0;
        const auto [a, b, c] = triangle(1.0);
        const Vec3 wind = 10.0 * Vec3(std::cos(alpha), std::sin(alpha), 0.0);
        const double q = 0.5 * density * 100.0 * 0.5; // N, dynamic pressure x area
        const Vec3 paper = panelLoad(panelOf(AirLaw::Paper, 4.0), a, b, c, wind, density);
        const Vec3 plate = panelLoad(panelOf(AirLaw::LinearNormal, 2.0), a, b, c, wind, density);
        const double s = std::sin(alpha);
        QVERIFY2(isNear(paper / q, Vec3(0.0, 4.0 * s * s, 0.0), 1e-12), told(paper.y() / q, s));
        QVERIFY2(isNear(plate / q, Vec3(0.0, 2.0 * s, 0.0), 1e-12), told(plate.y() / q, s));
    }

    void sign_data()
    {
        QTest::addColumn<AirLaw>("law");
        QTest::newRow("A2 sign, paper") << AirLaw::Paper;
        QTest::newRow("A2 sign, linear normal") << AirLaw::LinearNormal;
    }

    // From either side the force goes with the wind, and winding the corners the other way round
    // changes nothing. With friction, too, the wind never gains energy: F.w >= 0.
    void sign()
    {
        QFETCH(AirLaw, law);
        Dice dice(5);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 a = dice.vector(1.0);
            const Vec3 b = dice.vector(1.0);
            const Vec3 c = dice.vector(1.0);
            const Vec3 wind = dice.vector(10.0);
            const MaterialAir panel = panelOf(law, 2.0, i % 2 ? 0.02 : 0.0);
            const Vec3 load = panelLoad(panel, a, b, c, wind, density);
            QVERIFY(load.dot(wind) >= 0.0);
            const double tolerance = 1e-12 * (1.0 + load.norm());
            QVERIFY(isNear(panelLoad(panel, a, c, b, wind, density), load, tolerance));
            QVERIFY(isNear(panelLoad(panel, a, b, c, -wind, density), -load, tolerance));
        }
    }

    void subdivided_data() { sign_data(); }

    // Four quarters of a triangle carry what the whole one carries, to 1e-12.
    void subdivided()
    {
        QFETCH(AirLaw, law);
        Dice dice(6);
        for (int i = 0; i < 100; ++i) {
            const Vec3 a = dice.vector(1.0);
            const Vec3 b = dice.vector(1.0);
            const Vec3 c = dice.vector(1.0);
            const Vec3 wind = dice.vector(10.0);
            const MaterialAir panel = panelOf(law, 1.3, 0.02);
            const Vec3 ab = 0.5 * (a + b);
            const Vec3 bc = 0.5 * (b + c);
            const Vec3 ca = 0.5 * (c + a);
            const Vec3 whole = panelLoad(panel, a, b, c, wind, density);
            const Vec3 parts = panelLoad(panel, a, ab, ca, wind, density)
                               + panelLoad(panel, ab, b, bc, wind, density)
                               + panelLoad(panel, ca, bc, c, wind, density)
                               + panelLoad(panel, ab, bc, ca, wind, density);
            QVERIFY2(isNear(parts, whole, 1e-12 * (1.0 + whole.norm())), told(parts, whole));
        }
    }

    void withTheWind_data() { sign_data(); }

    // A6: no force on what moves with the wind, and so no change of its motion.
    void withTheWind()
    {
        QFETCH(AirLaw, law);
        const Vec3 wind(3.0, -1.0, 7.0);
        System system = emptySystem(0.01);
        system.wind = wind;
        Dice dice(8);
        for (int i = 0; i < 12; ++i)
            addParticle(system, dice.vector(1.0), 0.01, wind);
        for (int i = 0; i + 2 < 12; ++i)
            addPanel(system, i, i + 1, i + 2, law, 2.0, 0.05);
        finish(system);
        for (const Vec3& load : panelLoads(system, system.start))
            QVERIFY2(load.norm() < 1e-12, told(load.norm(), 0.0));
        for (const Vec3& v : run(system, 100).velocity)
            QVERIFY2(isNear(v, wind, 1e-12), told(v, wind));
    }

    void edgeOn_data() { sign_data(); }

    // A7: along the panel there is no normal force, only skin friction 1/2 rho Cs A V^2.
    void edgeOn()
    {
        QFETCH(AirLaw, law);
        const auto [a, b, c] = triangle(1.0);
        const Vec3 wind(6.0, 0.0, 8.0);
        const Vec3 smooth = panelLoad(panelOf(law, 2.0), a, b, c, wind, density);
        QVERIFY2(smooth.norm() == 0.0, told(smooth.norm(), 0.0));
        const Vec3 rough = panelLoad(panelOf(law, 2.0, 0.01), a, b, c, wind, density);
        const Vec3 expected = 0.5 * density * 0.01 * 0.5 * 10.0 * wind;
        QVERIFY2(isNear(rough, expected, 1e-12), told(rough, expected));
    }

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

QTEST_APPLESS_MAIN(TestAir)
#include "test_air.moc"
