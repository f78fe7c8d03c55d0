// What the camera fits, and into which part of the picture: beside tools and bars, the first look
// at a design with its bridle, and the design of every builder as a whole.
#include "views/bare_view.h"
#include "views/run_with_widgets.h"

#include "builders/builder.h"
#include "camera/camera_projection.h"
#include "camera/chase.h"
#include "camera/overlay_margins.h"
#include "look/subject.h"
#include "overlays/compass.h"
#include "overlays/legend.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <cmath>

namespace ripstop::test_fitting {

namespace {

struct View : BareView
{
    explicit View(Scene scene)
        : BareView(std::move(scene), {400, 300})
    {
        viewport.view(PresetView::Front);
    }
};

} // namespace

class TestFitting : public QObject
{
    Q_OBJECT

private slots:
    // A parachute that lands takes the camera down with it, and not into the ground: what it looks
    // at stays above, and the eye by a fifth of its distance, or as low as a person has put it.
    void whatComesDownIsSeenFromAbove()
    {
        auto layout = std::make_shared<Layout>();
        layout->panelCorners = {{0, 1, 2}};
        Frame frame;
        frame.layout = layout;
        frame.gone = {0};
        const auto comeDown = [&](Camera& camera, double from) {
            Chase chase;
            for (double height = from; height >= 0.0; height -= 0.1) {
                frame.position = {{-1, height, 0}, {1, height, 1}, {0, height, -1}};
                frame.step += 1;
                chase.move(camera, frame, nullptr, 0.0);
            }
        };
        Camera camera;
        camera.elevation = 0.05; // rad
        camera.distance = 15.0;
        camera.focus = Vec3(0, 18, 0); // the fabric hangs 2 m above the middle of the picture
        comeDown(camera, 20.0);
        QCOMPARE(camera.focus.y(), 0.0);
        QVERIFY(std::abs(camera.eye().y() - 0.2 * 15.0) < 1e-9);

        camera.elevation = 0.0;
        camera.focus = Vec3(0, 0.5, 0); // at the height of the knees, as somebody likes it
        comeDown(camera, 2.0);
        QVERIFY(std::abs(camera.eye().y() - 0.5) < 1e-9);
    }

    // What rises again, as a parachute does that has landed when its run begins anew, is seen as it
    // was before it came down: the ground has lifted focus and eye only as long as it was there. A
    // camera that a person turns on the ground stays as it is turned.
    void whatRisesAgainIsSeenAsBefore()
    {
        auto layout = std::make_shared<Layout>();
        layout->panelCorners = {{0, 1, 2}};
        Frame frame;
        frame.layout = layout;
        frame.gone = {0};
        Camera camera;
        Chase chase;
        const auto fabricAt = [&](double height) {
            frame.position = {{-1, height, 0}, {1, height, 1}, {0, height, -1}};
            frame.step += 1;
            chase.move(camera, frame, nullptr, 0.0);
        };
        camera.elevation = 0.05; // rad
        camera.distance = 15.0;
        camera.focus = Vec3(0, 18, 0); // the fabric hangs 2 m above the middle of the picture
        fabricAt(20.0);
        for (int turn = 0; turn < 2; ++turn) {
            for (double height = 20.0; height >= 0.0; height -= 0.1)
                fabricAt(height);
            QVERIFY(camera.focus.y() >= 0.0 && camera.elevation > 0.1);
            fabricAt(20.0);
            QVERIFY(std::abs(camera.focus.y() - 18.0) < 1e-9);
            QVERIFY(std::abs(camera.elevation - 0.05) < 1e-9);
        }
        fabricAt(0.0);
        camera.elevation = 0.7;
        fabricAt(20.0);
        QCOMPARE(camera.elevation, 0.7);
    }

    // A design that is built again during a run begins a run of its own where it was: the camera
    // goes back there. What comes into a run that goes on leaves the camera where it is.
    void whatIsBuiltAgainIsFollowedToItsStart()
    {
        const auto frameOf = [](std::uint32_t panel, std::uint64_t run, std::int64_t step,
                                double height) {
            auto layout = std::make_shared<Layout>();
            layout->panelId = {panel};
            layout->panelCorners = {{0, 1, 2}};
            Frame frame;
            frame.layout = layout;
            frame.gone = {0};
            frame.run = run;
            frame.step = step;
            frame.position = {{-1, height, 0}, {1, height, 1}, {0, height, -1}};
            return frame;
        };
        Camera camera;
        camera.focus = Vec3(0, 120, 0);
        Chase chase;
        const Frame flown = frameOf(7, 1, 500, 120.0);
        chase.move(camera, flown, nullptr, 0.0);
        const Frame withMore = frameOf(8, 1, 501, 140.0);
        chase.move(camera, withMore, &flown, 0.0);
        QCOMPARE(camera.focus.y(), 120.0);
        const Frame builtAgain = frameOf(9, 2, 0, 150.0);
        chase.move(camera, builtAgain, &withMore, 0.0);
        QCOMPARE(camera.focus.y(), 130.0);
    }

    // Three panels that hang together and a fourth that a tear parts from them, for which it
    // doubles a particle: the fourth is blown away, and the camera stays with the three, from the
    // tear on. A link that holds keeps it with them, and of two equal pieces it goes along with
    // both.
    void whatIsTornIsFollowedByItsLargePieces()
    {
        Layout whole;
        whole.panelId = {10, 11, 12, 13};
        whole.particleId = {1, 2, 3, 4, 5, 6};
        whole.panelCorners = {{3, 4, 5}, {0, 1, 2}, {1, 2, 3}, {0, 2, 3}};
        Layout torn = whole;
        torn.particleId.push_back(4);
        torn.panelCorners[0][0] = 6;
        torn.links = {{9, LinkKind::Rod, 3, 4, 1.0}};
        Frame before;
        before.layout = std::make_shared<Layout>(whole);
        before.gone = {0, 0, 0, 0};
        before.position.assign(6, Vec3(0, 10, 0));
        Frame frame = before;
        frame.layout = std::make_shared<Layout>(torn);
        frame.step = 1;
        frame.position.assign(7, Vec3(0, 11, 0));
        frame.position[4] = frame.position[5] = frame.position[6] = Vec3(60, 11, 0);
        frame.tears.resize(1);
        const auto along = [&](bool holds, std::vector<std::uint8_t> gone) {
            frame.torn = {std::uint8_t(holds ? 0 : 1)};
            frame.gone = std::move(gone);
            Camera camera;
            camera.focus = Vec3(1, 10, 0);
            Chase chase;
            chase.settle(&before);
            chase.move(camera, frame, &before, -100.0);
            return camera.focus.x() - 1.0;
        };
        QCOMPARE(along(false, {0, 0, 0, 0}), 0.0);
        QCOMPARE(along(true, {0, 0, 0, 0}), 15.0);  // a quarter of its panels goes 60 m
        QCOMPARE(along(false, {0, 0, 1, 1}), 30.0); // a half
    }

    // The wind is read over fabric as dark as its words, or as bright: they lie on a card.
    void wordsOfTheCompassAreRead()
    {
        for (const Theme& theme : {Theme::light(), Theme::dark()}) {
            Compass compass;
            compass.setTheme(theme);
            compass.setWind(Vec3(6.0, 0.0, 0.0));
            compass.setSquares(10.0);
            QImage picture(compass.size(), QImage::Format_RGB32);
            picture.fill(theme.text);
            compass.render(&picture, {}, {}, QWidget::RenderFlags{});
            int card = 0; // pixels around the words that are told from them
            for (int x = 0; x < picture.width(); ++x)
                for (int y = picture.width() - 4; y < picture.height(); ++y)
                    card += std::abs(picture.pixelColor(x, y).lightness() - theme.text.lightness())
                            > 100;
            QVERIFY2(card > 1500, qPrintable(QString::number(card))); // two lines of 80 x 14
        }
    }

    // Who hangs below a parachute is in the picture when that is fitted.
    void whoHangsIsFitted()
    {
        const Scene scene = *build(*findBuilder("parachute"), {});
        View view(scene);
        std::vector<Id> parts;
        forEachPart(scene, [&](Id id, const Part&) { parts.push_back(id); });
        const auto seenAt = [&](double metres) { // below the point where the lines meet
            Vec3 foot = Vec3(0, 1e9, 0);
            for (const Vec3& place : view.viewport.frame()->position)
                if (place.y() < foot.y())
                    foot = place;
            foot.y() -= metres;
            const auto pixel = CameraProjection(view.viewport.camera(), 400, 300).pixel(foot);
            return pixel && QRectF(0, 0, 400, 300).contains(*pixel);
        };
        view.viewport.fit(parts);
        QVERIFY(seenAt(1.75)); // m, as tall as they are
        view.viewport.setPeopleShown(false);
        view.viewport.fit(parts);
        QVERIFY(!seenAt(1.75));
    }

    // What tools and a legend cover stays free of what is fitted, in both kinds of picture.
    void fittingSparesWhatIsCovered()
    {
        std::vector<Vec3> points;
        for (int i = 0; i < 200; ++i)
            points.emplace_back(3.0 * std::sin(1.7 * i), 1.0 * std::cos(2.9 * i),
                                2.0 * std::sin(0.3 * i));
        constexpr double aspect = 1.4;
        const OverlayMargins covered{.left = 0.1, .right = 0.2, .top = 0.05, .bottom = 0.15};
        for (const bool orthographic : {false, true}) {
            Camera camera;
            camera.look(PresetView::Iso);
            camera.orthographic = orthographic;
            camera.fit(points, aspect, covered);
            double left = 2.0, right = -2.0, top = -2.0, bottom = 2.0;
            const Eigen::Matrix4d projection = camera.projection(aspect);
            for (const Vec3& point : points) {
                const Eigen::Vector4d p = projection * point.homogeneous();
                left = std::min(left, p.x() / p.w());
                right = std::max(right, p.x() / p.w());
                bottom = std::min(bottom, p.y() / p.w());
                top = std::max(top, p.y() / p.w());
            }
            QVERIFY(left >= -0.8 && right <= 0.6 && top <= 0.9 && bottom >= -0.7);
            const bool isWide = right - left > 0.85 * 1.4 && right - left <= 1.4;
            const bool isHigh = top - bottom > 0.85 * 1.6 && top - bottom <= 1.6;
            QVERIFY(isWide || isHigh); // as large as it can be, but for the margin
        }
    }

    // Tools at the side and bars below cover something; a label across the middle, a compass in the
    // corner and what is hidden do not.
    void marginsAreThoseOfToolsAndBars()
    {
        QWidget view;
        view.resize(800, 600);
        const auto child = [&](const QRect& place) {
            auto* made = new QWidget(&view);
            made->setGeometry(place);
            made->show();
            return made;
        };
        child({0, 10, 40, 400});
        child({10, 500, 90, 90});
        child({200, 250, 400, 40});
        QCOMPARE(overlayMarginsOf(view).bottom, 0.0);
        QWidget* const bar = child({100, 480, 600, 110});
        const OverlayMargins margins = overlayMarginsOf(view);
        QVERIFY(std::abs(margins.left - 40.0 / 800.0) < 0.002);
        QCOMPARE(margins.right, 0.0);
        QCOMPARE(margins.top, 0.0);
        QVERIFY(std::abs(margins.bottom - 120.0 / 600.0) < 1e-9);
        bar->hide();
        QCOMPARE(overlayMarginsOf(view).bottom, 0.0);
        child({680, 10, 110, 180}); // a legend, upright but less than a third of the height
        QVERIFY(std::abs(overlayMarginsOf(view).right - 120.0 / 800.0) < 1e-9);
        const std::size_t others = overlaysOf(view).size();
        child(view.rect())->lower(); // the picture is under them, and covers nothing
        QCOMPARE(overlaysOf(view).size(), others);
        QCOMPARE(others, std::size_t(4));
    }

    // A legend that comes over a design that nobody has turned or moved leaves it in sight; a
    // camera that a person placed stays where it is.
    void aLegendThatComesCoversNothing()
    {
        View view(*build(*findBuilder("cloth"), {}));
        view.viewport.resize(800, 600);
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const auto rightmost = [&] {                                // pixel
            (void)view.viewport.image(Viewport::Overlays::Without); // as when it is painted
            const CameraProjection project(view.viewport.camera(), view.viewport.width(),
                                           view.viewport.height());
            double most = 0.0;
            for (const Vec3& place : view.viewport.frame()->position)
                most = std::max(most, project.pixel(place)->x());
            return most;
        };
        view.viewport.view(PresetView::Front);
        QTRY_VERIFY(rightmost() > 400.0);
        view.viewport.setColorBy(ColorBy::Strain);
        QTRY_VERIFY(!view.viewport.legend().isHidden());
        QVERIFY(rightmost() < view.viewport.legend().geometry().left());

        Camera mine = view.viewport.camera();
        mine.distance *= 0.7;
        view.viewport.look(mine);
        view.viewport.setColorBy(ColorBy::Material);
        (void)rightmost();
        QCOMPARE(view.viewport.camera().distance, mine.distance);
    }

    // The first look is at the sail with its bridle, of which the tow point is where three lines or
    // more meet; the hand at the end of the line is too far away for that.
    void theFirstLookHasTheBridle_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("four legs") << "rectangular_kite";
        QTest::newRow("two legs") << "diamond_kite";
    }

    void theFirstLookHasTheBridle()
    {
        QFETCH(QString, name);
        const Scene scene = *build(*findBuilder(name.toStdString()), {});
        const Part* part = nullptr;
        forEachPart(scene, [&](Id, const Part& one) { part = &one; });
        const std::vector<Id> points = bridlePoints(scene, *part);
        QCOMPARE(points.size(), std::size_t(1));
        View view(scene);
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        view.viewport.view(PresetView::Top); // the picture has no more than it needs
        view.viewport.view(PresetView::Front);
        const Camera& camera = view.viewport.camera();
        const CameraProjection project(camera, view.viewport.width(), view.viewport.height());
        const auto isSeen = [&](const Vec3& place) {
            const auto pixel = project.pixel(place);
            return pixel && QRectF(view.viewport.rect()).contains(*pixel);
        };
        QVERIFY(isSeen(findRow(part->particles, points.front())->position));
        const auto hand = std::ranges::find_if(part->particles, &Particle::pinned);
        QVERIFY(!isSeen(hand->position));
    }

    // A kite that climbs to twice its height takes the camera with it, and who holds it stays in
    // the picture, until a person moves the camera. What has broken away is not followed without
    // end: the fabric stays then where it is in the picture, and the hand goes.
    void whatWasFittedStaysInThePicture()
    {
        const Scene scene = *build(*findBuilder("rectangular_kite"), {});
        View view(scene);
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const auto start = view.player.frame();
        const auto& pinned = start->layout->pinned;
        const auto hand = std::size_t(std::ranges::find(pinned, 1) - pinned.begin());
        const Vec3 place = start->position.at(hand);
        const auto fly = [&](double rise) { // m, of all but the hand
            auto frame = std::make_shared<Frame>(*start);
            frame->step = 100;
            for (std::size_t i = 0; i < pinned.size(); ++i)
                if (!pinned[i])
                    frame->position[i].y() += rise;
            view.viewport.show(frame);
            (void)view.viewport.image(Viewport::Overlays::Without); // as when it is painted
        };
        const auto isSeen = [&](const Vec3& point) {
            const Camera& camera = view.viewport.camera();
            const auto pixel =
                CameraProjection(camera, view.viewport.width(), view.viewport.height())
                    .pixel(point);
            return pixel && QRectF(view.viewport.rect()).contains(*pixel);
        };
        view.viewport.fit();
        QVERIFY(isSeen(place));
        const double height = start->position.front().y() - place.y(); // m, of the kite
        for (int i = 1; i <= 10; ++i) {
            fly(0.1 * i * height);
            QVERIFY2(isSeen(place), qPrintable(QString::number(i)));
            QVERIFY(isSeen(view.viewport.frame()->position.front()));
        }
        fly(100.0 * height);
        QVERIFY(!isSeen(place));
        QVERIFY(isSeen(view.viewport.frame()->position.front()));

        fly(0.0);
        view.viewport.fit();
        Camera mine = view.viewport.camera();
        mine.distance *= 0.9;
        view.viewport.look(mine);
        fly(height);
        QCOMPARE(view.viewport.camera().distance, mine.distance);
    }

    void everyBuilderFitsThePicture()
    {
        for (const Builder& builder : allBuilders()) {
            View view(*build(builder, {}));
            QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
            QTRY_VERIFY(view.player.frame());
            view.viewport.fit();
            const Eigen::Matrix4d projection = view.viewport.camera().projection(4.0 / 3.0);
            for (const Vec3& place : view.player.frame()->position) {
                const Eigen::Vector4d seen = projection * place.homogeneous();
                QVERIFY2(std::abs(seen.x()) <= seen.w() && std::abs(seen.y()) <= seen.w(),
                         builder.name.data());
            }
        }
    }
};

const RegisteredTest registered("test_fitting", runWithView<TestFitting>);

} // namespace ripstop::test_fitting
#include "test_fitting.moc"
