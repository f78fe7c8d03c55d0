// The brush in the hand: strokes at places of the picture, one step of undo each, Escape, the
// wheel, what is said where nothing can be painted, and where words beside the cursor stand.
#include "camera/camera_projection.h"
#include "document/document.h"
#include "look/scene_frame.h"
#include "overlays/caption.h"
#include "tools/brush_tool.h"
#include "views/run_with_widgets.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <QtTest>

#include <cmath>

namespace ripstop::test_brush_tool {

namespace {

constexpr int cells = 8; // along either side of a square of 1 m around the origin

// An elastic sheet in the plane z = 0.
Scene sheet()
{
    Scene scene;
    Material cloth;
    cloth.membraneStiffness = 1e4;
    const Id material = takeId(scene);
    scene.items.push_back({material, cloth});
    Part part;
    part.carrier = FabricKind::Panels;
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column)
            part.particles.push_back(
                {.id = takeId(scene),
                 .position = {double(column) / cells - 0.5, double(row) / cells - 0.5, 0.0}});
    const auto at = [&](int row, int column) {
        return part.particles[std::size_t(row * (cells + 1) + column)].id;
    };
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const Id a = at(row, column), b = at(row, column + 1), c = at(row + 1, column);
            part.panels.push_back({takeId(scene), a, b, c, material});
            part.panels.push_back({takeId(scene), b, at(row + 1, column + 1), c, material});
        }
    scene.items.push_back({takeId(scene), part});
    return scene;
}

// A document, a brush and an eye that looks along -z at the origin.
struct Board
{
    Document document;
    Brush brush{.radius = 0.2, .falloff = Falloff::Hard};
    bool isAtDesign = true;
    int changed = 0;
    QStringList said;
    BrushTool tool;
    Camera camera;
    Look look;
    std::vector<ColliderBody> colliders;
    std::shared_ptr<const Frame> frame;

    explicit Board(Scene scene)
        : tool(document, brush,
               {[this] { return isAtDesign; }, [this] { ++changed; },
                [this](const QString& text) { said << text; }})
    {
        document.replace(std::move(scene));
        camera.look(PresetView::Front);
    }

    CameraView view()
    {
        frame = sceneFrame(document.scene());
        look = lookOf(document.scene(), *frame->layout);
        return {*frame, look, colliders, camera, 800.0, 600.0};
    }

    QPointF pixelOf(const Vec3& place) { return *CameraProjection(view()).pixel(place); }

    bool send(QEvent::Type type, const Vec3& place, Qt::MouseButtons buttons)
    {
        const QPointF at = pixelOf(place);
        const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        const QMouseEvent event(type, at, at, button, buttons, Qt::NoModifier);
        const CameraView now = view();
        return type == QEvent::MouseButtonPress ? tool.press(event, now)
               : type == QEvent::MouseMove      ? tool.move(event, now)
                                                : tool.release(event, now);
    }

    void stroke(const Vec3& from, const Vec3& to)
    {
        QVERIFY(send(QEvent::MouseButtonPress, from, Qt::LeftButton));
        for (int i = 1; i <= 4; ++i)
            QVERIFY(send(QEvent::MouseMove, from + 0.25 * i * (to - from), Qt::LeftButton));
        QVERIFY(send(QEvent::MouseButtonRelease, to, Qt::NoButton));
    }

    void turnWheel(Qt::KeyboardModifiers keys, bool taken)
    {
        const QPointF at(400.0, 300.0);
        const QWheelEvent event(at, at, {}, {0, 120}, Qt::NoButton, keys, Qt::NoScrollPhase, false);
        QCOMPARE(tool.wheel(event, view()), taken);
    }

    const Part& part() const { return std::get<Part>(document.scene().items.back().item); }

    Vec3 middleOf(const Panel& panel) const
    {
        const auto at = [&](Id id) -> Vec3 { return findRow(part().particles, id)->position; };
        return (at(panel.a) + at(panel.b) + at(panel.c)) / 3.0;
    }
};

double distanceToWay(const Vec3& place, double from, double to) // along x
{
    return std::hypot(place.x() - std::clamp(place.x(), from, to), place.y());
}

} // namespace

class TestBrushTool : public QObject
{
    Q_OBJECT

private slots:
    // Pixels are at most a few mm wide here, and no middle of a panel is as near to the edge.
    void aStrokeChangesWhatLiesWithinTheRadius()
    {
        Board board(sheet());
        const Scene before = board.document.scene();
        board.stroke({-0.2, 0.0, 0.0}, {0.1, 0.0, 0.0});
        for (const Panel& panel : board.part().panels) {
            const double away = distanceToWay(board.middleOf(panel), -0.2, 0.1);
            QCOMPARE(panel.strengthFactor, away < 0.2 ? 0.5 : 1.0);
            QCOMPARE(panel.stiffnessFactor, 1.0);
        }
        QCOMPARE(board.document.history().count(), 1);
        board.document.history().undo();
        QVERIFY(board.document.scene() == before);
        board.document.history().redo();
        QVERIFY(!(board.document.scene() == before));
    }

    void strokesAreStepsOfTheirOwn()
    {
        Board board(sheet());
        board.stroke({-0.3, 0.3, 0.0}, {-0.2, 0.3, 0.0});
        const Scene between = board.document.scene();
        board.brush.what = Painted::Stiffness;
        board.stroke({-0.3, 0.3, 0.0}, {-0.2, 0.3, 0.0});
        QCOMPARE(board.document.history().count(), 2);
        board.document.history().undo();
        QVERIFY(board.document.scene() == between);
    }

    void escapeGivesAStrokeUp()
    {
        Board board(sheet());
        const Scene before = board.document.scene();
        QVERIFY(!board.tool.cancel());
        QVERIFY(board.send(QEvent::MouseButtonPress, {0.0, 0.0, 0.0}, Qt::LeftButton));
        QVERIFY(board.tool.holds());
        QVERIFY(!(board.document.scene() == before));
        QVERIFY(board.tool.cancel());
        QVERIFY(board.document.scene() == before);
        QVERIFY(board.send(QEvent::MouseMove, {0.2, 0.0, 0.0}, Qt::LeftButton)); // still down
        QVERIFY(board.send(QEvent::MouseButtonRelease, {0.2, 0.0, 0.0}, Qt::NoButton));
        QVERIFY(board.document.scene() == before);
        QCOMPARE(board.document.history().count(), 0);
    }

    // Beside the fabric the way is interrupted, and begins again where it comes back.
    void paintsNothingBesideTheFabric()
    {
        Board board(sheet());
        const Scene before = board.document.scene();
        board.stroke({-0.9, 0.0, 0.0}, {-0.7, 0.0, 0.0});
        QVERIFY(board.document.scene() == before);
        QCOMPARE(board.document.history().count(), 0);
    }

    void ctrlAndTheWheelWidenIt()
    {
        Board board(sheet());
        board.turnWheel(Qt::NoModifier, false); // is the camera's
        QCOMPARE(board.brush.radius, 0.2);
        board.turnWheel(Qt::ControlModifier, true);
        QVERIFY(board.brush.radius > 0.2);
        QCOMPARE(board.changed, 1);
    }

    void saysWhyItPaintsNothing()
    {
        Scene threads = sheet();
        std::get<Part>(threads.items.back().item).carrier = FabricKind::Threads;
        Board board(threads);
        board.brush.what = Painted::Grain;
        QVERIFY(board.send(QEvent::MouseButtonPress, {0.0, 0.0, 0.0}, Qt::LeftButton));
        QVERIFY(board.send(QEvent::MouseButtonRelease, {0.0, 0.0, 0.0}, Qt::NoButton));
        QCOMPARE(board.said.size(), 1);
        QVERIFY2(board.said.front().contains("grain"), qPrintable(board.said.front()));
        QVERIFY(!whyNothingToPaint(Scene(), Brush()).isEmpty());
        QVERIFY(whyNothingToPaint(sheet(), board.brush).isEmpty());
    }

    // The first press leaves a run that is shown; places of the picture are not those of the
    // design until then.
    void firstGoesToTheDesign()
    {
        Board board(sheet());
        board.isAtDesign = false;
        const Scene before = board.document.scene();
        board.stroke({-0.2, 0.0, 0.0}, {0.1, 0.0, 0.0});
        QVERIFY(board.document.scene() == before);
        board.isAtDesign = true;
        board.stroke({-0.2, 0.0, 0.0}, {0.1, 0.0, 0.0});
        QVERIFY(!(board.document.scene() == before));
    }

    // Of a card of 190 x 26 pixels in a picture of 800 x 600: 18 pixels beside the cursor, and not
    // under the legend or the bar.
    void wordsKeepOutOfTheWay_data()
    {
        QTest::addColumn<QPointF>("cursor");
        QTest::addColumn<QRect>("covered");
        QTest::addColumn<QPointF>("corner"); // the upper left one of the card
        const QRect legend(640, 12, 150, 280), bar(100, 520, 600, 70);
        QTest::newRow("nothing in the way") << QPointF(100, 100) << legend << QPointF(118, 118);
        QTest::newRow("beside the legend") << QPointF(500, 100) << legend << QPointF(292, 118);
        QTest::newRow("below the legend") << QPointF(600, 300) << legend << QPointF(392, 318);
        QTest::newRow("above the bar") << QPointF(300, 490) << bar << QPointF(318, 446);
        QTest::newRow("at the edges") << QPointF(790, 590) << legend << QPointF(582, 546);
        QTest::newRow("nothing is free")
            << QPointF(790, 100) << QRect(0, 0, 800, 600) << QPointF(610, 118);
    }
    void wordsKeepOutOfTheWay()
    {
        QFETCH(QPointF, cursor);
        QFETCH(QRect, covered);
        QFETCH(QPointF, corner);
        const QRectF card = captionPlace({190, 26}, cursor, {0, 0, 800, 600}, {{covered}});
        QCOMPARE(card.topLeft(), corner);
        QCOMPARE(card.size(), QSizeF(190, 26));
    }
};

const RegisteredTest registered("test_brush_tool", runWithWidgets<TestBrushTool>);

} // namespace ripstop::test_brush_tool
#include "test_brush_tool.moc"
