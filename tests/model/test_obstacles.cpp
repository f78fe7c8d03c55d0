// Particles on boxes, hills and meshes, at rest and in motion (validation B1 to B3, B7, B8), and
// obstacles that move.
//
// Stages: rest, bounce and slides against closed forms; fast particles at thin bodies and in
// corners; then obstacles that move: paths, belts, walls, lifts, and controls.
#include "assembly/finish.h"
#include "contact/obstacle_motion.h"
#include "model/obstacles.h"
#include "model/systems.h"
#include "registered_test.h"

#include <QtTest>

#include <Eigen/Geometry>

#include <numbers>

namespace ripstop::test_obstacles {

namespace {

Obstacle box(const Vec3& size, const Vec3& position = Vec3::Zero(), double friction = 0.0)
{
    Obstacle result = obstacle(ColliderShape::Box, position, friction);
    result.size = size;
    return result;
}

// Ground that climbs towards +x by this slope, 20 m wide, 0 in the middle.
Obstacle slopingField(double slope, double friction = 0.0)
{
    Obstacle result = obstacle(ColliderShape::HeightField, {0.0, -10.0 * slope, 0.0}, friction);
    result.size = Vec3(20.0, 20.0 * slope, 20.0);
    HeightGrid grid{65, 65, {}};
    for (int row = 0; row < 65; ++row)
        for (int column = 0; column < 65; ++column)
            grid.height.push_back(column / 64.0);
    result.grid = std::make_shared<const HeightGrid>(grid);
    return result;
}

// A floor of 20 x 20 squares of 1 m, open, level before it is turned.
Obstacle meshFloor(double friction = 0.0)
{
    Obstacle result = obstacle(ColliderShape::Mesh, Vec3::Zero(), friction);
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;
    for (int row = 0; row <= 20; ++row)
        for (int column = 0; column <= 20; ++column)
            points.emplace_back(column - 10.0, 0.0, row - 10.0);
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 20; ++column) {
            const int a = 21 * row + column;
            triangles.push_back({a, a + 21, a + 22});
            triangles.push_back({a, a + 22, a + 1});
        }
    result.mesh = std::make_shared<const TriangleTree>(points, triangles);
    result.thickness = 0.01;
    return result;
}

// Floors whose surface passes through the origin, turned about z by an angle.
Obstacle floorOf(const QString& kind, double angle, double friction)
{
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    Obstacle floor;
    if (kind == "box") {
        floor = box({40.0, 2.0, 40.0}, turn * Vec3(0.0, -1.0, 0.0), friction);
        floor.turn = turn;
    } else if (kind == "box with a margin") {
        floor = box({40.0, 1.0, 40.0}, turn * Vec3(0.0, -1.0, 0.0), friction);
        floor.turn = turn;
        floor.thickness = 0.5;
    } else if (kind == "cap") {
        floor = cylinder(20.0, 2.0, turn * Vec3(0.0, -1.0, 0.0), friction);
        floor.turn = turn;
    } else if (kind == "cap with a margin") {
        floor = cylinder(20.0, 1.0, turn * Vec3(0.0, -1.0, 0.0), friction);
        floor.turn = turn;
        floor.thickness = 0.5;
    } else if (kind == "height field") {
        floor = slopingField(std::tan(angle), friction);
    } else if (kind == "turned height field") {
        floor = slopingField(0.0, friction);
        floor.position = Vec3::Zero();
        floor.turn = turn;
    } else {
        floor = meshFloor(friction);
        floor.position = turn * Vec3(0.0, -0.01, 0.0);
        floor.turn = turn;
    }
    return floor;
}

System falling(double timeStep)
{
    System system = emptySystem(timeStep);
    system.gravity = {0.0, -standardGravity, 0.0};
    return system;
}

constexpr std::array floors{"box",          "box with a margin",   "cap", "cap with a margin",
                            "height field", "turned height field", "mesh"};

} // namespace

class TestObstacles : public QObject
{
    Q_OBJECT

    static void everyFloor()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind : floors)
            QTest::newRow(kind) << QString(kind);
    }

private slots:
    void rest_data() { everyFloor(); }

    // B2: ten seconds on a level floor, neither 1e-6 m deep nor 1e-6 m away.
    void rest()
    {
        QFETCH(QString, kind);
        System system = falling(0.01);
        system.obstacles = {floorOf(kind, 0.0, 0.5)};
        addParticle(system, {0.3, 0.0, -0.2}, 1.0);
        addParticle(system, {1.0, 1e-9, 0.0}, 0.001);
        addParticle(system, {2.0, 0.0, 3.0}, 70.0);
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

    void bounce_data() { everyFloor(); }

    // B1: dropped from 1 m, e = 0.8, the first rebound reaches 0.64 m, to 1 %.
    void bounce()
    {
        QFETCH(QString, kind);
        System system = falling(1e-4);
        system.obstacles = {floorOf(kind, 0.0, 0.3)};
        system.obstacles[0].restitution = 0.8;
        addParticle(system, {0.3, 1.0, 0.2}, 1.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        double top = 0.0;
        while (state.time < 1.1) {
            stepper.step(system, state);
            if (state.time > 0.5)
                top = std::max(top, state.position[0].y());
        }
        QVERIFY2(isNear(top, 0.64, 0.0064), told(top, 0.64));
    }

    void incline_data() { everyFloor(); }

    // B3: on 30 degrees with mu = 0.3 it slides with g (sin - mu cos) = 2.355483 m/s^2; with
    // mu = 0.58 it sticks for ten seconds.
    void incline()
    {
        QFETCH(QString, kind);
        const double angle = std::numbers::pi / 6.0;
        const Vec3 down(-std::cos(angle), -std::sin(angle), 0.0);
        System system = falling(1e-3);
        system.obstacles = {floorOf(kind, angle, 0.3)};
        addParticle(system, {0.0, 0.0, 0.1}, 2.0);
        finish(system);
        const State slid = run(system, 2000);
        QVERIFY2(isNear(down.dot(slid.velocity[0]), 2.0 * 2.355483, 0.01 * 2.0 * 2.355483),
                 told(down.dot(slid.velocity[0]), 2.0 * 2.355483));
        QVERIFY2(isNear(down.dot(slid.position[0]), 2.0 * 2.355483, 0.01 * 2.0 * 2.355483),
                 told(down.dot(slid.position[0]), 2.0 * 2.355483));
        system.obstacles[0].friction = 0.58;
        const Vec3 stuck = run(system, 10000).position[0];
        QVERIFY2(isNear(stuck, Vec3(0.0, 0.0, 0.1), 1e-6), told(stuck, Vec3(0.0, 0.0, 0.1)));
    }

    void fast_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<double>("speed"); // m/s
        for (const char* kind : {"plate", "turned plate", "disc", "turned disc", "ball", "slope",
                                 "mesh", "turned mesh"})
            for (const double speed : {5.0, 20.0, 40.0, 400.0})
                QTest::newRow(qPrintable(QString("%1 at %2 m/s").arg(kind).arg(speed)))
                    << QString(kind) << speed;
    }

    // B7, B8: at 1/240 s nothing tunnels: not through a plate or a disc of 5 mm, a ball of 20 cm, a
    // slope of 45 degrees or a mesh, from many places and in many directions.
    void fast()
    {
        QFETCH(QString, kind);
        QFETCH(double, speed);
        System system = emptySystem(1.0 / 240.0);
        Obstacle shape = kind.contains("plate")  ? box({20.0, 0.005, 20.0})
                         : kind.contains("disc") ? cylinder(10.0, 0.005)
                         : kind == "ball"        ? obstacle(ColliderShape::Sphere)
                         : kind == "slope"       ? slopingField(1.0)
                                                 : meshFloor();
        if (kind == "ball")
            shape.radius = 0.1;
        if (kind.startsWith("turned"))
            shape.turn =
                Eigen::AngleAxisd(1.0, Vec3(0.3, 0.5, -0.2).normalized()).toRotationMatrix();
        const Vec3 up = kind == "slope" ? Vec3(-1.0, 1.0, 0.0).normalized() : shape.turn.col(1);
        system.obstacles = {shape};
        Dice dice(11);
        for (int i = 0; i < 500; ++i) {
            const bool isBall = kind == "ball";
            Vec3 target = dice.vector(isBall ? 0.06 : 3.0);
            Vec3 from = dice.vector(1.0).normalized();
            if (!isBall) {
                target -= target.dot(up) * up;
                from = (from + 1.5 * up).normalized(); // within 54 degrees
            }
            addParticle(system, target + dice(0.3, 1.0) * from, 0.01, -speed * from);
        }
        finish(system);
        const State state = run(system, int(std::ceil(1.2 * 240.0 / speed)) + 2);
        for (std::size_t i = 0; i < 500; ++i) {
            const Vec3& x = state.position[i];
            if (kind == "ball") {
                QVERIFY2(x.norm() >= 0.1 - 1e-9, told(x.norm(), 0.1));
                // A particle that was aimed at the ball has lost what went into it: at 0.09 m from
                // the line through the middle that leaves 0.9 of the speed, and no less is lost
                // nearer.
                const Vec3& start = system.start.position[i];
                const Vec3 way = system.start.velocity[i] / speed;
                if ((start - start.dot(way) * way).norm() < 0.09)
                    QVERIFY2(state.velocity[i].norm() < 0.98 * speed,
                             told(state.velocity[i].norm(), speed));
            } else {
                QVERIFY2(x.dot(up) > -1e-12, told(x.dot(up), 0.0));
            }
        }
    }

    void corner_data()
    {
        QTest::addColumn<bool>("asMesh");
        QTest::newRow("two boxes") << false;
        QTest::newRow("mesh") << true;
    }

    // In the corner of two walls that meet at a right angle, what is fast stays in.
    void corner()
    {
        QFETCH(bool, asMesh);
        System system = emptySystem(1.0 / 240.0);
        if (asMesh) {
            Obstacle walls = obstacle(ColliderShape::Mesh);
            walls.thickness = 0.002;
            walls.mesh = std::make_shared<const TriangleTree>(
                std::vector<Vec3>{
                    {0, 0, -5}, {0, 0, 5}, {5, 0, -5}, {5, 0, 5}, {0, 5, -5}, {0, 5, 5}},
                std::vector<std::array<int, 3>>{{0, 1, 2}, {2, 1, 3}, {0, 4, 1}, {1, 4, 5}});
            system.obstacles = {walls};
        } else {
            system.obstacles = {box({0.01, 10.0, 10.0}, {-0.005, 0.0, 0.0}),
                                box({10.0, 0.01, 10.0}, {0.0, -0.005, 0.0})};
        }
        Dice dice(5);
        for (int i = 0; i < 200; ++i)
            addParticle(system, {dice(0.05, 1.0), dice(0.05, 1.0), dice(-1.0, 1.0)}, 0.01,
                        40.0
                            * Vec3(-dice(0.1, 1.0), -dice(0.1, 1.0), dice(-0.2, 0.2)).normalized());
        finish(system);
        for (const Vec3& x : run(system, 12).position)
            QVERIFY2(x.x() > -1e-9 && x.y() > -1e-9, told(x, Vec3::Zero()));
    }

    // A path is a straight line from key to key, and stands before and after.
    void path()
    {
        System system = emptySystem(0.01);
        system.obstacles = {box(Vec3::Ones())};
        system.obstacles[0].path = {{1.0, {0.0, 1.0, 0.0}}, {3.0, {4.0, 1.0, 2.0}}};
        finish(system);
        const State& state = system.start;
        QVERIFY(isNear(obstaclePosition(system, state, 0, 0.0), Vec3(0.0, 1.0, 0.0), 0.0));
        QVERIFY(isNear(obstaclePosition(system, state, 0, 1.5), Vec3(1.0, 1.0, 0.5), 1e-15));
        QVERIFY(isNear(obstaclePosition(system, state, 0, 9.0), Vec3(4.0, 1.0, 2.0), 0.0));
    }

    // A belt that runs at 2 m/s takes a particle along: mu g = 2.94 m/s^2 until it has the speed,
    // after 0.679865 s and 0.679865 m, then 2 m/s; it neither lags nor leaves.
    void belt()
    {
        System system = falling(1e-3);
        system.obstacles = {box({40.0, 1.0, 40.0}, {0.0, -0.5, 0.0}, 0.3)};
        system.obstacles[0].path = {{0.0, {0.0, -0.5, 0.0}}, {10.0, {20.0, -0.5, 0.0}}};
        addParticle(system, Vec3::Zero(), 1.0);
        finish(system);
        const State half = run(system, 340);
        QVERIFY2(isNear(half.velocity[0].x(), 0.34 * 0.3 * standardGravity, 0.01),
                 told(half.velocity[0].x(), 0.34 * 0.3 * standardGravity));
        const State state = run(system, 2000);
        const double reached = 2.0 / (0.3 * standardGravity);
        const double way = reached + 2.0 * (2.0 - reached);
        QVERIFY2(isNear(state.velocity[0], Vec3(2.0, 0.0, 0.0), 0.01),
                 told(state.velocity[0], Vec3(2.0, 0.0, 0.0)));
        QVERIFY2(isNear(state.position[0], Vec3(way, 0.0, 0.0), 0.01 * way),
                 told(state.position[0], Vec3(way, 0.0, 0.0)));
    }

    // A wall at 3 m/s strikes a particle at rest: it leaves at (1 + e) 3 m/s. A lift carries one.
    void wallAndLift()
    {
        System system = emptySystem(1.0 / 240.0);
        system.obstacles = {box({0.02, 1.0, 1.0})};
        system.obstacles[0].restitution = 0.5;
        system.obstacles[0].path = {{0.0, {-1.0, 0.0, 0.0}}, {10.0, {29.0, 0.0, 0.0}}};
        addParticle(system, Vec3::Zero(), 1.0);
        finish(system);
        const Vec3 left = run(system, 120).velocity[0];
        QVERIFY2(isNear(left, Vec3(4.5, 0.0, 0.0), 1e-9), told(left, Vec3(4.5, 0.0, 0.0)));

        System lift = falling(1e-3);
        lift.obstacles = {box({1.0, 0.1, 1.0}, {0.0, -0.05, 0.0}, 0.5)};
        lift.obstacles[0].path = {{0.0, {0.0, -0.05, 0.0}}, {2.0, {0.0, 1.95, 0.0}}};
        addParticle(lift, {0.1, 0.0, 0.0}, 1.0);
        finish(lift);
        const State up = run(lift, 1000);
        QVERIFY2(isNear(up.position[0], Vec3(0.1, 1.0, 0.0), 1e-6),
                 told(up.position[0], Vec3(0.1, 1.0, 0.0)));
    }

    void control_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::newRow("box") << "box";
        QTest::newRow("cylinder") << "cylinder";
        QTest::newRow("disc") << "disc";
    }

    // A control moves an obstacle at its rate, and what stands in the way goes with it; fast
    // walls, rods and discs do not pass over particles.
    void control()
    {
        QFETCH(QString, kind);
        System system = emptySystem(1.0 / 240.0);
        system.obstacles = {kind == "box"        ? box({0.01, 1.0, 1.0})
                            : kind == "cylinder" ? cylinder(0.005, 1.0)
                                                 : lyingCylinder(0.5, 0.01, 0.0)};
        system.inputs = {{1, ControlKind::Move, Vec3::UnitX(), 100.0, 40.0, 0.0, {}, {0}}};
        addParticle(system, {0.3, 0.0, 0.0}, 1.0);
        finish(system);
        system.start.inputCommand = {2.0};
        const State state = run(system, 24);
        QVERIFY(isNear(obstaclePosition(system, state, 0, state.time), Vec3(2.0, 0.0, 0.0), 1e-12));
        QVERIFY2(state.position[0].x() > 2.005 - 1e-9, told(state.position[0].x(), 2.005));
        QVERIFY2(isNear(state.velocity[0].x(), 40.0, 1e-9), told(state.velocity[0].x(), 40.0));
    }
};

const RegisteredTest registered("test_obstacles", runPlain<TestObstacles>);

} // namespace ripstop::test_obstacles
#include "test_obstacles.moc"
