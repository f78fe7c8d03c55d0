// Sky, horizon and ground: where the horizon is seen, and which scenes have one.
#include "camera/camera_projection.h"
#include "layers/backdrop_layer.h"
#include "layers/ground_layer.h"
#include "look/collider_geometry.h"
#include "look/shadow_map.h"
#include "views/bare_view.h"
#include "views/run_with_widgets.h"

#include <Eigen/Geometry>

namespace ripstop::test_backdrop {

namespace {

constexpr QSize size(400, 300);

// A red panel 50 m up, and the ground if wanted. Ids: part 1, particles 2, 3, 4, panel 5, material
// 6, ground 7.
Scene panelAbove(bool ground)
{
    Scene scene;
    Part part;
    part.particles.push_back({.id = Id{2}, .position = Vec3(-1, 50, 0), .pinned = true});
    part.particles.push_back({.id = Id{3}, .position = Vec3(1, 50, 0), .pinned = true});
    part.particles.push_back({.id = Id{4}, .position = Vec3(0, 51, 0), .pinned = true});
    part.panels.push_back({Id{5}, Id{2}, Id{3}, Id{4}, Id{6}});
    scene.items = {{Id{1}, part}, {Id{6}, Material{}}};
    if (ground)
        scene.items.push_back({Id{7}, Collider{}});
    scene.nextId = Id{8};
    return scene;
}

struct View : BareView
{
    explicit View(Scene scene)
        : BareView(std::move(scene), size)
    {
        viewport.setTheme(Theme::light());
    }
    QImage seenFrom(const Camera& camera, Backdrop backdrop = Backdrop::Scenery)
    {
        viewport.look(camera);
        return viewport.image(Viewport::Shot{size, Viewport::Overlays::Without, backdrop});
    }
};

Camera cameraAt(double height, double elevation)
{
    Camera camera;
    camera.distance = 20.0;
    camera.azimuth = 0.6;
    camera.elevation = elevation;
    camera.focus = Vec3(300.0, 0.0, -200.0);
    camera.focus.y() = height - camera.distance * std::sin(elevation);
    return camera;
}

// Largest difference of red, green and blue.
int difference(const QColor& a, const QColor& b)
{
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
                     std::abs(a.blue() - b.blue())});
}

} // namespace

class TestBackdrop : public QObject
{
    Q_OBJECT

private slots:
    void theHorizonIsLevelWithTheEye_data()
    {
        QTest::addColumn<double>("height");    // m
        QTest::addColumn<double>("elevation"); // rad
        QTest::newRow("standing") << 1.7 << 0.0;
        QTest::newRow("from a glider, down") << 186.0 << 0.2;
        QTest::newRow("from a kite, up") << 30.0 << -0.15;
        QTest::newRow("from far above") << 3000.0 << 0.1;
    }
    void theHorizonIsLevelWithTheEye()
    {
        QFETCH(const double, height);
        QFETCH(const double, elevation);
        View view(panelAbove(true));
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const Camera camera = cameraAt(height, elevation);
        const QImage image = view.seenFrom(camera);

        Vec3 level = -camera.back();
        level.y() = 0.0;
        const CameraProjection projection(camera, size.width(), size.height());
        const double y = projection(camera.eye() + 1e7 * level.normalized()).y;
        QVERIFY(y > 40.0 && y < 260.0);
        const QColor haze = Theme::light().skyBottom;
        for (const int x : {20, 380}) { // both ways, as the horizon is level in the picture
            QVERIFY(difference(image.pixelColor(x, int(y)), haze) <= 3);
            QVERIFY(difference(image.pixelColor(x, int(y) - 38), haze) > 8);
            QVERIFY(difference(image.pixelColor(x, int(y) + 38), haze) > 8);
        }
        // sky is bluer than haze, and what is on the ground is not
        const QColor sky = image.pixelColor(20, int(y) - 38);
        const QColor ground = image.pixelColor(20, int(y) + 38);
        QVERIFY(sky.blue() - sky.red() > haze.blue() - haze.red() + 8);
        QVERIFY(ground.blue() - ground.red() < haze.blue() - haze.red());
    }

    // The squares on the ground are ten times as wide ten times as high up.
    void squaresStepWithTheHeight()
    {
        const auto shown = [](double height) { return groundStep(height).mostSeen(); };
        QCOMPARE(shown(1.7), 1.0);
        QCOMPARE(shown(20.0), 10.0);
        QCOMPARE(shown(186.0), 100.0);
        QCOMPARE(groundStep(0.0).fine > 0.0, true);
    }

    // The same on slopes: powers of ten, of which five to fifty reach from the middle to the rim.
    void slopesHaveSquaresOfRoundMetres()
    {
        QCOMPARE(groundSquare(5.0), 1.0);
        QCOMPARE(groundSquare(49.0), 1.0);
        QCOMPARE(groundSquare(50.0), 10.0);
        QCOMPARE(groundSquare(0.5), 0.1);
    }

    // Neighbours differ as the two colours of ground do, and each has one.
    void slopesHaveSquaresOfTwoColours()
    {
        Scene scene = panelAbove(true);
        const Vec3 normal = Vec3(0.3, 1.0, 0.0).normalized();
        std::get<Collider>(*findItem(scene, Id{7})).normal = normal;
        View view(scene);
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const Eigen::AlignedBox3d shown(Vec3(-1, 50, 0), Vec3(1, 51, 0));
        const double side = groundSquare(groundRadius(shown));
        const Vec3 first = (Vec3::UnitX() - normal.x() * normal).normalized();
        const Vec3 second = first.cross(normal);
        const Vec3 below = shown.center() - shown.center().dot(normal) * normal;
        const auto middle = [&](double along, double across) {
            const auto number = [&](const Vec3& axis) {
                return std::floor(below.dot(axis) / side);
            };
            return Vec3((number(first) + along + 0.5) * side * first
                        + (number(second) + across + 0.5) * side * second);
        };
        Camera camera;
        camera.focus = middle(0, 0);
        camera.distance = 6.0 * side;
        camera.elevation = 0.9;
        const QImage image = view.seenFrom(camera);
        const CameraProjection projection(camera, size.width(), size.height());
        const auto seen = [&](double along, double across) {
            const auto place = projection(middle(along, across));
            return image.pixelColor(int(place.x), int(place.y));
        };
        QVERIFY(difference(seen(0, 0), seen(1, 0)) > 3);
        QVERIFY(difference(seen(0, 0), seen(0, 1)) > 3);
        QVERIFY(difference(seen(0, 0), seen(1, 1)) <= 3);
    }

    // On slopes and landscapes, where the sun's ray through the middle of the panel ends; beside
    // it, and where the fabric is not shown, there is none.
    void groundThatIsNotLevelHasShadows()
    {
        Scene slope = panelAbove(true);
        std::get<Collider>(*findItem(slope, Id{7})).normal = Vec3(0.3, 1.0, 0.0).normalized();
        Scene landscape = panelAbove(true);
        auto& hills = std::get<Collider>(*findItem(landscape, Id{7}));
        hills.shape = ColliderShape::HeightField;
        hills.size = Vec3(200.0, 4.0, 200.0);
        hills.hillLength = 100.0;
        hills.seed = 3;
        for (const Scene& scene : {slope, landscape}) {
            View view(scene);
            QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
            QTRY_VERIFY(view.player.frame());
            const Vec3 middle(0.0, 50.0 + 1.0 / 3.0, 0.0), ray = -sunDirection.normalized();
            const auto& ground = std::get<Collider>(*findItem(scene, Id{7}));
            double way = middle.dot(ground.normal) / -ray.dot(ground.normal); // of the slope
            if (ground.shape == ColliderShape::HeightField)
                way = distanceTo(bodiesOf(scene, {}).front(), ground.position, middle, ray);
            QVERIFY(way > 40.0 && way < 90.0);
            Camera camera;
            camera.focus = middle + way * ray;
            camera.distance = 8.0;
            camera.azimuth = std::atan2(sunDirection.x(), sunDirection.z()); // as the sun sees it
            camera.elevation = std::asin(-ray.y());
            const CameraProjection projection(camera, size.width(), size.height());
            const auto beside = projection(Vec3(camera.focus + 2.0 * camera.right()));
            const QImage with = view.seenFrom(camera);
            view.viewport.setPanelsShown(false);
            const QImage without = view.seenFrom(camera);
            const auto lightness = [](const QImage& image, int x, int y) {
                return image.pixelColor(x, y).lightness();
            };
            QVERIFY(lightness(with, 200, 150) < lightness(without, 200, 150) - 20);
            QCOMPARE(with.pixelColor(int(beside.x), int(beside.y)),
                     without.pixelColor(int(beside.x), int(beside.y)));
        }
    }

    // Without ground the backdrop is plain: the same wherever one looks.
    void withoutGroundTheBackdropIsPlain()
    {
        View view(panelAbove(false));
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const QImage one = view.seenFrom(cameraAt(5.0, 0.0));
        const QImage other = view.seenFrom(cameraAt(5.0, 0.5));
        for (const int y : {5, 150, 295})
            QCOMPARE(one.pixelColor(10, y), other.pixelColor(10, y));
    }

    // The ground hides what lies below it, and nothing that lies above.
    void theGroundHidesWhatIsBelow()
    {
        View view(panelAbove(true));
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        Camera camera;
        camera.focus = Vec3(0.0, 50.4, 0.0);
        camera.distance = 8.0;
        const auto isRed = [](const QColor& color) { return color.red() > 2 * color.blue(); };
        QVERIFY(isRed(view.seenFrom(camera).pixelColor(200, 150)));
        Scene sunk = panelAbove(true);
        std::get<Collider>(*findItem(sunk, Id{7})).position.y() = 52.0;
        view.document.replace(sunk);
        QTRY_VERIFY(view.player.frame());
        camera.elevation = 0.4; // from above the ground
        QVERIFY(!isRed(view.seenFrom(camera).pixelColor(200, 150)));
    }

    void papersGroundIsWhiteOrNothing()
    {
        View view(panelAbove(true));
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const Camera camera = cameraAt(30.0, 0.2);
        QCOMPARE(view.seenFrom(camera, Backdrop::White).pixelColor(20, 280), QColor(Qt::white));
        QCOMPARE(view.seenFrom(camera, Backdrop::White).pixelColor(20, 5), QColor(Qt::white));
        QCOMPARE(view.seenFrom(camera, Backdrop::Transparent).pixelColor(20, 280).alpha(), 0);
    }
};

const RegisteredTest registered("test_backdrop", runWithView<TestBackdrop>);

} // namespace ripstop::test_backdrop

#include "test_backdrop.moc"
