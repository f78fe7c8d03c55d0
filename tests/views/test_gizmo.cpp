// The handles of the transform tool in the view, pulled with real mouse and key events.
//
// Stages: View is a viewport of 600 x 450 pixels with the camera in front, so that pixels and
// metres are related by one factor. First the handles and what each moves, then taking back by
// Escape or the right button, keys, snapping and typed numbers; then runs, axes and the camera; at
// the end the time that a large cloth takes to follow.
#include "builders/builder.h"
#include "overlays/centre_mark.h"
#include "tools/transform_tool.h"
#include "views/bare_view.h"
#include "views/run_with_widgets.h"

#include "small_scenes.h"
#include "thread_time.h"

#include <QtTest>

namespace ripstop::test_gizmo {

namespace {

struct View : BareView
{
    TransformTool& tool = viewport.transformTool();

    explicit View(Scene scene = oneOfEverything())
        : BareView(std::move(scene), {600, 450})
    {
        viewport.view(PresetView::Front); // x to the right, y up, z towards the eye
    }

    Vec3 place(Id id) const
    {
        return std::get<const Particle*>(*find(document.scene(), id))->position;
    }

    // Where 60 pixels along the arrow of an axis is.
    QPoint onArrow(int axis) const
    {
        const QPolygonF arrow = tool.gizmo()->shape({Handle::Sort::Axis, axis});
        return (arrow.first() + 0.7 * (arrow.last() - arrow.first())).toPoint();
    }
    QPoint middle() const { return tool.gizmo()->centre()->toPoint(); }
    double metresPerPixel() const
    {
        return tool.gizmo()->projection.metresPerPixel(tool.gizmo()->pivot);
    }

    void press(QPoint at) { QTest::mousePress(&viewport, Qt::LeftButton, {}, at); }
    void release(QPoint at) { QTest::mouseRelease(&viewport, Qt::LeftButton, {}, at); }
    // a move as of a hand that holds the button
    void move(QPoint at, Qt::KeyboardModifiers keys = {})
    {
        QMouseEvent event(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton,
                          Qt::LeftButton, keys);
        QApplication::sendEvent(&viewport, &event);
    }
    void key(Qt::Key key) { QTest::keyClick(&viewport, key); }
};

bool near(double a, double b, double tolerance) { return std::abs(a - b) < tolerance; }

} // namespace

class TestGizmo : public QObject
{
    Q_OBJECT

private slots:
    void handlesNeedAToolAndASelection()
    {
        View view;
        QVERIFY(!view.tool.acts());
        view.tool.setShaping(Shaping::Move);
        QVERIFY(!view.tool.acts());
        view.selection.set({Id{13}}); // a wind has no place
        QVERIFY(!view.tool.acts());
        view.selection.set({Id{3}});
        QVERIFY(view.tool.acts());
        view.selection.clear();
        QVERIFY(!view.tool.acts());
    }

    void theArrowOfXMovesAlongXByWhatTheHandMoves()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        view.selection.set({Id{3}});
        view.tool.setShaping(Shaping::Move);
        const Vec3 before = view.place(Id{3});
        const QPoint from = view.onArrow(0);
        const double scale = view.metresPerPixel();
        view.press(from);
        view.move(from + QPoint(10, 5));
        view.move(from + QPoint(40, 23));
        const Vec3 now = view.place(Id{3});
        view.release(from + QPoint(40, 23));
        // the arrow lies across the line of sight, so that pixels are metres
        QVERIFY2(near(now.x() - before.x(), 40.0 * scale, 0.5 * scale),
                 qPrintable(QString::number((now.x() - before.x()) / scale)));
        QCOMPARE(now.y(), before.y());
        QCOMPARE(now.z(), before.z());
        QCOMPARE(view.document.history().count(), 1);
        view.document.history().undo();
        QCOMPARE(view.place(Id{3}), before);
        QVERIFY(view.selection.contains(Id{3})); // the click was the tool's
    }

    void theMiddleMovesAlongThePicture()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        view.selection.set({Id{3}});
        view.tool.setShaping(Shaping::Move);
        const Vec3 before = view.place(Id{3});
        const double scale = view.metresPerPixel();
        const QPoint from = view.middle();
        view.press(from);
        view.move(from + QPoint(30, -20));
        view.release(from + QPoint(30, -20));
        const Vec3 way = view.place(Id{3}) - before;
        QVERIFY(near(way.x(), 30.0 * scale, 0.5 * scale));
        QVERIFY(near(way.y(), 20.0 * scale, 0.5 * scale));
        QVERIFY(near(way.z(), 0.0, 1e-12));
    }

    void escapeTakesItBack()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        view.selection.set({Id{3}});
        view.tool.setShaping(Shaping::Move);
        view.document.history().setClean();
        const Scene before = view.document.scene();
        const QPoint from = view.onArrow(0);
        view.press(from);
        view.move(from + QPoint(40, 0));
        QVERIFY(view.document.scene() != before);
        view.key(Qt::Key_Escape);
        QVERIFY(view.document.scene() == before);
        QCOMPARE(view.document.history().count(), 0);
        QVERIFY(!view.document.isModified());
        view.move(from + QPoint(80, 0)); // the button is still down
        QVERIFY(view.document.scene() == before);
        view.release(from + QPoint(80, 0));
        QVERIFY(view.selection.contains(Id{3})); // the drag was not taken for a click
        QCOMPARE(view.tool.shaping(), Shaping::Move);
        view.key(Qt::Key_Escape);
        QCOMPARE(view.tool.shaping(), Shaping::None);
    }

    void theRightButtonTakesItBackToo()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        view.selection.set({Id{1}});
        view.tool.setShaping(Shaping::Scale);
        const Scene before = view.document.scene();
        const QPoint from = view.onArrow(1);
        view.press(from);
        view.move(from + QPoint(0, -30));
        QVERIFY(view.document.scene() != before);
        QTest::mousePress(&view.viewport, Qt::RightButton, {}, from);
        QVERIFY(view.document.scene() == before);
        QCOMPARE(view.document.history().count(), 0);
    }

    void keysKeepToAnAxisAndTypeTheAmount()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        view.selection.set({Id{3}});
        view.tool.setShaping(Shaping::Move);
        const Vec3 before = view.place(Id{3});
        const QPoint from = view.middle();
        view.press(from);
        view.move(from + QPoint(30, -20));
        view.key(Qt::Key_Y);
        QCOMPARE(view.place(Id{3}).x(), before.x());
        QVERIFY(view.place(Id{3}).y() > before.y());
        QTest::keyClicks(&view.viewport, "-1.25");
        QCOMPARE(view.place(Id{3}), Vec3(before + Vec3(0, -1.25, 0)));
        view.key(Qt::Key_Return);
        QVERIFY(!view.tool.isDragging());
        QCOMPARE(view.document.history().count(), 1);
    }

    void ringsTurn()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        view.selection.set({Id{1}});
        view.tool.setShaping(Shaping::Turn);
        const Vec3 pivot = view.tool.gizmo()->pivot;
        const Vec3 before = view.place(Id{3}) - pivot;
        // the ring about z is a circle in this view: from its right end to its top
        const QPoint centre = view.middle();
        const int radius = int(std::round(Gizmo::reach));
        view.press(centre + QPoint(radius, 0));
        for (const double degrees : {20.0, 45.0, 70.0, 90.0}) {
            const double angle = degrees * 3.14159265358979 / 180.0;
            view.move(centre
                      + QPoint(int(std::round(radius * std::cos(angle))),
                               -int(std::round(radius * std::sin(angle)))));
        }
        view.release(centre + QPoint(0, -radius));
        const Vec3 after = view.place(Id{3}) - pivot;
        const Vec3 quarter(-before.y(), before.x(), before.z());
        QVERIFY2((after - quarter).norm() < 0.03 * before.norm(), // 1 pixel of 84 is 0.7 degrees
                 qPrintable(QString::number((after - quarter).norm())));
        QCOMPARE(view.document.history().count(), 1);
    }

    void ctrlSnaps()
    {
        View view;
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        view.selection.set({Id{3}});
        view.tool.setShaping(Shaping::Scale);
        view.selection.set({Id{1}});
        const double before = (view.place(Id{3}) - view.place(Id{2})).norm();
        const QPoint from = view.onArrow(0);
        view.press(from);
        view.move(from + QPoint(33, 0), Qt::ControlModifier);
        const double factor = (view.place(Id{3}) - view.place(Id{2})).norm() / before;
        QVERIFY(near(10.0 * factor, std::round(10.0 * factor), 1e-9) && factor > 1.0);
        view.key(Qt::Key_Escape);

        view.tool.setShaping(Shaping::Move);
        view.tool.setSnap(Snap::Particle);
        view.selection.set({Id{3}});
        const QPoint goal = view.tool.gizmo()->projection.pixel(view.place(Id{4}))->toPoint();
        view.press(view.middle());
        view.move(goal + QPoint(4, -3), Qt::ControlModifier);
        QCOMPARE(view.place(Id{3}), view.place(Id{4}));
    }

    void numbersCanBeTyped()
    {
        View view;
        view.selection.set({Id{3}});
        view.tool.setShaping(Shaping::Move);
        view.tool.shape(Vec3(0.1, 0, -0.2));
        QCOMPARE(view.place(Id{3}), Vec3(1.1, 1.0, -0.2));
        view.tool.setShaping(Shaping::Scale);
        view.tool.shape(Vec3(0, 1, 1)); // nothing can have no width
        QCOMPARE(view.document.history().count(), 1);
        view.selection.set({Id{2}, Id{3}});
        view.tool.setPivot(Pivot::Particle);
        QVERIFY(view.tool.awaitsPivot());
        const QPoint second = view.tool.gizmo()->projection.pixel(view.place(Id{2}))->toPoint();
        QTest::mouseClick(&view.viewport, Qt::LeftButton, {}, second + QPoint(3, 2));
        QVERIFY(!view.tool.awaitsPivot());
        QCOMPARE(view.selection.ids(), (std::vector{Id{2}, Id{3}}));
        view.tool.setRestLengths(RestLengths::Rebind);
        view.tool.shape(Vec3(2, 2, 2)); // about particle 2 at (0, 1, 0)
        QVERIFY((view.place(Id{3}) - Vec3(2.2, 1.0, -0.4)).norm() < 1e-15);
        QCOMPARE(std::get<const Link*>(*find(view.document.scene(), Id{5}))->restLength,
                 view.place(Id{3}).x() > 0 ? (view.place(Id{3}) - view.place(Id{2})).norm() : 0.0);
    }

    // The design is what is shaped: while a run is shown, playing or paused, the tool cannot be
    // chosen and says why; one that is chosen waits.
    void aRunIsLeftAlone()
    {
        View view(fallingPair());
        view.selection.set({Id{2}});
        QTRY_VERIFY(view.player.frame());
        view.player.step();
        QTRY_VERIFY(view.player.frame()->step > 0);
        QSignalSpy said(&view.tool, &TransformTool::said);
        QVERIFY(!view.tool.canBegin());
        QCOMPARE(said.takeFirst().first().toString(), TransformTool::wayToDesign());
        view.tool.setShaping(Shaping::Move);
        QVERIFY(!view.tool.acts());
        QVERIFY(view.player.frame()->step > 0);
        view.player.reset();
        QTRY_VERIFY(view.tool.acts());
        QVERIFY(view.tool.canBegin());
        QCOMPARE(said.count(), 0);
        view.player.play();
        QVERIFY(!view.tool.acts());
        QVERIFY(!view.tool.canBegin());
    }

    // Along its own x a link becomes longer and keeps its direction.
    void axesCanBeChosen()
    {
        View view;
        view.selection.set({Id{6}}); // from (1,1,0) to (0,0,0)
        view.tool.setShaping(Shaping::Scale);
        view.tool.setAxes(Axes::Own);
        view.tool.shape(Vec3(2, 1, 1));
        QVERIFY((view.place(Id{3}) - Vec3(1.5, 1.5, 0)).norm() < 1e-12);
        QVERIFY((view.place(Id{4}) - Vec3(-0.5, -0.5, 0)).norm() < 1e-12);
        view.viewport.view(PresetView::Right); // from +x: right is -z
        view.tool.setAxes(Axes::View);
        view.tool.setShaping(Shaping::Move);
        view.tool.shape(Vec3(0.5, 0, 0));
        QVERIFY((view.place(Id{3}) - Vec3(1.5, 1.5, -0.5)).norm() < 1e-12);
    }

    // The centre of gravity of what is selected, else of all, and where it moves to.
    void theCentreOfGravityIsMarked()
    {
        View view(fallingPair()); // 0.5 kg at (0, 10, 0) and at (1, 10, 0)
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        auto* mark = view.viewport.findChild<CentreMark*>();
        QVERIFY(mark && !mark->isVisible());
        view.viewport.setCentreShown(true);
        (void)view.viewport.image();
        QTRY_VERIFY(mark->place());
        QCOMPARE(*mark->place(), Vec3(0.5, 10, 0));
        QCOMPARE(mark->mass(), 1.0);
        view.selection.set({Id{3}});
        (void)view.viewport.image();
        QTRY_COMPARE(mark->mass(), 0.5);
        QCOMPARE(*mark->place(), Vec3(1, 10, 0));
    }

    // Each step of a drag of 100 489 particles, until the window is free again.
    void aLargeClothFollowsTheHand()
    {
        View view(*build(*findBuilder("cloth"), {{"columns", 316}, {"rows", 316}}));
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY_WITH_TIMEOUT(view.player.frame(), 20000);
        std::vector<Id> parts;
        forEachPart(view.document.scene(), [&](Id id, const Part&) { parts.push_back(id); });
        view.selection.set(parts);
        const double start = threadTime();
        view.tool.setShaping(Shaping::Move);
        const QPoint from = view.middle();
        view.press(from);
        const double begun = threadTime() - start;
        double worst = 0.0;
        for (int i = 1; i <= 5; ++i) {
            const double before = threadTime();
            view.move(from + QPoint(5 * i, 0));
            worst = std::max(worst, threadTime() - before);
        }
        view.release(from + QPoint(25, 0));
        qInfo("begun in %.0f ms, each step in at most %.0f ms", begun, worst);
        QCOMPARE(view.document.history().count(), 1);
    }

    // A camera that follows the fabric in flight stays where it is while the design is moved.
    void theCameraStays()
    {
        View view(fallingPair());
        view.selection.set({Id{1}});
        QTRY_VERIFY(view.player.frame());
        const Vec3 focus = view.viewport.camera().focus;
        view.tool.setShaping(Shaping::Move);
        view.tool.shape(Vec3(0, 3, 0));
        QTRY_COMPARE(view.player.frame()->position[0], Vec3(0, 13, 0));
        QCOMPARE(view.viewport.camera().focus, focus);
    }

    // What is pulled follows the hand on screen, not only in the design.
    void theViewFollowsTheHand()
    {
        View view(fallingPair());
        view.selection.set({Id{2}});
        QTRY_VERIFY(view.player.frame());
        view.tool.setShaping(Shaping::Move);
        view.tool.shape(Vec3(0, 3, 0));
        QTRY_COMPARE(view.player.frame()->position[0], Vec3(0, 13, 0));
    }
};

const RegisteredTest registered("test_gizmo", runWithWidgets<TestGizmo>);

} // namespace ripstop::test_gizmo
#include "test_gizmo.moc"
