// The undamped and the damped oscillator against theory (validation I1 to I10, S1 to S3).
//
// Of the schemes on the validation page the engine offers five: explicit Euler (I1), semi-implicit
// Euler (I3), Verlet with the correct start (I4), Verlet with the naive start (I5, by presetting
// what it remembers) and velocity Verlet (I6). Implicit Euler (I2), implicit midpoint and RK4 (I7)
// are not offered, so they have no row.
#include "model/systems.h"

#include "measure/diagnostics.h"

#include <QtTest>

#include <numbers>
#include <vector>

using namespace ripstop;

namespace {

constexpr double omega = 2.0 * std::numbers::pi; // 1/s

enum class Scheme { ExplicitEuler, SemiImplicitEuler, Verlet, NaiveVerlet, VelocityVerlet };

Integrator integratorOf(Scheme scheme)
{
    switch (scheme) {
    case Scheme::ExplicitEuler:
        return Integrator::ExplicitEuler;
    case Scheme::SemiImplicitEuler:
        return Integrator::SemiImplicitEuler;
    case Scheme::Verlet:
    case Scheme::NaiveVerlet:
        return Integrator::Verlet;
    case Scheme::VelocityVerlet:
        break;
    }
    return Integrator::VelocityVerlet;
}

// A particle of 1 kg on a spring without rest length, pinned at `anchor`: F = -k x in all
// directions and at any amplitude. x0 = 1 m, v0 = 0.
System oscillator(Scheme scheme, double timeStep, double frequency = omega, double damping = 0.0,
                  const Vec3& anchor = Vec3::Zero())
{
    System system = emptySystem(timeStep, integratorOf(scheme));
    addPin(system, anchor);
    addParticle(system, anchor + Vec3(1.0, 0.0, 0.0), 1.0);
    addSpring(system, 0, 1, 0.0, frequency * frequency, damping);
    finish(system);
    if (scheme == Scheme::NaiveVerlet) { // previous position = x0 - v0 dt
        system.start.started = true;
        system.start.drift = system.start.velocity;
    }
    return system;
}

// x, and the velocity as the page measures it: the central difference for Verlet.
struct Motion
{
    std::vector<double> x; // [steps + 1] m
    std::vector<double> v; // [steps + 1] m/s
};

Motion follow(const System& system, int steps)
{
    Motion motion;
    Stepper stepper;
    State state = system.start;
    const bool verlet = system.integrator == Integrator::Verlet;
    for (int i = 0; i <= steps; ++i) {
        motion.x.push_back(state.position[1].x());
        const double drift = state.drift[1].x();
        motion.v.push_back(state.velocity[1].x());
        stepper.step(system, state);
        if (verlet && i > 0)
            motion.v.back() = 0.5 * (drift + state.drift[1].x());
    }
    return motion;
}

double energy(const Motion& motion, std::size_t i)
{
    return 0.5 * motion.v[i] * motion.v[i] + 0.5 * omega * omega * motion.x[i] * motion.x[i];
}

} // namespace

Q_DECLARE_METATYPE(Scheme)

class TestOscillator : public QObject
{
    Q_OBJECT

private slots:
    void energyRatio_data()
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::addColumn<double>("ratio");
        QTest::newRow("I1 explicit Euler energy ratio") << Scheme::ExplicitEuler << 51.4222;
        QTest::newRow("I3 semi-implicit Euler energy ratio")
            << Scheme::SemiImplicitEuler << 0.99935;
        QTest::newRow("I4 Verlet energy ratio") << Scheme::Verlet << 0.9999998945;
        QTest::newRow("I5 Verlet with naive start energy ratio") << Scheme::NaiveVerlet << 1.00099;
        QTest::newRow("I6 velocity Verlet energy ratio") << Scheme::VelocityVerlet << 0.9999998945;
    }

    // E/E0 after ten periods of 100 steps, to 1e-6 where the page has the digits.
    void energyRatio()
    {
        QFETCH(Scheme, scheme);
        QFETCH(double, ratio);
        const Motion motion = follow(oscillator(scheme, 0.01), 1000);
        const double got = energy(motion, 1000) / energy(motion, 0);
        const double digits =
            scheme == Scheme::Verlet || scheme == Scheme::VelocityVerlet ? 1e-6 : 0.5e-5;
        QVERIFY2(isNear(got, ratio, digits * std::max(1.0, ratio)), told(got, ratio));

        // What the recurrences give in closed form with cos(theta) = 1 - h^2/2, to 1e-6.
        const double h = omega * 0.01;
        const double theta = 2.0 * std::asin(h / 2.0);
        const double n = 1000.0;
        double x = 0.0;
        double v = 0.0; // over omega
        switch (scheme) {
        case Scheme::ExplicitEuler:
            x = std::pow(1.0 + h * h, n / 2.0); // all of the amplitude; phase does not matter
            break;
        case Scheme::SemiImplicitEuler: // x(1) = 1 - h^2, v(n) = (x(n) - x(n-1)) / dt
            x = std::cos((n + 0.5) * theta) / std::cos(0.5 * theta);
            v = (x - std::cos((n - 0.5) * theta) / std::cos(0.5 * theta)) / h;
            break;
        case Scheme::Verlet:
        case Scheme::VelocityVerlet:
            x = std::cos(n * theta);
            v = -std::sin(n * theta) * std::sin(theta) / h;
            break;
        case Scheme::NaiveVerlet:
            x = std::cos((n + 0.5) * theta) / std::cos(0.5 * theta);
            v = -std::sin((n + 0.5) * theta) / std::cos(0.5 * theta) * std::sin(theta) / h;
            break;
        }
        const double theory = x * x + v * v;
        QVERIFY2(isNear(got, theory, 1e-6 * theory), told(got, theory));
    }

    void order_data()
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::addColumn<double>("order");
        QTest::newRow("I1 explicit Euler order") << Scheme::ExplicitEuler << 1.02;
        QTest::newRow("I3 semi-implicit Euler order") << Scheme::SemiImplicitEuler << 1.007;
        QTest::newRow("I4 Verlet order") << Scheme::Verlet << 2.000;
        QTest::newRow("I5 Verlet with naive start order") << Scheme::NaiveVerlet << 1.005;
        QTest::newRow("I6 velocity Verlet order") << Scheme::VelocityVerlet << 2.000;
    }

    // Norm of the error in (x, v / omega) at t = 1.1 s, where x is far from zero.
    void order()
    {
        QFETCH(Scheme, scheme);
        QFETCH(double, order);
        const auto error = [&](int perSecond, bool own) {
            const int steps = perSecond * 11 / 10;
            const System system = oscillator(scheme, 1.0 / perSecond);
            const Motion motion = follow(system, steps);
            const double v = own ? run(system, steps).velocity[1].x() : motion.v.back();
            return std::hypot(motion.x.back() - std::cos(omega * 1.1),
                              v / omega + std::sin(omega * 1.1));
        };
        const double measured = std::log2(error(400, false) / error(800, false));
        QVERIFY2(isNear(measured, order, 0.1), told(measured, order));
        // the velocity that the engine reports has the order of the scheme, too
        const double reported = std::log2(error(400, true) / error(800, true));
        QVERIFY2(isNear(reported, order, 0.1), told(reported, order));
    }

    void bounded_data()
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::addColumn<double>("lowest");
        QTest::addColumn<double>("highest");
        QTest::newRow("I3 semi-implicit Euler energy band")
            << Scheme::SemiImplicitEuler << 0.9695 << 1.0324;
        QTest::newRow("I6 velocity Verlet energy band")
            << Scheme::VelocityVerlet << 0.999013 << 1.0;
    }

    // 1000 periods: the energy swings in a band and does not leave it.
    void bounded()
    {
        QFETCH(Scheme, scheme);
        QFETCH(double, lowest);
        QFETCH(double, highest);
        const Motion motion = follow(oscillator(scheme, 0.01), 100000);
        double low = 1.0;
        double high = 0.0;
        for (std::size_t i = 0; i < motion.x.size(); ++i) {
            low = std::min(low, energy(motion, i) / energy(motion, 0));
            high = std::max(high, energy(motion, i) / energy(motion, 0));
        }
        const double digit = scheme == Scheme::VelocityVerlet ? 0.5e-6 : 0.5e-4;
        QVERIFY2(isNear(low, lowest, digit), told(low, lowest));
        QVERIFY2(isNear(high, highest, digit), told(high, highest));
    }

    // Invariants of the recurrences: exactly kept, to 1e-12.
    void invariants()
    {
        const double h = omega * 0.01;
        const Motion euler = follow(oscillator(Scheme::SemiImplicitEuler, 0.01), 1000);
        const Motion verlet = follow(oscillator(Scheme::Verlet, 0.01), 1000);
        const Motion second = follow(oscillator(Scheme::VelocityVerlet, 0.01), 1000);
        const auto eulerKeeps = [&](std::size_t i) {
            const double x = euler.x[i];
            const double v = euler.v[i];
            return v * v + omega * omega * x * x - omega * omega * 0.01 * x * v;
        };
        const auto verletKeeps = [&](std::size_t i) {
            const double x = verlet.x[i];
            const double y = verlet.x[i + 1];
            return x * x + y * y - 2.0 * (1.0 - h * h / 2.0) * x * y;
        };
        const auto secondKeeps = [&](std::size_t i) {
            return second.v[i] * second.v[i]
                   + omega * omega * second.x[i] * second.x[i] * (1.0 - h * h / 4.0);
        };
        for (const std::size_t i : {1u, 17u, 500u, 999u}) {
            QVERIFY2(isNear(eulerKeeps(i) / eulerKeeps(0), 1.0, 1e-12), "I3 semi-implicit Euler");
            QVERIFY2(isNear(verletKeeps(i) / verletKeeps(0), 1.0, 1e-10), "I4 Verlet");
            QVERIFY2(isNear(secondKeeps(i) / secondKeeps(0), 1.0, 1e-12), "I6 velocity Verlet");
        }
    }

    void period_data()
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::newRow("I3 semi-implicit Euler numerical period") << Scheme::SemiImplicitEuler;
        QTest::newRow("I4 Verlet numerical period") << Scheme::Verlet;
        QTest::newRow("I6 velocity Verlet numerical period") << Scheme::VelocityVerlet;
    }

    // T = 2 pi dt / theta; the angle of one step from x(n+1) + x(n-1) = 2 cos(theta) x(n).
    void period()
    {
        QFETCH(Scheme, scheme);
        const Motion motion = follow(oscillator(scheme, 0.01), 1002);
        double products = 0.0; // least squares over ten periods
        double squares = 0.0;
        for (std::size_t i = 1; i <= 1000; ++i) {
            // difference form: 1 - cos(theta) would lose its digits in x + x
            products += motion.x[i] * (2.0 * motion.x[i] - motion.x[i + 1] - motion.x[i - 1]);
            squares += motion.x[i] * motion.x[i];
        }
        const double theta = 2.0 * std::asin(0.5 * std::sqrt(products / squares));
        const double got = omega * 0.01 / theta;
        QVERIFY2(isNear(got, 0.9998354606, 1e-9), told(got, 0.9998354606));
    }

    // The second paper's recurrence 2 (x - previous) + a dt^2 would give 0, -2, -4, -4, 0, 8, ...
    void restStaysAtRest_data() { allSchemes("I8 rest stays at rest"); }
    void restStaysAtRest()
    {
        QFETCH(Scheme, scheme);
        System system = emptySystem(0.01, integratorOf(scheme));
        addParticle(system, {1.0, 1.0, 1.0}, 1.0);
        finish(system);
        system.start.started = scheme == Scheme::NaiveVerlet;
        QCOMPARE(run(system, 8).position[0], Vec3(1.0, 1.0, 1.0));
    }

    void stability_data()
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::newRow("I9 semi-implicit Euler") << Scheme::SemiImplicitEuler;
        QTest::newRow("I9 Verlet") << Scheme::Verlet;
        QTest::newRow("I9 velocity Verlet") << Scheme::VelocityVerlet;
    }

    // h = 1.99 stays below 1 / sqrt(1 - h^2/4) = 10.01, h = 2.01 grows without end.
    void stability()
    {
        QFETCH(Scheme, scheme);
        const auto largest = [&](double h) {
            double most = 0.0;
            for (const double x : follow(oscillator(scheme, h / omega), 2000).x)
                most = std::max(most, std::abs(x));
            return most;
        };
        QVERIFY2(largest(1.99) <= 10.1, told(largest(1.99), 10.01));
        QVERIFY(largest(2.01) > 1e100);
    }

    void translation_data() { allSchemes("I10 moved by a kilometre"); }
    void translation()
    {
        QFETCH(Scheme, scheme);
        const Vec3 far(1e3, -1e3, 1e3);
        const Vec3 near = run(oscillator(scheme, 0.01), 1000).position[1];
        const Vec3 moved = run(oscillator(scheme, 0.01, omega, 0.0, far), 1000).position[1];
        QVERIFY2(isNear(moved - far, near, 1e-7), told(moved - far, near));
    }

    // zeta = 0.1: a damped period of 1.00503782 s, in which the amplitude falls to 0.53180208.
    // The scheme's own period is off by h^2/24 = 1.6e-8 at this step.
    void dampedPeriod_data()
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::newRow("S1 Verlet") << Scheme::Verlet;
        QTest::newRow("S1 velocity Verlet") << Scheme::VelocityVerlet;
    }
    void dampedPeriod()
    {
        QFETCH(Scheme, scheme);
        const double damped = 1.00503782;
        const double dt = 1e-4;
        const Motion motion = follow(oscillator(scheme, dt, omega, 2.0 * 0.1 * omega), 21000);
        // turning points: where the velocity falls through zero
        std::vector<double> time{0.0};
        std::vector<double> height{1.0};
        for (std::size_t i = 1; i + 1 < motion.v.size(); ++i)
            if (motion.v[i] > 0.0 && motion.v[i + 1] <= 0.0) {
                const double part = motion.v[i] / (motion.v[i] - motion.v[i + 1]);
                time.push_back((double(i) + part) * dt);
                height.push_back(motion.x[i] + 0.5 * part * motion.v[i] * dt);
            }
        QCOMPARE(time.size(), std::size_t(3));
        for (const std::size_t i : {1u, 2u}) {
            QVERIFY2(isNear(time[i] - time[i - 1], damped, 1e-6 * damped),
                     told(time[i] - time[i - 1], damped));
            const double ratio = height[i] / height[i - 1];
            QVERIFY2(isNear(ratio, 0.53180208, 1e-6), told(ratio, 0.53180208));
            QVERIFY2(isNear(-std::log(ratio), 0.63148388, 2e-6),
                     told(-std::log(ratio), 0.63148388));
        }
    }

    void dampedLimit_data()
    {
        QTest::addColumn<double>("damping"); // 1/s
        QTest::addColumn<double>("limit");   // s
        QTest::newRow("S2 c = 0") << 0.0 << 0.200000;
        QTest::newRow("S2 c = 1") << 1.0 << 0.190250;
        QTest::newRow("S2 c = 5") << 5.0 << 0.156155;
        QTest::newRow("S2 c = 20") << 20.0 << 0.082843;
    }

    // Semi-implicit Euler is stable while (w dt)^2 + 2 c dt < 4; w = 10 here.
    void dampedLimit()
    {
        QFETCH(double, damping);
        QFETCH(double, limit);
        const double exact = (-damping + std::sqrt(damping * damping + 400.0)) / 100.0;
        QVERIFY(isNear(exact, limit, 1e-6));
        const auto amplitude = [&](double dt) { // after 20 000 steps, or a kilometre
            const System system = oscillator(Scheme::SemiImplicitEuler, dt, 10.0, damping);
            Stepper stepper;
            State state = system.start;
            for (int i = 0; i < 20000 && std::abs(state.position[1].x()) < 1e3; ++i)
                stepper.step(system, state);
            return std::abs(state.position[1].x());
        };
        if (damping > 0.0)
            QVERIFY2(amplitude(0.999 * exact) < 1e-3, told(amplitude(0.999 * exact), 0.0));
        else // nothing takes energy out: bounded by 1 / sqrt(1 - h^2/4) = 22.4
            QVERIFY2(amplitude(0.999 * exact) < 23.0, told(amplitude(0.999 * exact), 22.4));
        QVERIFY(amplitude(1.001 * exact) >= 1e3);
    }

    // A damper without spring: relative speed falls as exp(-nu t (1/ma + 1/mb)), energy in the
    // frame of the centre of mass never rises, and momentum stays.
    void damperAlone_data() { allSchemes("S3 damper alone"); }
    void damperAlone()
    {
        QFETCH(Scheme, scheme);
        const double dt = 1e-4;
        System system = emptySystem(dt, integratorOf(scheme));
        addParticle(system, Vec3::Zero(), 2.0, {0.3, 0.0, 0.0});
        addParticle(system, {10.0, 0.0, 0.0}, 0.5, {-1.0, 0.0, 0.0});
        addSpring(system, 0, 1, 10.0, 0.0, 0.4);
        finish(system);
        if (scheme == Scheme::NaiveVerlet) {
            system.start.started = true;
            system.start.drift = system.start.velocity;
        }
        const double rate = 0.4 * (1.0 / 2.0 + 1.0 / 0.5);
        Stepper stepper;
        State state = system.start;
        double before = 1e9;
        for (int i = 0; i < 10000; ++i) {
            stepper.step(system, state);
            const double relative = std::abs((state.velocity[1] - state.velocity[0]).x());
            QVERIFY2(relative <= before * (1.0 + 1e-15), told(relative, before));
            before = relative;
        }
        const double expected = 1.3 * std::exp(-rate * 1.0);
        // (1 - r dt)^n = exp(-r t) (1 - r^2 t dt / 2): 5e-5 for the schemes of first order
        QVERIFY2(isNear(before, expected, 1e-4 * expected), told(before, expected));
        QVERIFY(isNear(momentum(system, state), Vec3(0.1, 0.0, 0.0), 1e-12));
    }

private:
    static void allSchemes(const char* what)
    {
        QTest::addColumn<Scheme>("scheme");
        QTest::addRow("%s, explicit Euler", what) << Scheme::ExplicitEuler;
        QTest::addRow("%s, semi-implicit Euler", what) << Scheme::SemiImplicitEuler;
        QTest::addRow("%s, Verlet", what) << Scheme::Verlet;
        QTest::addRow("%s, Verlet with naive start", what) << Scheme::NaiveVerlet;
        QTest::addRow("%s, velocity Verlet", what) << Scheme::VelocityVerlet;
    }
};

QTEST_APPLESS_MAIN(TestOscillator)
#include "test_oscillator.moc"
