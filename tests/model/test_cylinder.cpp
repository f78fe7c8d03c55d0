// Cylinders: distances and ways in, and particles that lie on them, slide and fly at them. Caps as
// floors are among the floors of test_obstacles.
//
// Stages: distances from outside and inside and at the rim; then ways that cross a thin cylinder
// in one step from any side; then motion on it (sliding, leaving, friction, over the rim) against
// closed forms.
#include "assembly/finish.h"
#include "model/obstacles.h"
#include "model/systems.h"
#include "registered_test.h"
#include "shapes/cylinder.h"
#include "shapes/touch.h"

#include <QtTest>

#include <Eigen/Geometry>

#include <numbers>

namespace ripstop::test_cylinder {

namespace {

constexpr Cylinder drum{0.5, 1.0}; // m, 1 m wide and 2 m high

// A direction across the axis of a cylinder.
Vec3 across(double angle) { return {std::cos(angle), 0.0, std::sin(angle)}; }

System falling(double timeStep)
{
    System system = emptySystem(timeStep);
    system.gravity = {0.0, -standardGravity, 0.0};
    return system;
}

} // namespace

class TestCylinder : public QObject
{
    Q_OBJECT

private slots:
    // The distance to a cylinder is that to its side, to a cap or to the circle of a rim.
    void cylinderOutside()
    {
        for (const double angle : {0.0, 0.4, 2.0, 3.9, 5.5})
            for (const double end : {-1.0, 1.0}) {
                const Vec3 out = across(angle), up = end * Vec3::UnitY();
                const Nearest side = nearestOnCylinder(drum, 0.8 * out + 0.9 * up);
                QVERIFY(isNear(side.distance, 0.3, 1e-15));
                QVERIFY(isNear(side.normal, out, 1e-15));
                const Nearest cap = nearestOnCylinder(drum, 0.4 * out + 1.3 * up);
                QVERIFY(isNear(cap.distance, 0.3, 1e-15));
                QVERIFY(isNear(cap.normal, up, 0.0));
                const Nearest rim = nearestOnCylinder(drum, 0.8 * out + 1.4 * up);
                QVERIFY(isNear(rim.distance, 0.5, 1e-15));
                QVERIFY(isNear(rim.normal, 0.6 * out + 0.8 * up, 1e-15));
            }
    }

    // From inside, to the side or to a cap, whichever is nearer; from the axis to any side.
    void cylinderInside()
    {
        for (const double angle : {0.0, 1.1, 4.0})
            for (const double end : {-1.0, 1.0}) {
                const Vec3 out = across(angle), up = end * Vec3::UnitY();
                const Nearest side = nearestOnCylinder(drum, 0.4 * out + 0.8 * up);
                QVERIFY(isNear(side.distance, -0.1, 1e-15));
                QVERIFY(isNear(side.normal, out, 1e-15));
                const Vec3 below = 0.2 * out + 0.9 * up;
                const Nearest cap = nearestOnCylinder(drum, below);
                QVERIFY(isNear(cap.distance, -0.1, 1e-15));
                QVERIFY(isNear(cap.normal, up, 0.0));
                const auto touch = touchCylinder(drum, 0.0, below, below);
                QVERIFY(touch && isNear(touch->surface, 0.2 * out + up, 1e-15));
            }
        const Nearest middle = nearestOnCylinder(drum, Vec3::Zero());
        QCOMPARE(middle.distance, -0.5);
        QVERIFY(isNear(middle.normal.norm(), 1.0, 0.0) && middle.normal.y() == 0.0);
    }

    // What falls on the rim of a cylinder with a margin meets a quarter of a ring, as on the edge
    // of a box.
    void cylinderRim()
    {
        const double margin = 0.1;
        for (const double angle : {0.0, 0.7, 3.0}) {
            const Vec3 normal = (across(angle) + Vec3::UnitY()).normalized();
            const Vec3 rim = 0.5 * across(angle) + Vec3::UnitY();
            const auto touch = touchCylinder(drum, margin, rim + 0.2 * normal, rim + 0.04 * normal);
            QVERIFY(touch);
            QVERIFY(isNear(touch->normal, normal, 1e-14));
            QVERIFY(isNear(touch->surface, rim + margin * normal, 1e-14));
            QVERIFY(!touchCylinder(drum, margin, rim + 0.2 * normal, rim + 0.101 * normal));
            // without a margin, a particle that came by the cap stays on it, and one that came by
            // the side stays on the side
            const Vec3 deep = rim - 0.01 * normal;
            const auto byCap = touchCylinder(drum, 0.0, deep + 0.1 * Vec3::UnitY(), deep);
            QVERIFY(byCap && isNear(byCap->normal, Vec3::UnitY(), 0.0));
            QVERIFY(isNear(byCap->surface.y(), 1.0, 1e-15));
            const auto bySide = touchCylinder(drum, 0.0, deep + 0.1 * across(angle), deep);
            QVERIFY(bySide && isNear(bySide->normal, across(angle), 1e-12));
            QVERIFY(isNear(bySide->surface.dot(across(angle)), 0.5, 1e-12));
        }
    }

    // B8: a disc of 1 cm and a rod of 10 cm, crossed in one step; and passed by.
    void thinCylinder()
    {
        const Cylinder disc{1.0, 0.005};
        for (const double side : {-1.0, 1.0})
            for (const double depth : {0.001, 0.005, 0.009, 0.0101, 0.17, 10.0}) {
                const Vec3 from(0.3, side * 0.02, 0.1), to(0.31, side * (0.005 - depth), 0.1);
                const auto touch = touchCylinder(disc, 0.0, from, to);
                QVERIFY(touch);
                QVERIFY(isNear(touch->normal, Vec3(0.0, side, 0.0), 0.0));
                QVERIFY(isNear(touch->surface, Vec3(0.31, side * 0.005, 0.1), 1e-15));
            }
        QVERIFY(!touchCylinder(disc, 0.0, {1.1, 0.02, 0.0}, {1.05, -0.02, 0.0}));
        QVERIFY(!touchCylinder(disc, 0.0, {0.0, 0.02, 0.0}, {0.5, 0.0051, 0.0}));

        const Cylinder rod{0.05, 3.0};
        for (const double x : {0.0, 0.02, 0.049}) {
            const auto touch = touchCylinder(rod, 0.0, {x, 0.7, 0.5}, {x, 0.9, -0.5});
            QVERIFY(touch);
            const Vec3 out(x, 0.0, std::sqrt(0.0025 - x * x));
            QVERIFY(isNear(touch->normal, out / 0.05, 1e-12));
            QVERIFY((touch->surface - out).dot(touch->normal) > -1e-12);
        }
        QVERIFY(!touchCylinder(rod, 0.0, {0.0501, 0.0, 0.5}, {0.0501, 0.0, -0.5}));
        QVERIFY(!touchCylinder(rod, 0.0, {0.0, 3.001, 0.5}, {0.0, 3.001, -0.5}));
        // a margin is crossed as little as what it is around: 4 cm beside the rod, and over its end
        QVERIFY(touchCylinder(rod, 0.05, {0.09, 0.0, 0.5}, {0.09, 0.0, -0.5}));
        QVERIFY(touchCylinder(rod, 0.05, {-0.5, 3.04, 0.0}, {0.02, 3.03, 0.0}));
        QVERIFY(!touchCylinder(rod, 0.05, {0.101, 0.0, 0.5}, {0.101, 0.0, -0.5}));
    }

    // A body with a margin is that around which the distance is the margin: wherever a way ends
    // inside, the point is put on it, and no other way than one through it is stopped.
    void cylinderHoldsWaysFromEverySide()
    {
        Dice dice(23);
        for (const double margin : {0.0, 0.2})
            for (int i = 0; i < 20000; ++i) {
                const Vec3 from = dice.vector(3.0), to = dice.vector(3.0);
                if (nearestOnCylinder(drum, from).distance < margin)
                    continue;
                double least = 1e9; // least distance on the way
                for (int step = 0; step <= 200; ++step)
                    least = std::min(
                        least, nearestOnCylinder(drum, from + step / 200.0 * (to - from)).distance);
                const auto touch = touchCylinder(drum, margin, from, to);
                if (least > margin + 0.03) { // more than half the way between two looks
                    QVERIFY(!touch);
                } else if (least < 0.0) {
                    QVERIFY(touch);
                }
                if (touch) {
                    QVERIFY(isNear(touch->normal.norm(), 1.0, 1e-12));
                    QVERIFY(nearestOnCylinder(drum, touch->surface).distance > margin - 1e-9);
                    // It goes back to where it came from. Beside the ring that the margin lays
                    // around a rim, that may be below the plane of cap or side, by the margin.
                    if (nearestOnCylinder(drum, to).distance < -0.1)
                        QVERIFY((from - touch->surface).dot(touch->normal) > -margin - 1e-9);
                }
            }
    }

    void fastPastARod_data()
    {
        QTest::addColumn<double>("speed"); // m/s
        for (const double speed : {5.0, 20.0, 40.0, 400.0})
            QTest::newRow(qPrintable(QString("%1 m/s").arg(speed))) << speed;
    }

    // B8: the same for a rod of 20 cm that lies anyhow: who is aimed at it from the side ends
    // outside of it, and on the side that it came from unless it slid past.
    void fastPastARod()
    {
        QFETCH(double, speed);
        System system = emptySystem(1.0 / 240.0);
        Obstacle rod = cylinder(0.1, 20.0);
        rod.turn = Eigen::AngleAxisd(1.0, Vec3(0.3, 0.5, -0.2).normalized()).toRotationMatrix();
        system.obstacles = {rod};
        const Vec3 axis = rod.turn.col(1);
        Dice dice(7);
        std::vector<Vec3> side;
        for (int i = 0; i < 500; ++i) {
            Vec3 from = dice.vector(1.0);
            from = (from - from.dot(axis) * axis).normalized();
            const Vec3 beside = axis.cross(from) * dice(-0.06, 0.06);
            const Vec3 target = beside + dice(-3.0, 3.0) * axis;
            const Vec3 slant = (from + dice(-1.0, 1.0) * axis).normalized();
            addParticle(system, target + dice(0.3, 1.0) * slant, 0.01, -speed * slant);
            side.push_back(from);
        }
        finish(system);
        const State state = run(system, int(std::ceil(2.0 * 240.0 / speed)) + 2);
        for (std::size_t i = 0; i < 500; ++i) {
            const Vec3& x = state.position[i];
            const double distance = (x - x.dot(axis) * axis).norm();
            QVERIFY2(distance >= 0.1 - 1e-9, told(distance, 0.1));
            // at 0.06 m from the middle the normal leans by asin 0.6, of a light touch by as much
            // more as `lightly` allows; what goes on along the surface keeps the square of the
            // sine of what went inwards
            const double lean = std::asin(0.6) + std::acos(lightly);
            const Vec3& was = system.start.velocity[i];
            const Vec3& is = state.velocity[i];
            QVERIFY2(-is.dot(side[i]) <= -std::pow(std::sin(lean), 2) * was.dot(side[i]),
                     told(is.dot(side[i]), was.dot(side[i])));
        }
    }

    // On a smooth side a particle that starts at rest, 0.1 rad from the top, leaves where gravity
    // no longer holds it: m v^2 / R = m g cos a with v^2 = 2 g R (cos 0.1 - cos a) gives
    // cos a = 2/3 cos 0.1. The gap grows with the cube of time from there, so that it is looked for
    // where it is tiny. The length of the cylinder lies along z here.
    void slidesOffTheSide()
    {
        constexpr double radius = 0.8;
        System system = falling(1e-4);
        Obstacle drum = cylinder(radius, 3.0);
        drum.response = Response::Slide;
        drum.turn = Eigen::AngleAxisd(std::numbers::pi / 2.0, Vec3::UnitX()).toRotationMatrix();
        system.obstacles = {drum};
        addParticle(system, radius * Vec3(std::sin(0.1), std::cos(0.1), 0.0), 1.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        while (state.time < 3.0
               && std::hypot(state.position[0].x(), state.position[0].y()) < radius + 1e-8)
            stepper.step(system, state);
        const Vec3 out = state.position[0].normalized();
        QVERIFY2(isNear(out.y(), 2.0 / 3.0 * std::cos(0.1), 0.01),
                 told(out.y(), 2.0 / 3.0 * std::cos(0.1)));
        const double speed = std::sqrt(2.0 * standardGravity * radius * (std::cos(0.1) - out.y()));
        QVERIFY2(isNear(state.velocity[0].norm(), speed, 0.01 * speed),
                 told(state.velocity[0].norm(), speed));
        QCOMPARE(state.position[0].z(), 0.0);
    }

    // B3 along the highest line of a cylinder whose axis climbs by 30 degrees: it slides with
    // g (sin - mu cos) = 2.355483 m/s^2 with mu = 0.3, and sticks with mu = 0.58.
    void inclinedAxis()
    {
        const double angle = std::numbers::pi / 6.0;
        const Vec3 down(-std::cos(angle), -std::sin(angle), 0.0);
        const Vec3 top = 0.5 * Vec3(-std::sin(angle), std::cos(angle), 0.0);
        System system = falling(1e-3);
        system.obstacles = {lyingCylinder(0.5, 40.0, angle, 0.3)};
        addParticle(system, top, 2.0);
        finish(system);
        const State slid = run(system, 2000);
        const double way = down.dot(slid.position[0] - top);
        QVERIFY2(isNear(way, 2.0 * 2.355483, 0.01 * 2.0 * 2.355483), told(way, 2.0 * 2.355483));
        const double speed = down.dot(slid.velocity[0]);
        QVERIFY2(isNear(speed, 2.0 * 2.355483, 0.01 * 2.0 * 2.355483), told(speed, 2.0 * 2.355483));
        system.obstacles[0].friction = 0.58;
        const Vec3 stuck = run(system, 10000).position[0];
        QVERIFY2(isNear(stuck, top, 1e-6), told(stuck, top));
    }

    // Friction holds a particle on the side up to the slope atan(mu): at 20 degrees from the top
    // with mu = 0.4, the tangent of 21.8 degrees; at 24 degrees it goes.
    void frictionOnTheSide()
    {
        for (const double degrees : {20.0, 24.0}) {
            const double angle = degrees * std::numbers::pi / 180.0;
            System system = falling(1e-3);
            system.obstacles = {lyingCylinder(0.5, 4.0, 0.0, 0.4)};
            const Vec3 start = 0.5 * Vec3(0.0, std::cos(angle), std::sin(angle));
            addParticle(system, start, 1.0);
            finish(system);
            const double moved = (run(system, 2000).position[0] - start).norm();
            QVERIFY2(degrees < 21.8 ? moved < 1e-6 : moved > 0.1, told(moved, 0.0));
        }
    }

    // What slides over the rim of a cap falls past the side and is not held by what it left.
    void overTheRim()
    {
        System system = falling(1e-3);
        system.obstacles = {cylinder(0.5, 1.0, {0.0, -0.5, 0.0})};
        addParticle(system, {0.4, 0.0, 0.0}, 1.0, {2.0, 0.0, 0.0});
        finish(system);
        const State state = run(system, 500);
        // 0.05 s to the rim, then a fall of 0.45 s
        const Vec3 expected(1.4, -0.5 * standardGravity * 0.45 * 0.45, 0.0);
        QVERIFY2(isNear(state.position[0], expected, 0.02), told(state.position[0], expected));
    }
};

const RegisteredTest registered("test_cylinder", runPlain<TestCylinder>);

} // namespace ripstop::test_cylinder
#include "test_cylinder.moc"
