// Fabric and lines against fabric: what is folded stays apart.
//
// Stages: a folded sheet with contact, and without it as a control; momentum of one particle and
// one panel; lines, large panels and panels that are gone; a sheet that slides down another; and
// the same bits at any number of threads.
#include "assembly/finish.h"
#include "contact/fabric_contact.h"
#include "model/systems.h"
#include "registered_test.h"

#include <QtTest>

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numbers>

namespace ripstop::test_fabric_contact {

namespace {

constexpr double thickness = 0.01; // m

// The least distance of a point from a triangle, by the best of many places on it: slow and sure.
double distanceTo(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p)
{
    const Vec3 n = (b - a).cross(c - a);
    const double area = n.norm();
    const Vec3 u = n / area;
    const double height = (p - a).dot(u);
    const Vec3 q = p - height * u;
    const auto side = [&](const Vec3& x, const Vec3& y) {
        return (y - x).cross(q - x).dot(u) >= 0.0;
    };
    if (side(a, b) && side(b, c) && side(c, a))
        return std::abs(height);
    const auto toEdge = [&](const Vec3& x, const Vec3& y) {
        const Vec3 e = y - x;
        return (p - x - std::clamp((p - x).dot(e) / e.squaredNorm(), 0.0, 1.0) * e).norm();
    };
    return std::min({toEdge(a, b), toEdge(b, c), toEdge(c, a)});
}

// The least distance of particles from panels that they do not belong to.
double leastDistance(const System& system, const State& state)
{
    double least = std::numeric_limits<double>::infinity();
    for (const FabricPanel& panel : system.panels) {
        const auto& [a, b, c] = panel.corner;
        for (int i = 0; i < int(state.position.size()); ++i)
            if (i != a && i != b && i != c)
                least = std::min(least, distanceTo(state.position[std::size_t(a)],
                                                   state.position[std::size_t(b)],
                                                   state.position[std::size_t(c)],
                                                   state.position[std::size_t(i)]));
    }
    return least;
}

// A sheet of 1 m x 0.4 m in squares of 5 cm, at the places that `bent` gives to its length.
template <typename Bent>
System sheet(Bent bent)
{
    constexpr int columns = 20, rows = 8;
    constexpr double square = 0.05; // m
    System system = emptySystem(1.0 / 240.0);
    system.substeps = 4;
    system.solver = Solver::SmallSteps;
    system.gravity = {0.0, -standardGravity, 0.0};
    system.viscosity = 0.2;
    const auto at = [](int row, int column) { return row * (columns + 1) + column; };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            addParticle(system, bent(square * column) + Vec3(0.0, 0.0, square * row), 0.0005);
    const auto rod = [&](int a, int b, double length) { addRod(system, a, b, length, 1e-6); };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            if (column < columns)
                rod(at(row, column), at(row, column + 1), square);
            if (row < rows)
                rod(at(row, column), at(row + 1, column), square);
            if (column == columns || row == rows)
                continue;
            rod(at(row, column), at(row + 1, column + 1), std::numbers::sqrt2 * square);
            rod(at(row, column + 1), at(row + 1, column), std::numbers::sqrt2 * square);
            addPanel(system, at(row, column), at(row + 1, column), at(row + 1, column + 1),
                     AirLaw::LinearNormal, 2.0);
            addPanel(system, at(row, column), at(row + 1, column + 1), at(row, column + 1),
                     AirLaw::LinearNormal, 2.0);
        }
    system.obstacles = {
        {ColliderShape::Plane, Vec3::Zero(), {0.0, 1.0, 0.0}, 0.0, Response::Contact, 0.0, 0.4}};
    system.fabricLayer.assign(system.start.position.size(), {thickness, 0.3});
    return system;
}

// Folded in half with a gap of 5 cm: down along one side, around, and back.
Vec3 folded(double along)
{
    const double leg = 0.4, radius = 0.2 / std::numbers::pi;
    if (along <= leg)
        return {along, 0.3, 0.0};
    if (along >= 1.0 - leg)
        return {1.0 - along, 0.3 + 2.0 * radius, 0.0};
    const double angle = (along - leg) / radius;
    return {leg + radius * std::sin(angle), 0.3 + radius * (1.0 - std::cos(angle)), 0.0};
}

// Squares of `cell` m in two panels each, flat from a corner on; particles of 1 g with rods along
// the sides and one diagonal, or pinned.
void addFlat(System& system, const Vec3& from, int columns, int rows, double cell, bool pinned)
{
    const int first = int(system.start.position.size());
    const auto at = [&](int row, int column) { return first + row * (columns + 1) + column; };
    const auto rod = [&](int a, int b) {
        if (!pinned)
            addRod(system, a, b, distance(system, a, b));
    };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const Vec3 place = from + cell * Vec3(column, 0.0, row);
            pinned ? addPin(system, place) : addParticle(system, place, 0.001);
            if (column > 0)
                rod(at(row, column - 1), at(row, column));
            if (row > 0)
                rod(at(row - 1, column), at(row, column));
            if (row == 0 || column == 0)
                continue;
            const int a = at(row - 1, column - 1), b = at(row, column);
            rod(a, b);
            addPanel(system, a, at(row, column - 1), b, AirLaw::None, 0.0);
            addPanel(system, a, b, at(row - 1, column), AirLaw::None, 0.0);
        }
}

} // namespace

class TestFabricContact : public QObject
{
    Q_OBJECT

private slots:
    // A folded sheet dropped on itself stays apart for 10 s.
    void foldedSheet()
    {
        System system = sheet(folded);
        finish(system);
        Stepper stepper;
        State state = system.start;
        double least = 1.0, lowest = 1.0;
        for (int i = 0; i < 2400; ++i) {
            stepper.step(system, state);
            if (i % 8 == 0)
                least = std::min(least, leastDistance(system, state));
        }
        for (const Vec3& x : state.position) {
            QVERIFY(x.allFinite());
            lowest = std::min(lowest, x.y());
        }
        QVERIFY2(least > 0.7 * thickness, told(least, thickness));
        QVERIFY2(isNear(lowest, 0.0, 1e-6), told(lowest, 0.0));
        double top = 0.0;
        for (const Vec3& x : state.position)
            top = std::max(top, x.y());
        QVERIFY2(top < 0.2, told(top, 0.0)); // it has come down
    }

    // Without contact the fabric goes through itself, which proves that the test above can fail.
    void foldedSheetWithout()
    {
        System system = sheet(folded);
        system.fabricLayer.clear();
        finish(system);
        const State state = run(system, 1200);
        QVERIFY(leastDistance(system, state) < 0.3 * thickness);
    }

    // One particle on one panel that lies free in space: momentum stays, and they part.
    void momentum()
    {
        System system = emptySystem(1.0 / 240.0);
        addParticle(system, {0.0, 0.0, 0.0}, 0.1);
        addParticle(system, {0.3, 0.0, 0.0}, 0.2);
        addParticle(system, {0.0, 0.0, 0.3}, 0.3);
        addParticle(system, {0.1, 0.05, 0.1}, 0.05, {0.5, -2.0, 0.1});
        addPanel(system, 0, 2, 1, AirLaw::None, 0.0);
        system.fabricLayer.assign(4, {thickness, 0.3});
        finish(system);
        const auto momentumOf = [&](const State& state) {
            Vec3 sum = Vec3::Zero();
            for (std::size_t i = 0; i < 4; ++i)
                sum += system.mass[i] * state.velocity[i];
            return sum;
        };
        const State state = run(system, 48);
        QVERIFY2(isNear(momentumOf(state), momentumOf(system.start), 1e-15),
                 told(momentumOf(state), momentumOf(system.start)));
        const Vec3 apart = state.position[3] - state.position[0];
        QVERIFY2(apart.y() > 0.5 * thickness, told(apart.y(), thickness));
        QVERIFY(std::abs(state.velocity[3].y()) < 1.0);
    }

    // A line that falls across a sheet held at its corners stays above; at 20 m/s as well.
    void lineOnSheet_data()
    {
        QTest::addColumn<double>("speed"); // m/s
        QTest::newRow("dropped") << 0.0;
        QTest::newRow("thrown at 5 m/s") << 5.0;
        QTest::newRow("thrown at 20 m/s") << 20.0;
    }
    void lineOnSheet()
    {
        QFETCH(double, speed);
        System system = sheet([](double along) { return Vec3(along, 1.0, 0.0); });
        const int first = int(system.start.position.size());
        for (int i = 0; i <= 10; ++i) {
            addParticle(system, {0.52, 1.1, 0.05 + 0.03 * i}, 0.001, {0.0, -speed, 0.0});
            if (i > 0)
                addRod(system, first + i - 1, first + i, 0.03);
        }
        for (const int corner : {0, 20, 168, 188})
            system.inverseMass[std::size_t(corner)] = 0.0;
        system.fabricLayer.assign(system.start.position.size(), {thickness, 0.6});
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int i = 0; i < 120; ++i) {
            stepper.step(system, state);
            QVERIFY(leastDistance(system, state) > 0.3 * thickness);
        }
        double lowest = 10.0;
        for (int i = 0; i < first; ++i)
            lowest = std::min(lowest, state.position[std::size_t(i)].y());
        for (int i = first; i < first + 11; ++i)
            QVERIFY(state.position[std::size_t(i)].y() > lowest);
    }

    // Two large triangles beside much small fabric: they span many cells and hold all the same.
    void largePanels()
    {
        System system = sheet([](double along) { return Vec3(along, 1.0, 0.0); });
        const auto corner = [&](double x, double z) { return addPin(system, {x, 0.9, z}); };
        const int a = corner(-20.0, -20.0), b = corner(20.0, -20.0), c = corner(20.0, 20.0),
                  d = corner(-20.0, 20.0);
        addPanel(system, a, b, c, AirLaw::None, 0.0);
        addPanel(system, a, c, d, AirLaw::None, 0.0);
        system.fabricLayer.assign(system.start.position.size(), {thickness, 0.6});
        finish(system);
        const State state = run(system, 240); // falls 0.1 m and comes to rest
        for (int i = 0; i < a; ++i) {
            const double height = state.position[std::size_t(i)].y() - 0.9;
            QVERIFY2(height > 0.5 * thickness && height < 0.05, told(height, thickness));
        }
    }

    // What a tear has taken away holds nothing.
    void gonePanels()
    {
        System system = emptySystem(0.01);
        for (const Vec3& place : {Vec3(-1, 0, -1), Vec3(1, 0, -1), Vec3(0, 0, 1)})
            addPin(system, place);
        const int stone = addParticle(system, {0.0, 0.1, 0.0}, 1.0, {0.0, -1.0, 0.0});
        addPanel(system, 0, 1, 2, AirLaw::None, 0.0);
        system.fabricLayer.assign(system.start.position.size(), {thickness, 0.0});
        finish(system);
        QVERIFY(run(system, 40).position[std::size_t(stone)].y() > 0.5 * thickness);
        system.start.panelGone[0] = 1;
        QCOMPARE_LT(run(system, 40).position[std::size_t(stone)].y(), -0.2);
    }

    // A sheet on a slope of 0.4 gains g (sin - mu cos) t, as it does on a plane, whatever the
    // meshes and whether it was laid there or fell; with mu above 0.4 it stays. What it lies on at
    // the start keeps it as far away as what it slides on to: else it would have to climb.
    void slidesDownFabric_data()
    {
        QTest::addColumn<int>("cells");    // of the upper sheet, along one side
        QTest::addColumn<double>("below"); // m, those of the lower one
        QTest::addColumn<double>("gap");   // 1, of the thickness, at the start
        QTest::addColumn<double>("friction");
        for (const double friction : {0.1, 0.3, 0.45})
            for (const double gap : {1.0, 1.05, 1.3}) {
                QTest::addRow("one cell on many, %g, %g", friction, gap)
                    << 1 << 0.1 << gap << friction;
                QTest::addRow("fine on coarse, %g, %g", friction, gap)
                    << 5 << 0.6 << gap << friction;
                QTest::addRow("fine on fine, %g, %g", friction, gap) << 5 << 0.1 << gap << friction;
            }
    }

    void slidesDownFabric()
    {
        QFETCH(int, cells);
        QFETCH(double, below);
        QFETCH(double, gap);
        QFETCH(double, friction);
        const double slope = std::atan(0.4);
        System system = emptySystem(1.0 / 240.0);
        system.gravity = standardGravity * Vec3(std::sin(slope), -std::cos(slope), 0.0);
        addFlat(system, Vec3::Zero(), int(std::lround(1.8 / below)), int(std::lround(0.6 / below)),
                below, true);
        const int first = int(system.start.position.size());
        addFlat(system, {0.09, gap * thickness, 0.11}, cells, cells, 0.3 / cells, false);
        system.fabricLayer.assign(system.start.position.size(), {thickness, friction});
        finish(system);
        Stepper stepper;
        State state = system.start;
        const auto fly = [&](int steps) { // answers the speed, m/s
            for (int i = 0; i < steps; ++i)
                stepper.step(system, state);
            double sum = 0.0;
            for (std::size_t i = std::size_t(first); i < state.velocity.size(); ++i)
                sum += state.velocity[i].x() / double(state.velocity.size() - std::size_t(first));
            return sum;
        };
        const double before = fly(48), gained = fly(72) - before; // in 0.3 s
        const double expected =
            0.3 * standardGravity * std::max(0.0, std::sin(slope) - friction * std::cos(slope));
        const double slack = 0.01 * 0.3 * standardGravity * std::sin(slope);
        QVERIFY2(isNear(gained, expected, slack), told(gained, expected));
        QVERIFY2(friction < 0.4 || std::abs(before) < 0.01, told(before, 0.0));
    }

    // Which particles meet which panels does not depend on threads.
    void sameBits()
    {
        System system = sheet(folded);
        finish(system);
        QVERIFY(run(system, 240, 1) == run(system, 240, 3));
    }
};

const RegisteredTest registered("test_fabric_contact", runPlain<TestFabricContact>);

} // namespace ripstop::test_fabric_contact
#include "test_fabric_contact.moc"
