// Box, lasso, what is hidden, and what a click takes: with real events, on scenes whose projection
// is known.
//
// Stages: outlines alone; then boxes and lassos with their keys, clicks, and what panels, closed
// bodies and colliders hide, each against a projection that is known; and times on 100 000
// particles.
#include "builders/builder.h"
#include "look/scene_frame.h"
#include "tools/pointing.h"
#include "tools/region_tool.h"
#include "views/bare_view.h"
#include "views/run_with_widgets.h"

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QtTest>

#include <ctime>

namespace ripstop::test_region_select {

namespace {

// Two square sheets of n x n cells that face the eye, one metre behind each other: the front one at
// z = 0, the other, of the same size, at z = -1. Ids count up: part 1, then the particles of the
// front sheet row by row, those of the other, the panels of the front sheet, those of the other.
struct Sheets
{
    int n;
    Scene scene;

    explicit Sheets(int cells)
        : n(cells)
    {
        Part part;
        std::uint32_t id = 2;
        for (const double z : {0.0, -1.0})
            for (int row = 0; row <= n; ++row)
                for (int column = 0; column <= n; ++column)
                    part.particles.push_back(
                        {.id = Id{id++},
                         .position = Vec3(2.0 * column / n - 1.0, 1.0 - 2.0 * row / n, z)});
        material = Id{id++};
        for (const bool front : {true, false})
            for (int row = 0; row < n; ++row)
                for (int column = 0; column < n; ++column) {
                    const auto at = [&](int r, int c) { return particle(front, r, c); };
                    part.panels.push_back({Id{id++}, at(row, column), at(row + 1, column),
                                           at(row, column + 1), material});
                    part.panels.push_back({Id{id++}, at(row + 1, column), at(row + 1, column + 1),
                                           at(row, column + 1), material});
                }
        for (Particle& particle : part.particles)
            particle.pinned = true;
        scene.items = {{Id{1}, part}, {material, Material{}}};
        scene.nextId = Id{id};
    }

    Id particle(bool front, int row, int column) const
    {
        const int side = n + 1;
        return Id(std::uint32_t(2 + (front ? 0 : side * side) + row * side + column));
    }

    Id material{};
};

struct View : BareView
{
    Depth depth = Depth::Visible;

    explicit View(const Scene& scene, bool orthographic = true)
        : BareView(scene, {400, 400})
    {
        viewport.setOrthographic(orthographic);
        viewport.view(PresetView::Front);
        (void)QTest::qWaitForWindowExposed(&viewport);
    }

    void take(RegionTool::Shape shape)
    {
        viewport.pointing().setTool(std::make_unique<RegionTool>(shape, selection, [this] {
            return RegionTool::Options{viewport.pointing().pickable, depth};
        }));
    }

    // Where a place is in the picture of a view from the front, in pixels.
    QPointF at(double x, double y, double z) const
    {
        const Camera& camera = viewport.camera();
        const Eigen::Vector4d p = camera.projection(1.0) * Vec3(x, y, z).homogeneous();
        return {200.0 * (1.0 + p.x() / p.w()), 200.0 * (1.0 - p.y() / p.w())};
    }

    void send(QEvent::Type type, QPointF place, Qt::KeyboardModifiers keys)
    {
        const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        const auto buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, place, viewport.mapToGlobal(place), button, buttons, keys);
        QApplication::sendEvent(&viewport, &event);
    }

    void drag(const std::vector<QPointF>& path, Qt::KeyboardModifiers keys = {})
    {
        send(QEvent::MouseButtonPress, path.front(), keys);
        for (const QPointF& place : path)
            send(QEvent::MouseMove, place, keys);
        send(QEvent::MouseButtonRelease, path.back(), keys);
    }
};

double cpuSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

std::vector<Id> particlesWhere(const Sheets& sheets, auto isIn)
{
    std::vector<Id> ids;
    for (const Particle& particle : std::get<Part>(sheets.scene.items[0].item).particles)
        if (isIn(particle.position))
            ids.push_back(particle.id);
    return ids;
}

void takeOnlyParticles(View& view)
{
    view.viewport.pointing().pickable.wanted = {true, false, false};
}

} // namespace

class TestRegionSelect : public QObject
{
    Q_OBJECT

private slots:
    // The outline is exact: an L whose notch is outside, and a loop that goes around twice.
    void regionsContainWhatTheyGoAround()
    {
        const Region corner({{0, 0}, {10, 0}, {10, 10}, {20, 10}, {20, 20}, {0, 20}});
        QVERIFY(corner.contains(5, 5) && corner.contains(15, 15) && corner.contains(0.5, 19.5));
        QVERIFY(!corner.contains(15, 5) && !corner.contains(-1, 5) && !corner.contains(5, 21));
        const Region twice(
            {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {10, 0}, {10, 10}, {0, 10}});
        QVERIFY(twice.contains(5, 5));
        QVERIFY(!Region({}).contains(0, 0));
    }

    // From the front without perspective both sheets lie on top of each other, the other one hidden
    // but for the outline, which no panel covers from within.
    void aBoxTakesWhatLiesInIt_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::newRow("orthographic") << true;
        QTest::newRow("perspective") << false;
    }
    void aBoxTakesWhatLiesInIt()
    {
        QFETCH(bool, orthographic);
        const Sheets sheets(8);
        View view(sheets.scene, orthographic);
        takeOnlyParticles(view);
        view.take(RegionTool::Shape::Box);
        view.depth = Depth::Through;
        const QPointF middle = view.at(0.05, 0, 0);
        view.drag({{1, 1}, {50, 50}, {middle.x(), 399}});
        QCOMPARE(view.selection.ids(), particlesWhere(sheets, [&](const Vec3& p) {
                     return view.at(p.x(), p.y(), p.z()).x() < middle.x();
                 }));

        // what a panel of the front sheet covers is not seen: all of the other sheet that lies
        // inside the outline of the front one
        view.depth = Depth::Visible;
        view.drag({{1, 1}, {50, 50}, {middle.x(), 399}});
        const QPointF corner = view.at(1, 1, 0);
        QCOMPARE(view.selection.ids(), particlesWhere(sheets, [&](const Vec3& p) {
                     const QPointF place = view.at(p.x(), p.y(), p.z());
                     const double edge =
                         std::max(std::abs(place.x() - 200), std::abs(place.y() - 200));
                     const bool covered = p.z() < 0.0 && edge <= corner.x() - 200 + 1e-6;
                     return place.x() < middle.x() && !covered;
                 }));
    }

    void linksAndPanelsMustLieInItWhole()
    {
        const Sheets sheets(4);
        View view(sheets.scene);
        view.viewport.pointing().pickable.wanted = {false, false, true};
        view.take(RegionTool::Shape::Box);
        const QPointF middle = view.at(0.1, 0, 0); // cuts the third column of cells
        view.drag({{1, 1}, {50, 50}, {middle.x(), 399}});
        QCOMPARE(view.selection.ids().size(), std::size_t(2 * 4 * 2)); // two columns, in front
        view.depth = Depth::Through;
        view.drag({{1, 1}, {50, 50}, {middle.x(), 399}});
        QCOMPARE(view.selection.ids().size(), std::size_t(2 * 2 * 4 * 2));
    }

    void aLassoTakesWhatItGoesAround()
    {
        const Sheets sheets(10);
        View view(sheets.scene);
        takeOnlyParticles(view);
        view.take(RegionTool::Shape::Lasso);
        view.depth = Depth::Through;
        // a triangle between three places
        const QPointF a = view.at(-0.9, -0.93, 0), b = view.at(0.9, -0.93, 0),
                      c = view.at(-0.9, 0.87, 0);
        std::vector<QPointF> path;
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            for (int i = 0; i < 20; ++i)
                path.push_back(from + (to - from) * (i / 20.0));
        view.drag(path);
        QCOMPARE(view.selection.ids(), particlesWhere(sheets, [](const Vec3& p) {
                     return p.x() > -0.9 && p.y() > -0.93 && p.x() + p.y() < -0.03;
                 }));
    }

    void shiftAddsAndControlTakesAway()
    {
        const Sheets sheets(8);
        View view(sheets.scene);
        takeOnlyParticles(view);
        view.take(RegionTool::Shape::Box);
        const auto left = [](const Vec3& p) { return p.z() == 0.0 && p.x() < -0.05; };
        const auto top = [](const Vec3& p) { return p.z() == 0.0 && p.y() > 0.05; };
        const double x = view.at(-0.05, 0, 0).x(), y = view.at(0, 0.05, 0).y();
        view.drag({{1, 1}, {x, 399}});
        QCOMPARE(view.selection.ids(), particlesWhere(sheets, left));
        view.drag({{1, 1}, {399, y}}, Qt::ShiftModifier);
        QCOMPARE(view.selection.ids(),
                 particlesWhere(sheets, [&](const Vec3& p) { return left(p) || top(p); }));
        view.drag({{1, 1}, {x, 399}}, Qt::ControlModifier);
        QCOMPARE(view.selection.ids(),
                 particlesWhere(sheets, [&](const Vec3& p) { return top(p) && !left(p); }));
        view.drag({{1, 1}, {5, 60}}); // around nothing
        QVERIFY(view.selection.ids().empty());
    }

    void escapeGivesUpTheGestureThenTheTool()
    {
        const Sheets sheets(4);
        View view(sheets.scene);
        view.viewport.setFocus();
        view.take(RegionTool::Shape::Box);
        const Camera before = view.viewport.camera();
        const std::vector<Id> ids{sheets.particle(true, 0, 0)};
        view.selection.set(ids);
        QSignalSpy left(&view.viewport.pointing(), &Pointing::toolLeft);
        view.send(QEvent::MouseButtonPress, {5, 5}, {});
        view.send(QEvent::MouseMove, {300, 300}, {});
        QTest::keyClick(&view.viewport, Qt::Key_Escape);
        view.send(QEvent::MouseMove, {350, 350}, {});
        view.send(QEvent::MouseButtonRelease, {350, 350}, {});
        QCOMPARE(view.selection.ids(), ids);
        QVERIFY(view.viewport.pointing().hasTool());
        QCOMPARE(left.count(), 0);
        QTest::keyClick(&view.viewport, Qt::Key_Escape);
        QVERIFY(!view.viewport.pointing().hasTool());
        QCOMPARE(left.count(), 1);
        QCOMPARE(view.viewport.camera().azimuth, before.azimuth); // nothing turned
    }

    // With a tool in hand a click still selects, and the right button turns the view.
    void toolsLeaveClicksAndTurning()
    {
        const Sheets sheets(4);
        View view(sheets.scene);
        view.take(RegionTool::Shape::Lasso);
        const QPoint middle = view.at(0, 0, 0).toPoint();
        QTest::mouseClick(&view.viewport, Qt::LeftButton, {}, middle);
        QCOMPARE(view.selection.ids(), std::vector{sheets.particle(true, 2, 2)});
        const double azimuth = view.viewport.camera().azimuth;
        QMouseEvent press(QEvent::MouseButtonPress, QPointF(100, 100), QPointF(100, 100),
                          Qt::RightButton, Qt::RightButton, {});
        QMouseEvent move(QEvent::MouseMove, QPointF(200, 100), QPointF(200, 100), Qt::NoButton,
                         Qt::RightButton, {});
        QApplication::sendEvent(&view.viewport, &press);
        QApplication::sendEvent(&view.viewport, &move);
        QVERIFY(std::abs(view.viewport.camera().azimuth - azimuth) > 0.1);
    }

    void clicksReplaceAddAndTakeAway()
    {
        const Sheets sheets(4);
        View view(sheets.scene);
        const Id first = sheets.particle(true, 1, 1), second = sheets.particle(true, 2, 2);
        const auto click = [&](double x, double y, Qt::KeyboardModifiers keys) {
            QTest::mouseClick(&view.viewport, Qt::LeftButton, keys, view.at(x, y, 0).toPoint());
        };
        click(-0.5, 0.5, {});
        click(0.0, 0.0, Qt::ShiftModifier);
        QCOMPARE(view.selection.ids(), (std::vector{first, second}));
        click(0.0, 0.0, Qt::ShiftModifier); // adds what is there already
        QCOMPARE(view.selection.ids(), (std::vector{first, second}));
        click(-0.5, 0.5, Qt::ControlModifier);
        QCOMPARE(view.selection.ids(), std::vector{second});
        click(-0.5, 0.5, {});
        QCOMPARE(view.selection.ids(), std::vector{first});
    }

    // Each particle of a turned, folded pair of sheets is picked at its place, unless a panel that
    // it is no corner of lies in front of it: checked with all panels, one by one.
    void picksAreExact()
    {
        const Sheets sheets(12);
        View view(sheets.scene, false);
        view.viewport.view(PresetView::Iso);
        const Camera& camera = view.viewport.camera();
        const Part& part = std::get<Part>(sheets.scene.items[0].item);
        const Vec3 eye = camera.eye();
        int hidden = 0;
        for (const Particle& particle : part.particles) {
            bool covered = false;
            for (const Panel& panel : part.panels) {
                if (panel.a == particle.id || panel.b == particle.id || panel.c == particle.id)
                    continue;
                const auto& a = findRow(part.particles, panel.a)->position;
                Eigen::Matrix3d sides;
                sides << findRow(part.particles, panel.b)->position - a,
                    findRow(part.particles, panel.c)->position - a, eye - particle.position;
                if (std::abs(sides.determinant()) < 1e-12)
                    continue;
                const Vec3 share = sides.inverse() * (eye - a);
                const double along = 1.0 - share.z(); // from the particle to the eye
                covered |= share.x() >= 0 && share.y() >= 0 && share.x() + share.y() <= 1
                           && along > 1e-4 && along < 1.0;
            }
            hidden += covered;
            const Eigen::Vector4d p = camera.projection(1.0) * particle.position.homogeneous();
            const QPointF place(200.0 * (1.0 + p.x() / p.w()), 200.0 * (1.0 - p.y() / p.w()));
            QCOMPARE(view.viewport.pick(place) == particle.id, !covered);
        }
        QVERIFY(hidden > 20 && hidden < int(part.particles.size()) / 2);
    }

    // What a closed body hides: of an octahedron seen from a corner above, one face of four and the
    // corner behind are not visible, also where the view has no perspective.
    void aClosedBodyHidesItsBack()
    {
        Scene scene;
        Part part;
        const std::array corners{Vec3(1, 0, 0),  Vec3(-1, 0, 0), Vec3(0, 1, 0),
                                 Vec3(0, -1, 0), Vec3(0, 0, 1),  Vec3(0, 0, -1)};
        std::uint32_t id = 2;
        for (const Vec3& corner : corners)
            part.particles.push_back({.id = Id{id++}, .position = corner, .pinned = true});
        std::vector<Id> facing; // panels that turn towards the eye, and later particles that do
        const Vec3 towards = Vec3(0.3, 0.2, 1.0).normalized();
        for (const int x : {0, 1})
            for (const int y : {2, 3})
                for (const int z : {4, 5}) {
                    part.panels.push_back({Id{id}, Id(2 + x), Id(2 + y), Id(2 + z), Id{99}});
                    if ((corners[x] + corners[y] + corners[z]).dot(towards) > 0.0)
                        facing.push_back(Id{id});
                    ++id;
                }
        scene.items = {{Id{1}, part}, {Id{99}, Material{}}};
        scene.nextId = Id{100};

        const auto frame = sceneFrame(scene);
        const Look look = lookOf(scene, *frame->layout);
        Camera camera;
        camera.azimuth = std::atan2(towards.x(), towards.z());
        camera.elevation = std::asin(towards.y());
        camera.fit(corners, 1.0);
        camera.orthographic = true;
        const CameraView view{*frame, look, {}, camera, 400.0, 400.0};
        const Region everything({{0, 0}, {400, 0}, {400, 400}, {0, 400}});
        const std::vector<Id> seen = elementsIn(view, {}, everything, Depth::Visible);
        std::vector<Id> expected{Id{2}, Id{3}, Id{4}, Id{5}, Id{6}}; // but not the one at -z
        expected.insert(expected.end(), facing.begin(), facing.end());
        QString text;
        for (const Id one : seen)
            text += QString(" %1").arg(std::uint32_t(one));
        QVERIFY2(seen == expected, qPrintable(text));
        QCOMPARE(elementsIn(view, {}, everything, Depth::Through).size(), std::size_t(6 + 8));
    }

    // What a click and a box find on 100 000 particles, and how long they take: figures to read,
    // not to judge by, as another machine is another figure. A hand wants less than 50 ms.
    void largeSheets()
    {
        const auto scene =
            build(*findBuilder("cloth"), {{"columns", 315}, {"rows", 315}, {"sphere", 0}});
        QVERIFY(scene);
        const auto frame = sceneFrame(*scene);
        const Look look = lookOf(*scene, *frame->layout);
        Camera camera;
        camera.look(PresetView::Iso);
        camera.fit(frame->position, 1.25);
        const auto time = [&](const char* what, const auto& run) {
            double best = 1e9;
            for (int i = 0; i < 3; ++i) {
                const double start = cpuSeconds();
                run();
                best = std::min(best, cpuSeconds() - start);
            }
            qInfo("%-28s %6.1f ms", what, 1e3 * best);
        };
        for (const double factor : {1.0, 0.05, 20.0}) {
            Camera near = camera;
            near.focus = frame->position[158 * 316 + 158]; // the middle
            near.zoom(factor, 0.0, 0.0, 1.25);
            const CameraView view{*frame, look, {}, near, 1000.0, 800.0};
            qInfo("the sheet %g times as large as the picture", 1.0 / factor);
            Id found = noId;
            time("click", [&] { found = Picker{view, {}}.at(500.0, 400.0); });
            QVERIFY(found != noId);
            std::size_t count = 0;
            const Region box({{0, 0}, {1000, 0}, {1000, 800}, {0, 800}});
            time("box, particles seen", [&] {
                count = elementsIn(view, {{}, {true, false, false}}, box, Depth::Visible).size();
            });
            time("box, particles through", [&] {
                count = elementsIn(view, {{}, {true, false, false}}, box, Depth::Through).size();
            });
            time("box, all through",
                 [&] { count = elementsIn(view, {}, box, Depth::Through).size(); });
            QVERIFY(count > 100);
            QElapsedTimer clock; // several threads
            clock.start();
            count = elementsIn(view, {}, box, Depth::Visible).size();
            qInfo("%-28s %6.1f ms", "box, all seen", 1e-6 * double(clock.nsecsElapsed()));
        }
    }

    // A ball before the middle of the sheet hides what lies within its outline, and is picked
    // there itself.
    void collidersHideToo()
    {
        Sheets sheets(8);
        Collider ball;
        ball.shape = ColliderShape::Sphere;
        ball.position = Vec3(0.05, 0.03, 2.0);
        ball.radius = 0.5;
        const Id id = sheets.scene.nextId;
        sheets.scene.items.push_back({id, ball});
        sheets.scene.nextId = Id{std::uint32_t(id) + 1};
        View view(sheets.scene);
        takeOnlyParticles(view);
        view.take(RegionTool::Shape::Box);
        view.drag({{1, 1}, {50, 50}, {399, 399}});
        QCOMPARE(view.selection.ids(), particlesWhere(sheets, [&](const Vec3& p) {
                     return p.z() == 0.0 && std::hypot(p.x() - 0.05, p.y() - 0.03) > 0.5;
                 }));
        QCOMPARE(view.viewport.pick(view.at(0.05, 0.03, 0)), id);
        QCOMPARE(view.viewport.pick(view.at(0.75, 0.75, 0)), sheets.particle(true, 1, 7));
    }

    void whatAClickWouldTakeIsNamed()
    {
        const Sheets sheets(4);
        View view(sheets.scene);
        QSignalSpy named(&view.viewport.pointing(), &Pointing::hoveredChanged);
        QMouseEvent move(QEvent::MouseMove, view.at(0, 0, 0), QPointF(), Qt::NoButton, Qt::NoButton,
                         {});
        // A window that is shown late hears that the real mouse is elsewhere: it moves until then.
        const auto hovered = [&] {
            QApplication::sendEvent(&view.viewport, &move);
            QTest::qWait(50); // longer than from a move to a look
            return view.viewport.pointing().hovered();
        };
        const Id under = sheets.particle(true, 2, 2);
        QVERIFY(QTest::qWaitFor([&] { return hovered() == under; }));
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&view.viewport, &leave);
        QCOMPARE(view.viewport.pointing().hovered(), noId);
        // Changes alone are told, however often the real mouse left in between.
        for (int i = 0; i < named.count(); ++i)
            QCOMPARE(named.at(i).at(0).value<Id>(), i % 2 == 0 ? under : noId);
        QCOMPARE(named.count() % 2, 0);
    }
};

const RegisteredTest registered("test_region_select", runWithView<TestRegionSelect>);

} // namespace ripstop::test_region_select
#include "test_region_select.moc"
