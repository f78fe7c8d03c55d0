// The 3D view: what is drawn, what clicks meet, and how the camera moves.
//
// Stages: pictures of one red panel tell by their pixels whether panels and arrows are drawn; then
// torn panels, following cameras, clicks, drags of hands and controls, turning and zooming.
#include "tools/pointing.h"
#include "views/front_view.h"
#include "views/run_with_widgets.h"

#include "compile/compile.h"
#include "document/recordings.h"
#include "layers/wind_layer.h"
#include "look/steady_range.h"
#include "simulation/simulation.h"
#include "tools/hand.h"

#include <Eigen/Geometry>
#include <QApplication>
#include <QMouseEvent>
#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_viewport {

namespace {

using View = FrontView;

} // namespace

class TestViewport : public QObject
{
    Q_OBJECT

private slots:
    void arrowsGoWithWhatTheyStoodOn()
    {
        Scene scene = redPanel();
        for (Particle& row : std::get<Part>(*findItem(scene, Id{1})).particles)
            row.velocity = Vec3(0, 5, 0), row.pinned = false, row.mass = 1.0;
        View view(scene);
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        view.viewport.setVectors(Vectors::Velocity);
        QTRY_VERIFY(view.player.frame());
        view.viewport.setPanelsShown(false);
        view.viewport.setLinksShown(false);
        const QImage with = view.viewport.image();
        view.viewport.setVectors(Vectors::None);
        QVERIFY(view.viewport.image() != with);
        view.viewport.setVectors(Vectors::Velocity);
        view.document.replace(Scene{});
        QTRY_VERIFY(view.player.frame() && view.player.frame()->position.empty());
        QVERIFY(view.viewport.image() != with);
    }

    void panelsAreDrawnInTheColourOfTheirMaterial()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        QVERIFY(isReddish(view.middle()));
        view.viewport.setPanelsShown(false);
        QVERIFY(!isReddish(view.middle()));
    }

    // A particle that nothing holds has a dot, also where particles are not shown; the corners of
    // fabric then have none.
    void looseParticlesAreAlwaysDrawn()
    {
        Scene scene;
        Part part;
        part.particles.push_back({.id = Id{2}, .position = Vec3(0, 1, 0)});
        scene.items = {{Id{1}, part}};
        scene.nextId = Id{7};
        View view(scene);
        view.viewport.setParticlesShown(false);
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const auto picture = [&] { return view.viewport.image(Viewport::Overlays::Without); };
        const QImage alone = picture();
        view.viewport.setParticlesShown(true);
        QCOMPARE(picture(), alone);
        view.viewport.setParticlesShown(false);
        view.document.push(setValue(scene, Id{1}, "shown", false));
        QVERIFY(picture() != alone);

        Scene held = redPanel();
        for (Particle& corner : std::get<Part>(held.items[0].item).particles) {
            corner.pinned = false;
            corner.mass = corner.id == Id{2} ? 1.0 : 1e-3; // kg, this one is drawn as a weight
        }
        View fabric(held);
        fabric.viewport.setParticlesShown(false);
        QTRY_VERIFY(fabric.player.frame());
        const QImage bare = fabric.viewport.image(Viewport::Overlays::Without);
        fabric.viewport.setParticlesShown(true);
        QVERIFY(fabric.viewport.image(Viewport::Overlays::Without) != bare);
    }

    // Arrows stand on multiples of their step above the ground and show the wind of their place,
    // gust included.
    void windFieldIsSampled()
    {
        Scene scene = redPanel();
        Wind shear{.name = "shear", .velocity = Vec3(6, 0, 0)};
        shear.kind = WindKind::PowerLaw;
        scene.items.push_back({Id{7}, shear});
        const Vec3 gust(0.0, 0.5, -1.0);
        const Eigen::AlignedBox3d bounds(Vec3(-2.0, 4.0, -1.0), Vec3(2.0, 9.0, 1.0));
        const std::vector<WindArrow> arrows = windField(scene, gust, bounds);
        QVERIFY(arrows.size() > 50);
        double lowest = 1e9;
        double highest = 0.0;
        for (const WindArrow& arrow : arrows) {
            QVERIFY(arrow.place.y() > 0.0);
            const double expected = 6.0 * std::pow(arrow.place.y() / 10.0, 1.0 / 7.0);
            QVERIFY((arrow.velocity - gust - Vec3(expected, 0, 0)).norm() < 1e-12);
            lowest = std::min(lowest, arrow.place.y());
            highest = std::max(highest, arrow.place.y());
        }
        QVERIFY(lowest < 4.0 && highest > 9.0);
        const Eigen::AlignedBox3d moved(Vec3(-1.9, 4.1, -0.9), Vec3(2.1, 9.1, 1.1));
        QCOMPARE(windField(scene, gust, moved).front().place, arrows.front().place);
        QVERIFY(windField(redPanel(), Vec3::Zero(), bounds).empty()); // calm
    }

    void windFieldIsDrawn()
    {
        Scene scene = redPanel();
        scene.items.push_back({Id{7}, Wind{.name = "wind", .velocity = Vec3(6, 0, 0)}});
        View view(scene);
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const QImage calm = view.viewport.image(Viewport::Overlays::Without);
        view.viewport.setWindFieldShown(true);
        QVERIFY(view.viewport.image(Viewport::Overlays::Without) != calm);
        view.viewport.setWindFieldShown(false);
        QCOMPARE(view.viewport.image(Viewport::Overlays::Without), calm);
    }

    void panelsFollowFrames()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        view.viewport.setFollow(false);
        auto moved = std::make_shared<Frame>(*view.player.frame());
        for (Vec3& place : moved->position)
            place.x() += 5.0;
        view.viewport.show(moved);
        QVERIFY(!isReddish(view.middle()));
        view.viewport.show(view.player.frame());
        QVERIFY(isReddish(view.middle()));
    }

    void whatIsTornAwayVanishes()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        auto torn = std::make_shared<Frame>(*view.player.frame());
        torn->gone[0] = 1;
        view.viewport.show(torn);
        QVERIFY(!isReddish(view.middle()));
    }

    // In steps of one frame at 11 m/s, a following camera must keep the panel where it was.
    void aFollowingCameraKeepsTheFabricInPlace()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        auto moving = std::make_shared<Frame>(*view.player.frame());
        for (int i = 0; i < 60; ++i) {
            moving = std::make_shared<Frame>(*moving);
            for (Vec3& place : moving->position)
                place.x() += 11.0 / 60.0;
            view.viewport.show(moving);
        }
        QVERIFY(isReddish(view.middle()));
    }

    // A run that begins anew is looked for where the camera sees nothing of it, as after a close
    // look at another place of the flight before; a camera that sees some of it stays, and so does
    // one before a design that is edited at rest.
    void aRunThatBeginsAnewIsSeen()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        auto anew = std::make_shared<Frame>(*view.player.frame());
        ++anew->run;
        const double seen = view.viewport.camera().distance;
        view.viewport.show(anew);
        QCOMPARE(view.viewport.camera().distance, seen);

        Camera elsewhere = view.viewport.camera();
        elsewhere.focus = Vec3(0, -20, 0);
        elsewhere.distance = 0.1;
        view.viewport.look(elsewhere);
        anew = std::make_shared<Frame>(*anew);
        anew->step = 100;
        view.viewport.show(anew); // goes on: the person looks where the person wants
        QVERIFY(!isReddish(view.middle()));
        anew = std::make_shared<Frame>(*anew);
        anew->step = 0;
        ++anew->run;
        view.viewport.show(anew);
        QVERIFY(isReddish(view.middle()));
    }

    // Colours of values stay those of the legend: an outline marks what is selected then.
    void theSelectionLeavesColoursOfValues()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        for (const ColorBy colorBy : {ColorBy::Strain, ColorBy::PanelLoad, ColorBy::Material})
            for (const Id selected : {Id{5}, Id{1}}) { // the panel, the part
                view.selection.set({});
                view.viewport.setColorBy(colorBy);
                const QColor bare = view.middle();
                const QImage without = view.viewport.image();
                view.selection.set({selected});
                QCOMPARE(view.middle() == bare, colorBy != ColorBy::Material);
                QVERIFY(view.viewport.image() != without);
            }
    }

    void clicksSelect()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        QCOMPARE(view.viewport.pick({200, 160}), Id{5});
        QCOMPARE(view.viewport.pick({2, 2}), noId);
        QTest::mouseClick(&view.viewport, Qt::LeftButton, {}, {200, 160});
        QCOMPARE(view.selection.ids(), std::vector{Id{5}});
        QTest::mouseClick(&view.viewport, Qt::LeftButton, {}, {2, 2});
        QVERIFY(view.selection.ids().empty());
    }

    // Particles have no dots here, and are not pinned: a click near a corner takes it, and one on
    // the middle of the panel the panel.
    void cornersOfFabricArePicked()
    {
        Scene scene = redPanel();
        for (Particle& particle : std::get<Part>(scene.items[0].item).particles)
            particle.pinned = false;
        View view(std::move(scene));
        view.viewport.setParticlesShown(false);
        QTRY_VERIFY(view.player.frame());
        // Where it is now: a window that is shown late is laid out anew, and the camera with it.
        const auto corner = [&] {
            const double aspect = double(view.viewport.width()) / view.viewport.height();
            const Eigen::Vector4d p =
                view.viewport.camera().projection(aspect) * Vec3(-1, -1, 0).homogeneous();
            return QPointF(0.5 * view.viewport.width() * (1.0 + p.x() / p.w()),
                           0.5 * view.viewport.height() * (1.0 - p.y() / p.w()));
        };
        QCOMPARE(view.viewport.pick(corner()), Id{2});
        QCOMPARE(view.viewport.pick(corner() + QPointF(3, -1)), Id{2});
        QCOMPARE(view.viewport.pick(corner() + QPointF(30, -10)), Id{5});
        QCOMPARE(view.viewport.pick({200, 160}), Id{5});
        const auto near = [&] { return corner() + QPointF(2, -1); };
        // It also hears late that the real mouse is elsewhere: this one moves until then.
        const auto hovered = [&] {
            QMouseEvent move(QEvent::MouseMove, near(), view.viewport.mapToGlobal(near()),
                             Qt::NoButton, Qt::NoButton, Qt::NoModifier);
            QApplication::sendEvent(&view.viewport, &move);
            QTest::qWait(50); // longer than from a move to a look
            return view.viewport.pointing().hovered();
        };
        bool isTaken = false; // once is enough: QTRY_COMPARE would move the mouse once more
        QTRY_VERIFY(isTaken = isTaken || hovered() == Id{2}); // what a click takes
        QTest::mouseClick(&view.viewport, Qt::LeftButton, {}, near().toPoint());
        QCOMPARE(view.selection.ids(), std::vector{Id{2}});
    }

    // Ghosts beside the panel are in the picture with it, and the camera goes back when they go,
    // unless somebody has moved it meanwhile.
    void ghostsBesideAreSeenWhole()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        Camera mine = view.viewport.camera();
        mine.distance *= 0.8;
        mine.azimuth += 0.2;
        view.viewport.look(mine);
        const auto beside = [&](double x) {
            auto frame = std::make_shared<Frame>(*view.player.frame());
            for (Vec3& place : frame->position)
                place.x() += x;
            return GhostFrame{frame, {}, Vec3(x, 0.0, 0.0)};
        };
        const auto sees = [&](double x) {
            const double aspect = double(view.viewport.width()) / view.viewport.height();
            const Eigen::Vector4d at =
                view.viewport.camera().projection(aspect) * Eigen::Vector4d(x, 0.0, 0.0, 1.0);
            return std::abs(at.x()) < at.w() && std::abs(at.y()) < at.w();
        };
        QVERIFY(!sees(12.0));
        view.viewport.showGhosts({beside(-6.0), beside(6.0), beside(12.0)});
        QVERIFY(sees(13.0) && sees(-7.0));
        view.viewport.showGhosts({});
        QCOMPARE(view.viewport.camera().distance, mine.distance);
        QVERIFY(view.viewport.camera().focus == mine.focus);
        view.viewport.showGhosts({beside(0.0)}); // over it: as before
        QCOMPARE(view.viewport.camera().distance, mine.distance);
        view.viewport.showGhosts({beside(12.0)});
        Camera moved = view.viewport.camera();
        moved.distance *= 1.1;
        view.viewport.look(moved);
        view.viewport.showGhosts({});
        QCOMPARE(view.viewport.camera().distance, moved.distance);
    }

    // What is dragged along axes in the picture stays under the cursor; along an axis that points
    // at the eye nothing moves.
    void theHandFollowsTheCursor()
    {
        Scene scene = redPanel();
        const auto control = [&](std::uint32_t id, const Vec3& axis) {
            Control row;
            row.targets = {Id{4}};
            row.axis = axis;
            scene.items.push_back({Id{id}, row});
        };
        control(7, Vec3(2.0, 0.0, 0.0));
        control(8, Vec3(0.0, 1.0, 0.0));
        control(9, Vec3(0.0, 0.0, 1.0));
        QVERIFY(Hand(scene, Id{2}, Vec3::Zero()).isEmpty());
        const Hand hand(scene, Id{4}, Vec3(0.3, 0.2, 0.0));
        QCOMPARE(hand.controls(), (std::vector{Id{7}, Id{8}, Id{9}}));
        Camera camera;
        for (const bool orthographic : {true, false}) {
            camera.orthographic = orthographic;
            const double perPixel = 2.0 * camera.halfHeight() / 300.0;
            const std::vector<double> pull = hand.pull(camera, 300.0, 40.0, -20.0);
            QVERIFY(std::abs(pull[0] - 40.0 * perPixel) < 0.002 * 40.0 * perPixel);
            QVERIFY(std::abs(pull[1] - 20.0 * perPixel) < 0.002 * 20.0 * perPixel);
            QVERIFY(std::abs(pull[2]) < 1e-9);
        }
    }

    void controlDragSteers()
    {
        Scene scene = redPanel();
        Collider ball;
        ball.shape = ColliderShape::Sphere;
        ball.position = {0.0, -0.3, 2.0};
        scene.items.push_back({Id{7}, ball});
        Control control;
        control.targets = {Id{7}};
        control.limit = 0.25;
        scene.items.push_back({Id{8}, control});
        scene.nextId = Id{9};
        View view(scene);
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        QTRY_COMPARE(view.viewport.pick({200, 160}), Id{7});
        const double azimuth = view.viewport.camera().azimuth;
        const auto move = [&](QPointF to) {
            QMouseEvent event(QEvent::MouseMove, to, view.viewport.mapToGlobal(to), Qt::NoButton,
                              Qt::LeftButton, Qt::ControlModifier);
            QApplication::sendEvent(&view.viewport, &event);
        };
        QTest::mousePress(&view.viewport, Qt::LeftButton, Qt::ControlModifier, {200, 160});
        move({215, 160});
        const double gone = view.player.commandOf(Id{8});
        QVERIFY2(gone > 0.01 && gone < 0.25, qPrintable(QString::number(gone)));
        move({460, 160});
        QCOMPARE(view.player.commandOf(Id{8}), 0.25); // its limit
        move({200, 160});
        QVERIFY(std::abs(view.player.commandOf(Id{8})) < 1e-12); // back where it was
        QTest::mouseRelease(&view.viewport, Qt::LeftButton, Qt::ControlModifier, {200, 160});
        QCOMPARE(view.viewport.camera().azimuth, azimuth);
        QVERIFY(view.selection.ids().empty());
    }

    // Whatever is done to it, the camera never rolls: its right stays level and its up upwards.
    void theHorizonStaysLevel()
    {
        Camera camera;
        for (int i = 0; i < 200; ++i) {
            camera.orbit(37.0 * (i % 5) - 60.0, 23.0 * (i % 7) - 70.0);
            QVERIFY(std::abs(camera.right().y()) < 1e-12);
            QVERIFY(camera.up().y() >= 0.0);
            QVERIFY(std::abs(camera.elevation) <= 0.5 * std::numbers::pi);
        }
    }

    void zoomKeepsThePointUnderTheCursor()
    {
        Camera camera;
        camera.distance = 10.0;
        const double aspect = 4.0 / 3.0;
        const double x = 0.5;
        const double y = -0.25;
        const auto under = [&](const Camera& c) -> Vec3 {
            return c.focus + c.halfHeight() * (aspect * x * c.right() + y * c.up());
        };
        const Vec3 before = under(camera);
        camera.zoom(0.5, x, y, aspect);
        QCOMPARE(camera.distance, 5.0);
        QVERIFY((under(camera) - before).norm() < 1e-12);
    }
};

const RegisteredTest registered("test_viewport", runWithView<TestViewport>);

} // namespace ripstop::test_viewport
#include "test_viewport.moc"
