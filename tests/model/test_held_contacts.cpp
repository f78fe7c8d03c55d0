// Contact with obstacles that is solved together with rods of real stiffness: forces and bounds
// that theory knows, with the automatic solver.
//
// Stages: weight on the ground and on a ball; a slope below and above the angle of friction; a rope
// over a cylinder; a chain of which a part lies on the ground; what a wall that moves takes along;
// an impact; and the same bits on more threads.
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "model/obstacles.h"
#include "model/systems.h"
#include "registered_test.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_held_contacts {

namespace {

constexpr double g = standardGravity;
constexpr double pi = 3.14159265358979323846;
constexpr double kneeMass = 1e-4; // kg, of a particle of cloth

System automatic()
{
    System system = heavySystem(1.0 / 240.0, Integrator::Auto);
    system.solver = Solver::Auto;
    system.substeps = 4;
    return system;
}

void addStiffRod(System& system, int a, int b, double stiffness)
{
    addRod(system, a, b, distance(system, a, b), 1.0 / stiffness).dampingTime = 1e-3;
}

// A square of n x n particles 5 cm apart in the plane of two directions, its first corner at a
// place, with rods along and across.
void addSheet(System& system, int n, const Vec3& corner, const Vec3& along, const Vec3& across)
{
    constexpr double stiffness = 2000.0; // N/m, of a strip of kite cloth
    const int first = int(system.start.position.size());
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
            addParticle(system, corner + 0.05 * (k * along + i * across), kneeMass);
    const auto at = [&](int i, int k) { return first + n * i + k; };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            if (k + 1 < n)
                addStiffRod(system, at(i, k), at(i, k + 1), stiffness);
            if (i + 1 < n)
                addStiffRod(system, at(i, k), at(i + 1, k), stiffness);
            if (k + 1 < n && i + 1 < n)
                addStiffRod(system, at(i, k), at(i + 1, k + 1), 0.05 * stiffness);
        }
}

Vec3 sumOfForces(const Stepper& stepper)
{
    Vec3 sum = Vec3::Zero();
    for (const HeldContact& contact : stepper.contacts())
        sum += stepper.forceOf(contact);
    return sum;
}

State runWith(Stepper& stepper, const System& system, double seconds)
{
    State state = system.start;
    for (int i = 0; i < int(std::lround(seconds / system.timeStep)); ++i)
        stepper.step(system, state);
    return state;
}

// A rope over a cylinder of 10 cm that lies along z, from weights `light` at -x and `heavy` at +x.
System overCylinder(double light, double heavy, double friction)
{
    constexpr double radius = 0.1;
    constexpr int arcs = 24, hanging = 6;
    System system = automatic();
    system.viscosity = 0.5;
    Obstacle drum = lyingCylinder(radius, 1.0, 0.0, friction);
    drum.turn = Eigen::AngleAxisd(0.5 * pi, Vec3::UnitX()).toRotationMatrix();
    system.obstacles = {drum};
    const double spacing = 2.0 * radius * std::sin(0.5 * pi / arcs); // m, of chords
    for (int i = hanging; i > 0; --i)
        addParticle(system, {-radius, -i * spacing, 0.0}, i == hanging ? light : kneeMass);
    for (int i = 0; i <= arcs; ++i) {
        const double angle = pi - pi * i / arcs;
        addParticle(system, {radius * std::cos(angle), radius * std::sin(angle), 0.0}, kneeMass);
    }
    for (int i = 1; i <= hanging; ++i)
        addParticle(system, {radius, -i * spacing, 0.0}, i == hanging ? heavy : kneeMass);
    for (int i = 0; i + 1 < int(system.start.position.size()); ++i)
        addStiffRod(system, i, i + 1, 50000.0);
    finish(system);
    return system;
}

} // namespace

class TestHeldContacts : public QObject
{
    Q_OBJECT

private slots:
    // The ground carries the weight, and no more than that.
    void groundCarriesTheWeight()
    {
        System system = automatic();
        system.obstacles = {obstacle(ColliderShape::Plane, Vec3::Zero(), 0.4)};
        addSheet(system, 8, {0.0, 0.05, 0.0}, Vec3::UnitX(), Vec3::UnitZ());
        finish(system);
        Stepper stepper;
        const State state = runWith(stepper, system, 2.0);
        const Vec3 weight(0.0, 64.0 * kneeMass * g, 0.0);
        const Vec3 got = sumOfForces(stepper);
        QVERIFY2(isNear(got, weight, 1e-3 * weight.norm()), told(got, weight));
        for (const PaddedVec3& position : state.position)
            QVERIFY(std::abs(position.y()) < 1e-6);
    }

    // So does a ball, by push and friction together, and all rods obey their laws.
    void ballCarriesTheWeight()
    {
        System system = automatic();
        system.viscosity = 3.0;
        Obstacle ball = obstacle(ColliderShape::Sphere, {0.0, 0.0, 0.0}, 0.5);
        ball.radius = 0.25;
        system.obstacles = {ball};
        addSheet(system, 11, {-0.25, 0.26, -0.25}, Vec3::UnitX(), Vec3::UnitZ());
        finish(system);
        Stepper stepper;
        runWith(stepper, system, 4.0);
        const Vec3 weight(0.0, 121.0 * kneeMass * g, 0.0);
        const Vec3 got = sumOfForces(stepper);
        QVERIFY2(isNear(got, weight, 0.01 * weight.norm()), told(got, weight));
        QVERIFY2(stepper.accuracy().pulls <= system.accuracy,
                 told(stepper.accuracy().pulls, system.accuracy));
    }

    void slope_data()
    {
        QTest::addColumn<double>("friction");
        QTest::newRow("none") << 0.0;
        QTest::newRow("too little") << 0.5;
        QTest::newRow("just too little") << 0.56;
        QTest::newRow("just enough") << 0.59; // tan 30 degrees is 0.577
        QTest::newRow("plenty") << 1.0;
    }

    // On a slope of 30 degrees a sheet goes down with g (sin - mu cos), or stays.
    void slope()
    {
        QFETCH(double, friction);
        const double angle = pi / 6.0, time = 1.0;
        const Vec3 down(std::cos(angle), -std::sin(angle), 0.0);
        const Vec3 normal(std::sin(angle), std::cos(angle), 0.0);
        System system = automatic();
        Obstacle plane = obstacle(ColliderShape::Plane, Vec3::Zero(), friction);
        plane.normal = normal;
        system.obstacles = {plane};
        addSheet(system, 5, Vec3::Zero(), down, Vec3::UnitZ());
        finish(system);
        Stepper stepper;
        const State state = runWith(stepper, system, time);
        const double pull = std::max(0.0, g * (std::sin(angle) - friction * std::cos(angle)));
        const double expected = 0.5 * pull * time * time;
        for (std::size_t i = 0; i < state.position.size(); ++i) {
            const Vec3 way = state.position[i] - system.start.position[i];
            QVERIFY2(isNear(way.dot(down), expected, 0.01 * expected + 1e-5),
                     told(way.dot(down), expected));
            QVERIFY(std::abs(way.dot(normal)) < 1e-6);
        }
    }

    void capstan_data()
    {
        QTest::addColumn<double>("ratio"); // of what friction bears
        QTest::addColumn<bool>("holds");
        QTest::newRow("less than friction bears") << 0.97 << true;
        QTest::newRow("more than friction bears") << 1.03 << false;
    }

    // A rope over half of a cylinder holds weights up to the ratio exp(mu pi) (Euler 1762,
    // Eytelwein 1808), and where it slips, that is the ratio of its pulls. An inscribed rope turns
    // by less than the surface at its first and its last touch, which takes up to 1 % from it.
    void capstan()
    {
        QFETCH(double, ratio);
        QFETCH(bool, holds);
        const double friction = 0.3, light = 0.1, bears = std::exp(friction * pi);
        System system = overCylinder(light, ratio * light * bears, friction);
        Stepper stepper;
        State state = runWith(stepper, system, 0.4); // it takes the load
        const double before = state.position.back().y();
        for (int i = 0; i < 48; ++i)
            stepper.step(system, state);
        const double fell = before - state.position.back().y();
        const double pulls = state.rodTension.back() / state.rodTension.front();
        const double expected = (holds ? ratio : 1.0) * bears;
        QVERIFY2(isNear(pulls, expected, 0.015 * expected), told(pulls, expected));
        QVERIFY2(holds ? std::abs(fell) < 1e-3 : fell > 5e-3, told(fell, 0.0));
    }

    // What friction holds stays where it is, however heavy the load on the light particles of a
    // rope: a weight comes to rest, and has not sunk by a hundredth of a millimetre a second later.
    void heldRopeDoesNotCreep_data()
    {
        QTest::addColumn<double>("ratio"); // of what friction bears
        for (const double ratio : {0.5, 0.8, 0.97})
            QTest::addRow("at %g of what friction bears", ratio) << ratio;
    }

    void heldRopeDoesNotCreep()
    {
        QFETCH(double, ratio);
        const double friction = 0.3, light = 1.0;
        System system = overCylinder(light, ratio * light * std::exp(friction * pi), friction);
        Stepper stepper;
        State state = runWith(stepper, system, 2.0);
        const double before = state.position.back().y();
        for (int i = 0; i < 240; ++i)
            stepper.step(system, state);
        const double sank = before - state.position.back().y();
        QVERIFY2(std::abs(sank) < 1e-5, told(sank, 0.0));
    }

    // A chain from a height y to smooth ground, where it lies: with the weight w for each metre and
    // the length s that hangs, the pull along the ground is H = w (s^2 - y^2) / (2 y), and at the
    // top it is H + w y.
    void chainOnTheGround()
    {
        constexpr int count = 80;
        constexpr double piece = 0.025, mass = 0.01, height = 0.6;
        System system = automatic();
        system.viscosity = 4.0;
        system.obstacles = {obstacle(ColliderShape::Plane)};
        addPin(system, Vec3::Zero());
        // Begins in two straight stretches; its top is 1.7 m away from its foot.
        const double away = 1.7, lies = 0.9;
        for (int i = 1; i <= count; ++i) {
            const double s = piece * i, up = std::max(0.0, s - lies) / (count * piece - lies);
            const Vec3 place(s < lies ? s : lies + (away - lies) * up, height * up, 0.0);
            if (i == count)
                addPin(system, place);
            else
                addParticle(system, place, mass);
        }
        for (int i = 0; i < count; ++i)
            addRod(system, i, i + 1, piece, 1e-6).dampingTime = 1e-3;
        finish(system);
        Stepper stepper;
        const State state = runWith(stepper, system, 8.0);
        // The span: what lies, and a arcosh(1 + y / a) of what hangs, a = H / w.
        const double w = mass * g / piece;
        double low = 1e-3, high = 10.0;
        for (int i = 0; i < 100; ++i) {
            const double a = 0.5 * (low + high);
            const double s = std::sqrt(height * (height + 2.0 * a));
            const double span = count * piece - s + a * std::acosh(1.0 + height / a);
            (span < away ? low : high) = a;
        }
        const double expected = low * w;
        QVERIFY2(isNear(state.rodTension.front(), expected, 0.01 * expected),
                 told(state.rodTension.front(), expected));
        const double middle = // of the last piece, m
            0.5 * (state.position[count].y() + state.position[count - 1].y());
        const double top = expected + w * middle;
        QVERIFY2(isNear(state.rodTension.back(), top, 0.01 * top),
                 told(state.rodTension.back(), top));
    }

    // A belt that moves along takes what lies on it with it, once it has rubbed it to its speed.
    void beltCarries()
    {
        System system = automatic();
        Obstacle belt = obstacle(ColliderShape::Plane, Vec3::Zero(), 0.5);
        belt.path = {{0.0, Vec3::Zero()}, {10.0, Vec3(2.0, 0.0, 0.0)}}; // 0.2 m/s
        system.obstacles = {belt};
        addSheet(system, 5, Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ());
        finish(system);
        Stepper stepper;
        const State state = runWith(stepper, system, 1.0);
        // It slips for v / (mu g) and stays behind by half of what the belt goes in that time.
        const double expected = 0.2 - 0.5 * 0.2 * 0.2 / (0.5 * g);
        for (std::size_t i = 0; i < state.position.size(); ++i) {
            const double way = state.position[i].x() - system.start.position[i].x();
            QVERIFY2(isNear(way, expected, 1e-3), told(way, expected));
            QVERIFY2(isNear(state.velocity[i].x(), 0.2, 1e-6), told(state.velocity[i].x(), 0.2));
        }
    }

    // A sheet on edge that hits the ground at 18 m/s, as a kite does that has lost its line: no
    // step misses its accuracy for long, and nothing goes through.
    void hitsTheGround()
    {
        System system = automatic();
        system.obstacles = {obstacle(ColliderShape::Plane, Vec3::Zero(), 0.4)};
        addSheet(system, 8, {0.0, 0.2, 0.0}, Vec3::UnitX(), Vec3(0.0, 0.8, 0.6));
        for (PaddedVec3& velocity : system.start.velocity)
            velocity = Vec3(0.0, -18.0, 0.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        int missed = 0;
        for (int i = 0; i < 240; ++i) {
            stepper.step(system, state);
            missed += stepper.accuracy().pulls > system.accuracy;
            for (const PaddedVec3& position : state.position)
                QVERIFY(position.y() > -1e-4);
        }
        QVERIFY2(missed <= 2, told(missed, 0.0));
    }

    void sameOnMoreThreads()
    {
        System system = automatic();
        Obstacle ball = obstacle(ColliderShape::Sphere, Vec3::Zero(), 0.3);
        ball.radius = 0.25;
        system.obstacles = {ball, obstacle(ColliderShape::Plane, {0.0, -0.3, 0.0}, 0.5)};
        addSheet(system, 24, {-0.6, 0.26, -0.6}, Vec3::UnitX(), Vec3::UnitZ());
        finish(system);
        Stepper one(1), three(3);
        QCOMPARE(stateHash(runWith(one, system, 0.5)), stateHash(runWith(three, system, 0.5)));
    }
};

const RegisteredTest registered("test_held_contacts", runPlain<TestHeldContacts>);

} // namespace ripstop::test_held_contacts

#include "test_held_contacts.moc"
