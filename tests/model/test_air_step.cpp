// How long a substep may be for what the air takes from fabric.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include "forces/forces.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_air_step {

namespace {

double limitOf(const System& system, const State& state)
{
    Damping scratch;
    return dampingStepLimit(system, state, scratch);
}

// A triangle of 2 m^2 in the plane y = 0, of three equal masses.
System panel(AirLaw law, double mass, const Vec3& wind)
{
    System system = emptySystem(1e-3);
    system.wind = wind;
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, 2)})
        addParticle(system, place, mass / 3.0);
    addPanel(system, 0, 1, 2, law, 1.7);
    finish(system);
    return system;
}

} // namespace

class TestAirStep : public QObject
{
    Q_OBJECT

private slots:
    // Head on, both laws press with rho C A W^2 / 2, which falls by rho C A W for each m/s that the
    // panel gives way; a step of h overshoots twice when that times h is 2 m.
    void headOn_data()
    {
        QTest::addColumn<AirLaw>("law");
        QTest::newRow("linear normal") << AirLaw::LinearNormal;
        QTest::newRow("paper") << AirLaw::Paper;
    }
    void headOn()
    {
        QFETCH(AirLaw, law);
        const double mass = 0.1, speed = 8.0;
        const System system = panel(law, mass, {0.0, -speed, 0.0});
        const double expected = 2.0 * mass / (system.airDensity * 1.7 * 2.0 * speed);
        const double limit = limitOf(system, system.start);
        QVERIFY2(isNear(limit, expected, 1e-9), told(limit, expected));
    }

    // Along the wind, F = rho C A |w| (n.w) n / 2 falls by half as much.
    void alongTheWind()
    {
        const double mass = 0.1, speed = 8.0;
        const System system = panel(AirLaw::LinearNormal, mass, {speed, 0.0, 0.0});
        const double expected = 4.0 * mass / (system.airDensity * 1.7 * 2.0 * speed);
        const double limit = limitOf(system, system.start);
        QVERIFY2(isNear(limit, expected, 1e-4 * expected), told(limit, expected));
    }

    // What moves with the wind meets none; what is pinned, gone or not there asks for nothing.
    void nothingToTake()
    {
        const Vec3 wind(0.0, -8.0, 0.0);
        System system = panel(AirLaw::LinearNormal, 0.1, wind);
        State state = system.start;
        for (PaddedVec3& velocity : state.velocity)
            velocity = wind;
        QVERIFY(limitOf(system, state) > 100.0 * limitOf(system, system.start));
        state = system.start;
        state.panelGone[0] = 1;
        QVERIFY(std::isinf(limitOf(system, state)));
        for (double& w : system.inverseMass)
            w = 0.0;
        QVERIFY(std::isinf(limitOf(system, system.start)));
        QVERIFY(std::isinf(limitOf(System(), State())));
    }
};

const RegisteredTest registered("test_air_step", runPlain<TestAirStep>);

} // namespace ripstop::test_air_step
#include "test_air_step.moc"
