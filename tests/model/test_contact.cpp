// Contact of particles with planes and spheres (validation B1 to B3, and what each response means).
#include "model/systems.h"

#include <QtTest>

#include <numbers>

using namespace ripstop;

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

// A plane that climbs by this angle towards +x; gravity pulls along `down`.
struct Slope
{
    explicit Slope(double degrees)
        : angle(degrees * std::numbers::pi / 180.0)
        , normal(-std::sin(angle), std::cos(angle), 0.0)
        , down(-std::cos(angle), -std::sin(angle), 0.0)
    {}
    double angle;
    Vec3 normal;
    Vec3 down;
};

constexpr std::array integrators{Integrator::ExplicitEuler, Integrator::SemiImplicitEuler,
                                 Integrator::Verlet, Integrator::VelocityVerlet};
constexpr std::array responses{Response::Stop, Response::Slide, Response::Contact};

} // namespace

class TestContact : public QObject
{
    Q_OBJECT

    static void everyIntegrator(const char* what)
    {
        QTest::addColumn<Integrator>("integrator");
        for (const Integrator integrator : integrators)
            QTest::addRow("%s, %s", what, choiceNames<Integrator>[std::size_t(integrator)].data())
                << integrator;
    }

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
    void rest_data() { everyResponse("B2 rest on a plane"); }

    // Ten seconds on the ground: not 1e-6 m deep, not 1e-6 m away, and not sinking as the first
    // paper's particles do (9.8 cm/s at this time step).
    void rest()
    {
        QFETCH(Integrator, integrator);
        QFETCH(Response, response);
        System system = falling(integrator, 0.01);
        system.obstacles = {ground(response, 0.3, 0.5)};
        addParticle(system, {0.3, 0.0, -0.2}, 1.0);
        addParticle(system, {1.0, 1e-9, 0.0}, 0.001);
        addParticle(system, {2.0, -1e-9, 0.0}, 70.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int i = 0; i < 1000; ++i) {
            stepper.step(system, state);
            for (std::size_t p = 0; p < 3; ++p)
                QVERIFY2(isNear(state.position[p], system.start.position[p], 1e-6),
                         told(state.position[p], system.start.position[p]));
        }
    }

    void fall_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::newRow("B1 drop of 1 m, semi-implicit Euler") << Integrator::SemiImplicitEuler;
        QTest::newRow("B1 drop of 1 m, Verlet") << Integrator::Verlet;
        QTest::newRow("B1 drop of 1 m, velocity Verlet") << Integrator::VelocityVerlet;
    }

    // sqrt(2 h / g) = 0.451601 s to the ground, within one time step. (Explicit Euler falls half a
    // step late by itself, so that the step in which it touches may be the next one.)
    void fall()
    {
        QFETCH(Integrator, integrator);
        System system = falling(integrator, 1e-3);
        system.obstacles = {ground(Response::Contact)};
        addParticle(system, {0.0, 1.0, 0.0}, 1.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        double speed = 0.0;
        while (state.position[0].y() > 0.0) {
            speed = -state.velocity[0].y();
            stepper.step(system, state);
        }
        QVERIFY2(isNear(state.time, 0.451601, 1.001e-3), told(state.time, 0.451601));
        QVERIFY2(isNear(speed, 4.428691, 2e-2), told(speed, 4.428691)); // two steps of g dt
        QVERIFY(state.velocity[0].norm() < 1e-12);                      // e = 0: nothing is left
    }

    void bounce_data()
    {
        QTest::addColumn<Integrator>("integrator");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<double>("total"); // s
        for (const Integrator integrator :
             {Integrator::SemiImplicitEuler, Integrator::Verlet, Integrator::VelocityVerlet}) {
            const char* name = choiceNames<Integrator>[std::size_t(integrator)].data();
            QTest::addRow("B1 e = 0.5, %s", name) << integrator << 0.5 << 1.354802;
            QTest::addRow("B1 e = 0.8, %s", name) << integrator << 0.8 << 4.064407;
        }
    }

    // The first rebounds reach e^2 and e^4 of the height, to 1 %. (How long it bounces in all,
    // sqrt(2 h / g) (1 + e) / (1 - e), is a sum over ever smaller rebounds that a time step cuts
    // off: it must come to rest, and not later than that.)
    void bounce()
    {
        QFETCH(Integrator, integrator);
        QFETCH(double, restitution);
        QFETCH(double, total);
        System system = falling(integrator, 1e-4);
        system.obstacles = {ground(Response::Contact, restitution)};
        addParticle(system, {0.0, 1.0, 0.0}, 1.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        std::vector<double> tops;
        double before = 0.0;
        double moved = 0.0;
        while (state.time < total + 0.1) {
            stepper.step(system, state);
            const double v = state.velocity[0].y();
            if (before > 0.0 && v <= 0.0 && tops.size() < 2)
                tops.push_back(state.position[0].y());
            before = v;
            if (state.position[0].y() > 1e-6)
                moved = state.time;
        }
        QCOMPARE(tops.size(), std::size_t(2));
        const double e2 = restitution * restitution;
        QVERIFY2(isNear(tops[0], e2, 0.01 * e2), told(tops[0], e2));
        QVERIFY2(isNear(tops[1], e2 * e2, 0.01 * e2 * e2), told(tops[1], e2 * e2));
        QVERIFY2(moved < 1.01 * total && moved > 0.97 * total, told(moved, total));
    }

    void incline_data() { everyIntegrator("B3 30 degrees, mu 0.3"); }

    // g (sin - mu cos) = 2.355483 m/s^2 down the slope, to 1 %.
    void incline()
    {
        QFETCH(Integrator, integrator);
        const Slope slope(30.0);
        System system = falling(integrator, 1e-3);
        system.obstacles = {ground(Response::Contact, 0.0, 0.3)};
        system.obstacles[0].normal = slope.normal;
        addParticle(system, Vec3::Zero(), 2.0);
        finish(system);
        const State state = run(system, 2000);
        const double way = slope.down.dot(state.position[0]);
        const double speed = slope.down.dot(state.velocity[0]);
        QVERIFY2(isNear(way, 0.5 * 2.355483 * 4.0, 0.01 * 0.5 * 2.355483 * 4.0),
                 told(way, 0.5 * 2.355483 * 4.0));
        QVERIFY2(isNear(speed, 2.0 * 2.355483, 0.01 * 2.0 * 2.355483), told(speed, 2.0 * 2.355483));
    }

    void sticks_data() { everyIntegrator("B3 sticks from tan 30 degrees on"); }

    // mu = 0.58 holds for ten seconds without a creep; mu = 0.57 lets go.
    void sticks()
    {
        QFETCH(Integrator, integrator);
        const Slope slope(30.0);
        for (const bool held : {true, false}) {
            System system = falling(integrator, 1e-3);
            system.obstacles = {ground(Response::Contact, 0.0, held ? 0.58 : 0.57)};
            system.obstacles[0].normal = slope.normal;
            addParticle(system, Vec3::Zero(), 2.0);
            finish(system);
            const double way = slope.down.dot(run(system, 10000).position[0]);
            const double free = 0.5 * 100.0 * standardGravity
                                * (std::sin(slope.angle) - 0.57 * std::cos(slope.angle));
            QVERIFY2(held ? std::abs(way) < 1e-6 : isNear(way, free, 0.02 * free),
                     told(way, held ? 0.0 : free));
        }
    }

    void slideToStop_data() { everyIntegrator("B3 slide to stop"); }

    // 3 m/s on a level floor with mu = 0.3 ends after v^2 / (2 mu g) = 1.529574 m and 1.019716 s.
    void slideToStop()
    {
        QFETCH(Integrator, integrator);
        System system = falling(integrator, 1e-3);
        system.obstacles = {ground(Response::Contact, 0.0, 0.3)};
        addParticle(system, Vec3::Zero(), 1.0, {3.0, 0.0, 0.0});
        finish(system);
        Stepper stepper;
        State state = system.start;
        double stopped = 0.0;
        for (int i = 0; i < 2000; ++i) {
            stepper.step(system, state);
            if (state.velocity[0].norm() > 0.05) // what gravity adds and contact takes
                stopped = state.time;
        }
        QVERIFY2(isNear(state.position[0].x(), 1.529574, 0.01 * 1.529574),
                 told(state.position[0].x(), 1.529574));
        QVERIFY2(isNear(stopped, 1.019716, 0.02), told(stopped, 1.019716));
    }

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

QTEST_APPLESS_MAIN(TestContact)
#include "test_contact.moc"
