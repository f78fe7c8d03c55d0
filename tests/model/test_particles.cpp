// Single particles against closed forms: projectiles, drag, wind (validation P1 to P4, P6).
#include "model/systems.h"

#include <Eigen/Geometry>

#include <QtTest>

#include <vector>

using namespace ripstop;

namespace {

// A triangle of three free particles that lies across the y axis (or another axis), so that it
// moves along it without turning: the load is spread over the corners in equal parts.
System flatTriangle(double timeStep, Integrator integrator, double mass, double coefficient,
                    const Vec3& across)
{
    System system = emptySystem(timeStep, integrator);
    const Vec3 u = across.unitOrthogonal();
    const Vec3 v = across.cross(u);
    addParticle(system, Vec3::Zero(), mass / 3.0); // right triangle, legs 1 m: 0.5 m^2
    addParticle(system, u, mass / 3.0);
    addParticle(system, v, mass / 3.0);
    addPanel(system, 0, 1, 2, AirLaw::Paper, coefficient);
    return system;
}

} // namespace

class TestParticles : public QObject
{
    Q_OBJECT

private slots:
    void projectile_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<double>("late"); // y error as a share of g t dt / 2
        QTest::addColumn<double>("tolerance");
        QTest::newRow("P1 Verlet") << Integrator::Verlet << 0.0 << 1e-12;
        QTest::newRow("P1 velocity Verlet") << Integrator::VelocityVerlet << 0.0 << 1e-12;
        QTest::newRow("P1 semi-implicit Euler") << Integrator::SemiImplicitEuler << -1.0 << 1e-9;
        QTest::newRow("P1 explicit Euler") << Integrator::ExplicitEuler << 1.0 << 1e-9;
    }

    // v0 = 20 m/s at 45 degrees: flight time 2 v0 sin / g, range v0^2 / g, apex v0^2 sin^2 / 2 g.
    // Summing n steps by hand, the Euler schemes end g t dt / 2 too low or too high.
    void projectile()
    {
        QFETCH(Integrator, integrator);
        QFETCH(double, late);
        QFETCH(double, tolerance);
        const double flight = 2.88419300;
        const double range = 40.78864852;
        const double apex = 10.19716213;
        const double speed = 20.0 * std::sqrt(0.5);
        QVERIFY2(isNear(2.0 * speed / standardGravity, flight, 1e-8), "the page's flight time");

        const int steps = 288;
        const double exactFlight = 2.0 * speed / standardGravity;
        System system = emptySystem(exactFlight / steps, integrator);
        system.gravity = {0.0, -standardGravity, 0.0};
        addParticle(system, Vec3::Zero(), 1.0, {speed, speed, 0.0});
        finish(system);

        const double lag = late * standardGravity * system.timeStep / 2.0; // m per s of flight
        const State top = run(system, steps / 2);
        const State end = run(system, top, steps / 2);
        const double exactApex = 20.0 * 20.0 * 0.5 / (2.0 * standardGravity);
        QVERIFY(isNear(exactApex, apex, 1e-8));
        QVERIFY2(
            isNear(top.position[0].y(), exactApex + lag * exactFlight / 2.0, tolerance * exactApex),
            told(top.position[0].y(), exactApex));
        QVERIFY2(isNear(end.position[0].y(), lag * exactFlight, tolerance * exactApex),
                 told(end.position[0].y(), lag * exactFlight));
        QVERIFY2(isNear(end.position[0].x(), range, 1e-8), told(end.position[0].x(), range));
        QVERIFY2(isNear(end.time, exactFlight, 1e-12), told(end.time, exactFlight));
    }

    void projectileLag_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<double>("error"); // m
        QTest::newRow("P1 semi-implicit Euler 9.8 cm low")
            << Integrator::SemiImplicitEuler << -0.0980665;
        QTest::newRow("P1 explicit Euler 9.8 cm high") << Integrator::ExplicitEuler << 0.0980665;
    }

    // The page's own figures: t = 2 s, dt = 0.01 s.
    void projectileLag()
    {
        QFETCH(Integrator, integrator);
        QFETCH(double, error);
        System system = emptySystem(0.01, integrator);
        system.gravity = {0.0, -standardGravity, 0.0};
        addParticle(system, Vec3::Zero(), 1.0, {20.0, 20.0, 0.0});
        finish(system);
        const double exact = 40.0 - 0.5 * standardGravity * 4.0;
        const double got = run(system, 200).position[0].y() - exact;
        QVERIFY2(isNear(got, error, 1e-9), told(got, error));
    }

    // p0 + v0 t + a t^2 / 2. The first paper's form has half the way of v0 only.
    void constantForce_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("P2 Verlet") << Integrator::Verlet;
        QTest::newRow("P2 velocity Verlet") << Integrator::VelocityVerlet;
    }

    void constantForce()
    {
        QFETCH(Integrator, integrator);
        const Vec3 p0(1.0, -2.0, 0.5);
        const Vec3 v0(3.0, 1.0, -4.0);
        System system = emptySystem(0.01, integrator);
        system.gravity = {0.5, -1.0, 2.0};
        addParticle(system, p0, 2.5, v0);
        finish(system);
        const double t = 3.0;
        const Vec3 got = run(system, 300).position[0];
        const Vec3 expected = p0 + v0 * t + 0.5 * t * t * system.gravity;
        QVERIFY2(isNear(got, expected, 1e-12 * expected.norm()), told(got, expected));
        const Vec3 paper = p0 + 0.5 * t * (v0 + t * system.gravity);
        QVERIFY2(isNear(got - paper, 0.5 * t * v0, 1e-11), told(got - paper, 0.5 * t * v0));
    }

    void masses_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("P3 explicit Euler") << Integrator::ExplicitEuler;
        QTest::newRow("P3 semi-implicit Euler") << Integrator::SemiImplicitEuler;
        QTest::newRow("P3 Verlet") << Integrator::Verlet;
        QTest::newRow("P3 velocity Verlet") << Integrator::VelocityVerlet;
    }

    void masses()
    {
        QFETCH(Integrator, integrator);
        System system = emptySystem(0.01, integrator);
        system.gravity = {0.0, -standardGravity, 0.0};
        for (const double mass : {0.1, 1.0, 60.0})
            addParticle(system, Vec3::Zero(), mass);
        finish(system);
        const State state = run(system, 200);
        for (const std::size_t i : {1u, 2u})
            QVERIFY2(isNear(state.position[i], state.position[0], 1e-15 * state.position[0].norm()),
                     told(state.position[i], state.position[0]));
    }

    void quadraticDrag_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<double>("order");
        QTest::newRow("P4 explicit Euler") << Integrator::ExplicitEuler << 1.0;
        QTest::newRow("P4 semi-implicit Euler") << Integrator::SemiImplicitEuler << 1.0;
        QTest::newRow("P4 Verlet") << Integrator::Verlet << 2.0;
        QTest::newRow("P4 velocity Verlet") << Integrator::VelocityVerlet << 2.0;
    }

    // Fall against quadratic drag: v = vt tanh(g t / vt), y = vt^2 / g ln cosh(g t / vt), with
    // vt = 5.294 m/s. The error must shrink with the order of the scheme, and vanish.
    void quadraticDrag()
    {
        QFETCH(Integrator, integrator);
        QFETCH(double, order);
        const double terminal = 5.294;
        const double mass = 1.225 * 2.0 * 0.5 * terminal * terminal / (2.0 * standardGravity);
        const std::vector<double> expected{5.039741, 3.382521, 5.287594, 8.608784};

        std::vector<double> error[2];
        for (const int refined : {0, 1}) {
            const int perSecond = 1000 << refined;
            System system =
                flatTriangle(1.0 / perSecond, integrator, mass, 2.0, Vec3(0.0, 1.0, 0.0));
            system.gravity = {0.0, -standardGravity, 0.0};
            finish(system);
            const State one = run(system, perSecond);
            const State two = run(system, one, perSecond);
            const double y0 = system.start.position[0].y();
            const std::vector<double> got{-one.velocity[0].y(), y0 - one.position[0].y(),
                                          -two.velocity[0].y(), y0 - two.position[0].y()};
            for (std::size_t i = 0; i < got.size(); ++i) {
                const double t = i < 2 ? 1.0 : 2.0;
                const double exact =
                    i % 2 == 0 ? terminal * std::tanh(standardGravity * t / terminal)
                               : terminal * terminal / standardGravity
                                     * std::log(std::cosh(standardGravity * t / terminal));
                QVERIFY2(isNear(exact, expected[i], 1e-6), told(exact, expected[i]));
                error[refined].push_back(std::abs(got[i] - exact));
                // one step's share of the largest acceleration, or its square
                const double bound = std::pow(standardGravity / terminal / perSecond, order);
                QVERIFY2(error[refined].back() < bound * 4.0 * terminal, told(got[i], exact));
            }
        }
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const double measured = std::log2(error[0][i] / error[1][i]);
            QVERIFY2(isNear(measured, order, 0.1), told(measured, order));
        }
    }

    // 90 % of the terminal speed after vt / g artanh 0.9.
    void ninetyPercent()
    {
        const double terminal = 5.294;
        const double mass = 1.225 * 2.0 * 0.5 * terminal * terminal / (2.0 * standardGravity);
        System system =
            flatTriangle(1e-4, Integrator::VelocityVerlet, mass, 2.0, Vec3(0.0, 1.0, 0.0));
        system.gravity = {0.0, -standardGravity, 0.0};
        finish(system);
        Stepper stepper;
        State state = system.start;
        double before = 0.0;
        while (-state.velocity[0].y() < 0.9 * terminal) {
            before = -state.velocity[0].y();
            stepper.step(system, state);
        }
        const double after = -state.velocity[0].y();
        const double time =
            state.time - system.timeStep * (after - 0.9 * terminal) / (after - before);
        QVERIFY2(isNear(time, 0.79476, 5e-6), told(time, 0.79476));
    }

    void drift_data()
    {
        QTest::addColumn<double>("wind"); // m/s
        QTest::addColumn<double>("time"); // s
        QTest::newRow("P6 light wind") << 2.0 << 3.0;
        QTest::newRow("P6 strong wind") << 12.0 << 1.0;
        QTest::newRow("P6 wind from the other side") << -6.0 << 2.0;
    }

    // Released at rest in wind W, a plate drifts W t - lam ln(1 + W t / lam), lam = 2 m / rho C A,
    // and its speed tends to W from below.
    void drift()
    {
        QFETCH(double, wind);
        QFETCH(double, time);
        const double mass = 0.2;
        const double length = 2.0 * mass / (1.225 * 1.2 * 0.5);
        const int steps = 4000;
        System system =
            flatTriangle(time / steps, Integrator::VelocityVerlet, mass, 1.2, Vec3(1.0, 0.0, 0.0));
        system.wind = {wind, 0.0, 0.0};
        finish(system);
        const State state = run(system, steps);
        const double way = std::abs(wind) * time;
        const double expected = way - length * std::log1p(way / length);
        const double got = std::abs((state.position[0] - system.start.position[0]).x());
        QVERIFY2(isNear(got, expected, 1e-6 * expected), told(got, expected));
        const double speed = std::abs(state.velocity[0].x());
        const double left = std::abs(wind) / (1.0 + way / length);
        QVERIFY2(isNear(speed, std::abs(wind) - left, 1e-6 * std::abs(wind)),
                 told(speed, std::abs(wind) - left));
        QVERIFY(state.velocity[0].x() * wind > 0.0);
    }
};

QTEST_APPLESS_MAIN(TestParticles)
#include "test_particles.moc"
