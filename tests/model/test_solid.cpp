// The table of shapes: whatever shapes there are, each row agrees with itself, so that what one
// sees of a shape is what stops fabric.
//
// Stages: each row of the table makes a body of its shape; where random rays meet it, a particle
// has to be stopped; then the surface that is drawn is compared with its bounds and its extremes.
// A new shape is covered without a change here.
#include "model/systems.h"
#include "registered_test.h"
#include "shapes/solid.h"

#include <QtTest>

namespace ripstop::test_solid {

namespace {

// A solid of eight faces, the corners on the axes.
TriangleTree octahedron()
{
    std::vector<Vec3> points;
    for (const int axis : {0, 1, 2})
        for (const double side : {1.0, -1.0})
            points.push_back(side * Vec3::Unit(axis));
    return {
        points,
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// A slope, so that no ray slips by between two of its steps.
HeightGrid slope()
{
    HeightGrid grid{17, 17, {}};
    for (int row = 0; row < 17; ++row)
        for (int column = 0; column < 17; ++column)
            grid.height.push_back(0.4 * column / 16.0 + 0.6 * row / 16.0);
    return grid;
}

// Numbers with which every shape is a body of a few metres.
struct Bodies
{
    HeightGrid grid = slope();
    TriangleTree mesh = octahedron();

    Solid solid(double margin) const
    {
        return {.radius = 0.7,
                .size = Vec3(1.0, 1.5, 2.0),
                .scale = 1.3,
                .margin = margin,
                .grid = &grid,
                .mesh = &mesh};
    }
};

void everyBody()
{
    QTest::addColumn<ColliderShape>("shape");
    for (std::size_t i = 0; i < choiceNames<ColliderShape>.size(); ++i)
        if (rowOf(ColliderShape(i)).touch) // planes have no end
            QTest::newRow(choiceNames<ColliderShape>[i].data()) << ColliderShape(i);
}

} // namespace

class TestSolid : public QObject
{
    Q_OBJECT

private slots:
    void rowsAgreeWithThemselves_data() { everyBody(); }

    // What the view sees of a shape is what stops a particle: where a ray meets it, there is its
    // surface, within its bounds, and a point that goes on along the ray is stopped there.
    void rowsAgreeWithThemselves()
    {
        QFETCH(ColliderShape, shape);
        const ShapeRow& row = rowOf(shape);
        const Bodies bodies;
        const Solid solid = bodies.solid(0.0);
        const Eigen::AlignedBox3d bounds = row.bounds(solid);
        QVERIFY(!bounds.isEmpty() && row.flaw(solid).empty() && row.width(solid) > 0.0);
        // rays to a field are followed in steps of half a cell
        const double exact = row.madeOf == MadeOf::Heights ? 0.05 : 1e-4;
        Dice dice(3);
        int met = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3 inside = bounds.center() + dice.vector(1.0).cwiseProduct(bounds.sizes()) / 2;
            const Vec3 from = bounds.center() + 5.0 * dice.vector(1.0).normalized();
            const Vec3 direction = (inside - from).normalized();
            const double t = row.ray(solid, {from, direction});
            if (t == noHit) {
                QVERIFY(row.isGround || !row.touch(solid, from, from + 10.0 * direction, true));
                continue;
            }
            const Vec3 place = from + t * direction;
            const Vec3 offset = (place - bounds.center()).cwiseAbs() - 0.45 * bounds.sizes();
            if (row.isGround && (direction.y() > -0.3 || offset.x() > 0.0 || offset.z() > 0.0))
                continue; // through the rim and from below there is no surface
            ++met;
            QVERIFY(bounds.squaredExteriorDistance(place) < 1e-18);
            const auto touch = row.touch(solid, from, place + exact * direction, true);
            QVERIFY(touch);
            if (!row.isGround) // whose rays end at the first of some steps that is below it
                QVERIFY2((touch->surface - place).norm() < 0.1, told(touch->surface, place));
            QVERIFY(touch->normal.dot(direction) < 0.0);
            if (row.madeOf == MadeOf::Numbers)
                QVERIFY(!row.touch(solid, from, place - exact * direction, true));
        }
        QVERIFY(met > 100);
    }

    void surfacesAreThoseOfTheShape_data() { everyBody(); }

    // What is drawn lies within the bounds, fills them, and is seen from outside.
    void surfacesAreThoseOfTheShape()
    {
        QFETCH(ColliderShape, shape);
        const ShapeRow& row = rowOf(shape);
        const Bodies bodies;
        const Solid solid = bodies.solid(0.0);
        const Eigen::AlignedBox3d bounds = row.bounds(solid);
        const ShapeSurface surface = row.surface(solid);
        QVERIFY(surface.normals.empty() || surface.normals.size() == surface.points.size());
        Eigen::AlignedBox3d around;
        for (const Vec3& point : surface.points) {
            QVERIFY(bounds.squaredExteriorDistance(point) < 1e-18);
            around.extend(point);
        }
        for (const int axis : {0, 2})
            QVERIFY(around.sizes()[axis] > 0.95 * bounds.sizes()[axis]);
        Vec3 sum = Vec3::Zero(); // of the areas: none of a closed surface
        for (const auto& [a, b, c, d] : surface.faces) {
            const auto at = [&](int i) { return surface.points[std::size_t(i)]; };
            const Vec3 area = (at(b) - at(a)).cross(at(c) - at(a));
            sum += d < 0 ? area : Vec3((at(c) - at(a)).cross(at(d) - at(b)));
            if (!surface.normals.empty())
                QVERIFY(area.dot(surface.normals[std::size_t(a)]) >= 0.0);
            if (!row.isGround)
                QVERIFY(area.dot(at(a) + at(b) + at(c)) > 0.0);
        }
        if (row.isGround)
            QVERIFY(sum.y() > 0.0);
        else
            QVERIFY(isNear(sum, Vec3::Zero(), 1e-12));
        const std::vector<Vec3> extremes = row.extremes(solid);
        Eigen::AlignedBox3d seen;
        for (const Vec3& point : extremes)
            seen.extend(point);
        QVERIFY(seen.min().isApprox(bounds.min()) && seen.max().isApprox(bounds.max()));
    }
};

const RegisteredTest registered("test_solid", runPlain<TestSolid>);

} // namespace ripstop::test_solid
#include "test_solid.moc"
