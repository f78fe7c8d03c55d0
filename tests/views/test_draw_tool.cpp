// Drawing with the mouse: events at places of the picture, as the view passes them on.
//
// Stages: particles, the grid, links and ropes, panels, and drawing on fabric, each by clicks at
// places of the picture; then undo between clicks, and a plane that is seen on edge.
#include "camera/camera_projection.h"
#include "document/document.h"
#include "look/scene_frame.h"
#include "tools/draw_tool.h"
#include "views/run_with_widgets.h"

#include <QMouseEvent>
#include <QtTest>

#include <cmath>

namespace ripstop::test_draw_tool {

namespace {

// A document, a tool and an eye that looks along -z at the origin.
struct Board
{
    Document document;
    DrawSettings settings;
    QStringList said;
    int begun = 0;
    DrawTool tool;
    Camera camera;
    Look look;
    std::vector<ColliderBody> colliders;
    std::shared_ptr<const Frame> frame;

    explicit Board(DrawTool::Shape shape)
        : tool(
            shape, document, settings, [this] { ++begun; },
            [this](const QString& text) { said << text; })
    {
        camera.look(PresetView::Front);
        settings.plane = DrawSettings::Plane::Front;
    }

    CameraView view()
    {
        frame = sceneFrame(document.scene());
        look = lookOf(document.scene(), *frame->layout);
        return {*frame, look, colliders, camera, 800.0, 600.0};
    }

    void click(const Vec3& place, Qt::KeyboardModifiers keys = Qt::ControlModifier)
    {
        const CameraView now = view();
        const OnScreen at = CameraProjection(now)(place);
        const auto event = [&](QEvent::Type type, Qt::MouseButtons buttons) {
            return QMouseEvent(type, QPointF(at.x, at.y), QPointF(at.x, at.y), Qt::LeftButton,
                               buttons, keys);
        };
        QVERIFY(tool.press(event(QEvent::MouseButtonPress, Qt::LeftButton), now));
        QVERIFY(tool.release(event(QEvent::MouseButtonRelease, Qt::NoButton), now));
    }

    Part part() const
    {
        Part found;
        forEachPart(document.scene(), [&](Id, const Part& part) { found = part; });
        return found;
    }
};

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-6; }

} // namespace

class TestDrawTool : public QObject
{
    Q_OBJECT

private slots:
    void putsParticlesWhereOneClicks()
    {
        Board board(DrawTool::Shape::Particles);
        board.settings.mass = 0.2;
        board.click({0.123, 0.456, 0});
        board.click({-0.3, 0.1, 0});
        QCOMPARE(board.part().particles.size(), 2U);
        QVERIFY(near(board.part().particles[0].position, {0.123, 0.456, 0}));
        QCOMPARE(board.part().particles[1].mass, 0.2);
        QCOMPARE(board.begun, 2);
        board.click({-0.3, 0.1, 0}); // there is one
        QCOMPARE(board.part().particles.size(), 2U);
    }

    void snapsToTheGrid()
    {
        Board board(DrawTool::Shape::Particles);
        board.settings.grid = 0.25;
        board.click({0.3, 0.6, 0}, Qt::NoModifier);
        QVERIFY(near(board.part().particles[0].position, {0.25, 0.5, 0}));
    }

    void linksFromClickToClick()
    {
        Board board(DrawTool::Shape::Links);
        board.click({0, 0, 0});
        board.click({1, 0, 0});
        board.click({1, 1, 0});
        board.click({0, 0, 0}); // back to the first: no new particle
        QCOMPARE(board.part().particles.size(), 3U);
        QCOMPARE(board.part().links.size(), 3U);
        QVERIFY(std::abs(board.part().links[2].restLength - std::sqrt(2.0)) < 1e-6);
        board.click({0, 0, 0}); // the last one again: the line ends
        board.click({-1, 0, 0});
        QCOMPARE(board.part().links.size(), 3U);
        QCOMPARE(board.document.history().count(), 5); // one for each click that drew
        while (board.document.history().canUndo())
            board.document.history().undo();
        QVERIFY(board.document.scene().items.empty());
    }

    void drawsRopesOfManySegments()
    {
        Board board(DrawTool::Shape::Links);
        board.settings.segments = 5;
        board.settings.mass = 0.5;
        board.settings.resists = Resists::Tension;
        board.click({0, 0, 0});
        board.click({1, 0, 0});
        QCOMPARE(board.part().links.size(), 5U);
        double mass = 0.0;
        for (const Particle& particle : board.part().particles)
            mass += particle.mass;
        QVERIFY(std::abs(mass - 0.5) < 1e-12);
        QVERIFY(board.part().links[0].resists == Resists::Tension);
    }

    void coversThreeCorners()
    {
        Board board(DrawTool::Shape::Panels);
        board.click({0, 0, 0});
        board.click({1, 0, 0});
        QCOMPARE(board.part().panels.size(), 0U);
        QVERIFY(board.tool.cancel());
        board.click({0, 0, 0});
        board.click({1, 0, 0});
        board.click({0, 1, 0});
        QCOMPARE(board.part().panels.size(), 1U);
        QCOMPARE(board.part().particles.size(), 3U);
        QVERIFY(!board.tool.cancel()); // nothing is under way
    }

    // A panel across the line of sight, half a metre nearer than the plane.
    void drawsOnFabric()
    {
        Board board(DrawTool::Shape::Panels);
        for (const Vec3& corner : {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)})
            board.click(corner);
        (void)board.part();
        Board points(DrawTool::Shape::Particles);
        Scene scene = board.document.scene();
        for (Entry& entry : scene.items)
            if (auto* part = std::get_if<Part>(&entry.item))
                for (Particle& particle : part->particles)
                    particle.position.z() = 0.5;
        points.document.replace(scene);
        points.click({0.1, 0.1, 0.5});
        QVERIFY(near(points.part().particles.back().position, {0.1, 0.1, 0.5}));
        points.settings.onMesh = false;
        points.click({0.1, -0.4, 0.0});
        QVERIFY(near(points.part().particles.back().position, {0.1, -0.4, 0.0}));
    }

    // What comes next is said while something is under way, and taken back with it.
    void asksForNothingOnceItIsGivenUp()
    {
        Board board(DrawTool::Shape::Links);
        board.click({0, 0, 0});
        QVERIFY(board.said.last().contains("where the link ends"));
        QVERIFY(board.tool.cancel());
        QCOMPARE(board.said.last(), QString());
        QVERIFY(!board.tool.cancel());
    }

    void goesOnAfterUndo()
    {
        Board board(DrawTool::Shape::Links);
        board.click({0, 0, 0});
        board.click({1, 0, 0});
        board.document.history().undo();
        board.click({0, 1, 0}); // the end of the line is gone, and so a new one begins
        QCOMPARE(board.part().links.size(), 0U);
        QCOMPARE(board.part().particles.size(), 2U);
    }

    void saysThatAPlaneIsOnEdge()
    {
        Board board(DrawTool::Shape::Particles);
        board.settings.plane = DrawSettings::Plane::Side;
        board.click({0, 0, 0});
        QVERIFY(board.document.scene().items.empty());
        QVERIFY(board.said.last().contains("edge"));
    }
};

const RegisteredTest registered("test_draw_tool", runWithWidgets<TestDrawTool>);

} // namespace ripstop::test_draw_tool
#include "test_draw_tool.moc"
