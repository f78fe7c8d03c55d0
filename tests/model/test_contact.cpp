// Contact of particles with planes and spheres: what each response means. How things fall, bounce,
// rest and slide is among the cases of model/verify.
//
// Stages: one particle against the floor, obliquely and on the way out; then spheres, from the
// top, the side and inside; pins; and a chain that falls onto the floor.
#include "assembly/finish.h"
#include "model/systems.h"
#include "registered_test.h"

#include <QtTest>

namespace ripstop::test_contact {

namespace {

Obstacle ground(Response response, double restitution = 0.0, double friction = 0.0)
{
    return {ColliderShape::Plane, Vec3::Zero(), {0.0, 1.0, 0.0}, 0.0, response,
            restitution,          friction};
}

Obstacle ball(Response response, double friction = 0.0)
{
    return {ColliderShape::Sphere, {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}, 0.5, response, 0.0, friction};
}

System falling(Integrator integrator, double timeStep)
{
    System system = emptySystem(timeStep, integrator);
    system.gravity = {0.0, -standardGravity, 0.0};
    return system;
}

constexpr std::array integrators{Integrator::ExplicitEuler, Integrator::SemiImplicitEuler,
                                 Integrator::Verlet, Integrator::VelocityVerlet};
constexpr std::array responses{Response::Stop, Response::Slide, Response::Contact};

} // namespace

class TestContact : public QObject
{
    Q_OBJECT

    static void everyResponse(const char* what)
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<Response>("response");
        for (const Integrator integrator : integrators)
            for (const Response response : responses)
                QTest::addRow("%s, %s, %s", what,
                              choiceNames<Response>[std::size_t(response)].data(),
                              choiceNames<Integrator>[std::size_t(integrator)].data())
                    << integrator << response;
    }

private slots:
    void oblique_data()
    {
        QTest::addColumn<Response>("response");
        QTest::addColumn<Vec3>("left"); // m/s
        QTest::newRow("stop leaves nothing") << Response::Stop << Vec3(0.0, 0.0, 0.0);
        QTest::newRow("slide keeps what goes along") << Response::Slide << Vec3(3.0, 0.0, 4.0);
        // normal impulse (1 + 0.5) 2 = 3 m/s; friction 0.2 x 3 = 0.6 of the 5 m/s along
        QTest::newRow("contact bounces and rubs") << Response::Contact << Vec3(2.64, 1.0, 3.52);
    }

    // Without gravity, 2 m/s into the floor and 5 m/s along it.
    void oblique()
    {
        QFETCH(Response, response);
        QFETCH(Vec3, left);
        System system = emptySystem(0.01);
        system.obstacles = {ground(response, 0.5, 0.2)};
        addParticle(system, {0.0, 0.01, 0.0}, 1.0, {3.0, -2.0, 4.0});
        finish(system);
        const State state = run(system, 1);
        QVERIFY2(isNear(state.velocity[0], left, 1e-12), told(state.velocity[0], left));
        QVERIFY(state.position[0].y() >= 0.0);
    }

    void leaving_data() { everyResponse("leaving"); }

    // What goes outwards is let go, also when it starts a little inside.
    void leaving()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Response, response);
        System system = emptySystem(0.01, integrator);
        system.obstacles = {ground(response, 0.5, 0.9)};
        addParticle(system, Vec3::Zero(), 1.0, {1.0, 1.0, 0.0});
        finish(system);
        const State state = run(system, 100);
        QVERIFY2(isNear(state.position[0], Vec3(1.0, 1.0, 0.0), 1e-12),
                 told(state.position[0], Vec3(1.0, 1.0, 0.0)));
    }

    void sphereTop_data() { everyResponse("on top of a sphere"); }

    // Dropped on the very top, a particle stays there; dropped on the side, it stays outside.
    void sphereTop()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Response, response);
        System system = falling(integrator, 1e-3);
        system.obstacles = {ball(response, 0.4)};
        addParticle(system, {0.0, 1.8, 0.0}, 1.0);
        addParticle(system, {0.2, 1.8, 0.1}, 1.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int i = 0; i < 1000; ++i) {
            stepper.step(system, state);
            for (const Vec3& x : state.position)
                QVERIFY((x - Vec3(0.0, 1.0, 0.0)).norm() > 0.5 - 1e-9);
        }
        QVERIFY2(isNear(state.position[0], Vec3(0.0, 1.5, 0.0), 1e-4),
                 told(state.position[0], Vec3(0.0, 1.5, 0.0)));
        const double away = std::hypot(state.position[1].x(), state.position[1].z());
        if (response == Response::Stop) // stuck where it hit, under its place of release
            QVERIFY2(isNear(away, std::hypot(0.2, 0.1), 0.02), told(away, std::hypot(0.2, 0.1)));
        else
            QVERIFY(away > 0.4); // slid off
    }

    // The way out of the middle of a sphere, or from anywhere inside, is the shortest one.
    void insideSphere()
    {
        System system = emptySystem(0.01);
        system.obstacles = {ball(Response::Stop)};
        addParticle(system, {0.0, 1.0, 0.0}, 1.0);
        addParticle(system, {0.1, 1.0, 0.0}, 1.0);
        addParticle(system, {0.0, 0.8, 0.0}, 1.0);
        finish(system);
        const State state = run(system, 1);
        QVERIFY(isNear((state.position[0] - Vec3(0.0, 1.0, 0.0)).norm(), 0.5, 1e-12));
        QVERIFY(isNear(state.position[1], Vec3(0.5, 1.0, 0.0), 1e-12));
        QVERIFY(isNear(state.position[2], Vec3(0.0, 0.5, 0.0), 1e-12));
    }

    // F16: the papers' sphere stops vertical motion; the right response depends on the normal. A
    // particle that meets the side of a sphere loses what goes along the normal there.
    void sphereNormal()
    {
        System system = emptySystem(0.01);
        system.obstacles = {ball(Response::Slide)};
        const Vec3 normal = Vec3(1.0, 0.0, 1.0).normalized();
        addParticle(system, Vec3(0.0, 1.0, 0.0) + 0.501 * normal, 1.0,
                    -1.0 * normal + Vec3(0.0, 2.0, 0.0));
        finish(system);
        const Vec3 v = run(system, 1).velocity[0];
        QVERIFY2(isNear(v, Vec3(0.0, 2.0, 0.0), 0.1), told(v, Vec3(0.0, 2.0, 0.0)));
        QVERIFY2(v.y() > 1.9, "the vertical part stays");
    }

    // Pins do not collide: they stay where their author put them.
    void pins()
    {
        System system = falling(Integrator::SemiImplicitEuler, 0.01);
        system.obstacles = {ground(Response::Contact), ball(Response::Stop)};
        addPin(system, {0.0, -1.0, 0.0});
        addPin(system, {0.0, 1.0, 0.0});
        finish(system);
        const State state = run(system, 10);
        QCOMPARE(state.position[0], system.start.position[0]);
        QCOMPARE(state.position[1], system.start.position[1]);
    }

    // A chain that lies on the floor does not sink, and comes to rest.
    void chainOnFloor_data() { everyResponse("chain on the floor"); }
    void chainOnFloor()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Response, response);
        System system = falling(integrator, 1.0 / 500.0);
        system.obstacles = {ground(response, 0.0, 0.3)};
        system.viscosity = 1.0;
        for (int i = 0; i < 8; ++i) {
            addParticle(system, {0.1 * i, 0.1 + 0.02 * i, 0.0}, 0.05);
            if (i > 0)
                addRod(system, i - 1, i, distance(system, i - 1, i));
        }
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int i = 0; i < 2000; ++i) {
            stepper.step(system, state);
            for (const Vec3& x : state.position)
                QVERIFY(x.y() >= -1e-9);
        }
        const State later = run(system, state, 500);
        for (std::size_t i = 0; i < 8; ++i)
            QVERIFY2(isNear(later.position[i].y(), 0.0, 1e-3), told(later.position[i].y(), 0.0));
    }
};

const RegisteredTest registered("test_contact", runPlain<TestContact>);

} // namespace ripstop::test_contact
#include "test_contact.moc"
