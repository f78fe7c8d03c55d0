// Colliders in the view: what is kept from picture to picture, what is drawn, and where a ray ends.
//
// Stages: shapes come from the engine and are kept while they are right; what is drawn of large
// fields; colliders without a size; then rays at the ground, a cylinder and a box.
#include "derived/collider_shape.h"
#include "look/collider_geometry.h"
#include "registered_test.h"

#include <QtTest>

#include <vtkPointData.h>

#include <cmath>

namespace ripstop::test_collider_geometry {

namespace {

Scene sceneOf(ColliderShape shape)
{
    Collider collider;
    collider.shape = shape;
    collider.size = Vec3(4.0, 1.0, 8.0);
    Scene scene;
    scene.items.push_back({Id{1}, collider});
    scene.nextId = Id{2};
    return scene;
}

Collider& colliderOf(Scene& scene) { return std::get<Collider>(scene.items.front().item); }

// The body of the collider, as the engine has made its shape.
ColliderBody bodyOf(const Scene& scene)
{
    (void)gridOf(scene, std::get<Collider>(scene.items.front().item));
    return bodiesOf(scene, {}).front();
}

} // namespace

class TestColliderGeometry : public QObject
{
    Q_OBJECT

private slots:
    // The view does not make hills itself; with others it waits, and shows those of before. Where
    // they will be is known by their size, so that the view can go there.
    void shapesOfTheEngineAreTaken()
    {
        Scene scene = sceneOf(ColliderShape::HeightField);
        colliderOf(scene).seed = 4711; // a seed that no other test has used
        std::vector<ColliderBody> bodies = bodiesOf(scene, {});
        QVERIFY(bodies.front().isLate && !bodies.front().surface);
        Eigen::AlignedBox3d around;
        for (const Vec3& corner : cornersOf(bodies.front(), Vec3::Zero()))
            around.extend(corner);
        QCOMPARE(around.sizes(), colliderOf(scene).size);
        const auto grid = gridOf(scene, colliderOf(scene));
        bodies = bodiesOf(scene, std::move(bodies));
        QVERIFY(!bodies.front().isLate && bodies.front().surface);
        QCOMPARE(bodies.front().grid, *grid);
        colliderOf(scene).seed = 4712;
        bodies = bodiesOf(scene, std::move(bodies));
        QVERIFY(bodies.front().isLate);
        QCOMPARE(bodies.front().grid, *grid);
        colliderOf(scene).file = "no/such.png"; // what is not there cannot be waited for
        bodies = bodiesOf(scene, std::move(bodies));
        QVERIFY(!bodies.front().isLate && !bodies.front().surface);
    }

    void surfacesAreKeptWhileTheyAreRight()
    {
        Scene scene = sceneOf(ColliderShape::HeightField);
        std::vector<ColliderBody> bodies{bodyOf(scene)};
        const auto surface = bodies.front().surface;
        QVERIFY(surface);
        colliderOf(scene).position = Vec3(1.0, 2.0, 3.0);
        colliderOf(scene).turn = Vec3(0.0, 30.0, 0.0);
        colliderOf(scene).friction = 0.9;
        bodies = bodiesOf(scene, std::move(bodies));
        QCOMPARE(bodies.front().surface, surface);
        QCOMPARE(bodies.front().collider.position, Vec3(1.0, 2.0, 3.0));
        colliderOf(scene).size.y() = 2.0;
        bodies = bodiesOf(scene, std::move(bodies));
        QVERIFY(bodies.front().surface != surface);
        scene.items.clear();
        QVERIFY(bodiesOf(scene, std::move(bodies)).empty());
    }

    // What is drawn of a large field is coarser than the field, and as wide.
    void largeFieldsAreDrawnCoarsely()
    {
        Scene scene = sceneOf(ColliderShape::HeightField);
        colliderOf(scene).grid = 2000;
        const ColliderBody body = bodyOf(scene);
        QCOMPARE(body.surface->GetNumberOfPoints(), vtkIdType(512 * 512));
        double bounds[6];
        body.surface->GetBounds(bounds);
        QCOMPARE(bounds[0], -2.0);
        QCOMPARE(bounds[1], 2.0);
        QCOMPARE(bounds[4], -4.0);
        QCOMPARE(bounds[5], 4.0);
        colliderOf(scene).grid = 16;
        QCOMPARE(bodyOf(scene).surface->GetNumberOfPoints(), vtkIdType(16 * 16));
    }

    void withoutASizeThereIsNothing_data()
    {
        QTest::addColumn<double>("width");
        QTest::newRow("none") << 0.0;
        QTest::newRow("negative") << -3.0;
    }
    void withoutASizeThereIsNothing()
    {
        QFETCH(double, width);
        for (const ColliderShape shape : {ColliderShape::HeightField, ColliderShape::Box}) {
            Scene scene = sceneOf(shape);
            colliderOf(scene).size = Vec3(width, 1.0, 2.0);
            const ColliderBody body = bodyOf(scene);
            if (shape == ColliderShape::HeightField) {
                QVERIFY(!body.surface && cornersOf(body, Vec3::Zero()).empty());
                QVERIFY(std::isinf(
                    distanceTo(body, Vec3::Zero(), Vec3(0.0, 9.0, 0.0), -Vec3::UnitY())));
            }
        }
    }

    // Straight down onto the flat field; and past it.
    void raysMeetTheGround()
    {
        Scene scene = sceneOf(ColliderShape::HeightField);
        colliderOf(scene).size.y() = 0.0;
        const ColliderBody flat = bodyOf(scene);
        const Vec3 place(0.0, 1.0, 0.0);
        QCOMPARE(distanceTo(flat, place, Vec3(1.5, 4.0, 3.0), -Vec3::UnitY()), 3.0);
        QVERIFY(std::isinf(distanceTo(flat, place, Vec3(2.5, 4.0, 3.0), -Vec3::UnitY())));
        QVERIFY(std::isinf(distanceTo(flat, place, Vec3(1.5, 4.0, 3.0), Vec3::UnitY())));

        // a field as long as a runway and a hand wide takes no longer
        colliderOf(scene).size = Vec3(1e6, 1.0, 0.1);
        const Vec3 slant = Vec3(1.0, -1e-6, 0.0).normalized();
        const double t = distanceTo(bodyOf(scene), Vec3::Zero(), Vec3(-6e5, 1.5, 0.0), slant);
        QVERIFY(t > 1e5 - 1.0 && t < 1.1e6 + 1.0);
    }

    // What rays meet of a cylinder that lies along z: its side, a cap, and nothing beside it.
    void raysMeetACylinder()
    {
        Scene scene = sceneOf(ColliderShape::Cylinder);
        colliderOf(scene).radius = 0.5;
        colliderOf(scene).size = Vec3(4.0, 6.0, 8.0); // only the height counts
        colliderOf(scene).turn = Vec3(90.0, 0.0, 0.0);
        const ColliderBody drum = bodyOf(scene);
        const Vec3 place(0.0, 1.0, 0.0);
        const auto meets = [&](const Vec3& from, const Vec3& way) {
            return distanceTo(drum, place, from, way);
        };
        QVERIFY(std::abs(meets(Vec3(0.3, 4.0, 2.9), -Vec3::UnitY()) - 2.6) < 1e-12);
        QVERIFY(std::abs(meets(Vec3(0.3, 1.2, 9.0), -Vec3::UnitZ()) - 6.0) < 1e-12);
        QVERIFY(std::isinf(meets(Vec3(0.3, 4.0, 3.1), -Vec3::UnitY())));
        QVERIFY(std::isinf(meets(Vec3(0.6, 4.0, 0.0), -Vec3::UnitY())));
        QVERIFY(std::isinf(meets(Vec3(0.3, 4.0, 0.0), Vec3::UnitY())));

        // it is drawn with its caps; each rim has two normals, so that it is an edge
        double bounds[6];
        drum.surface->GetBounds(bounds);
        QVERIFY(std::abs(bounds[3] - 3.0) < 1e-6 && std::abs(bounds[1] - 0.5) < 0.02);
        QVERIFY(drum.surface->GetPointData()->GetNormals());
        QCOMPARE(drum.surface->GetNumberOfPoints(), vtkIdType(2 * (2 * 72 + 1)));
        Eigen::AlignedBox3d around;
        for (const Vec3& corner : cornersOf(drum, place))
            around.extend(corner);
        QVERIFY((around.sizes() - Vec3(1.0, 1.0, 6.0)).norm() < 1e-12);
    }

    void raysMeetABox()
    {
        Scene scene = sceneOf(ColliderShape::Box);
        colliderOf(scene).turn = Vec3(0.0, 90.0, 0.0); // 8 m along x now
        const ColliderBody box = bodyOf(scene);
        QCOMPARE(distanceTo(box, Vec3::Zero(), Vec3(-10.0, 0.0, 0.0), Vec3::UnitX()), 6.0);
        QCOMPARE(cornersOf(box, Vec3::Zero()).size(), std::size_t(8));
    }
};

const RegisteredTest registered("test_collider_geometry", runPlain<TestColliderGeometry>);

} // namespace ripstop::test_collider_geometry
#include "test_collider_geometry.moc"
