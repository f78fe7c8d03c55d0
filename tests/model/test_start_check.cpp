// Designs that begin inside a collider: the check tells how many particles do and how deep, for
// every shape, and a run that diverges for it says so.
//
// Stages: one particle beside and inside each shape, at depths by hand; what lies on a surface and
// what contact leaves alone is no problem; then what the run says.
#include "builders/builder.h"
#include "check/check.h"
#include "compile/compile.h"
#include "model/files.h"
#include "registered_test.h"
#include "scene/edit.h"
#include "step/watchdog.h"

#include <QtTest>

#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

Q_DECLARE_METATYPE(ripstop::Collider)

namespace ripstop::test_start_check {

namespace {

// A closed cube with edges of 2 around the origin.
constexpr const char* cube = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                             "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                             "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// A rod from a pin far outside to one free particle.
Scene rodTo(const Vec3& place, Collider collider)
{
    Part part{"pole"};
    part.particles = {{.id = Id{11}, .position = {50.0, 60.0, 50.0}, .pinned = true},
                      {.id = Id{12}, .position = place}};
    part.links = {{Id{21}, Id{11}, Id{12}, noId}};
    collider.name = "thing";
    Scene scene;
    scene.items = {{Id{1}, part}, {Id{2}, collider}};
    scene.nextId = Id{30};
    return scene;
}

QString warningOf(const Scene& scene)
{
    QStringList told;
    for (const Finding& problem : problemsOf(scene))
        if (problem.sort == "inside")
            told << QString::fromStdString(problem.message.english());
    return told.join('\n');
}

Particle& freeEnd(Scene& scene) { return std::get<Part>(scene.items[0].item).particles[1]; }

Collider plane() { return {}; }

Collider shaped(ColliderShape shape)
{
    Collider collider;
    collider.shape = shape;
    return collider;
}

} // namespace

class TestStartCheck : public QObject
{
    Q_OBJECT

private slots:
    void tellsHowDeep_data()
    {
        QTest::addColumn<Collider>("collider");
        QTest::addColumn<Vec3>("place");
        QTest::addColumn<QString>("depth"); // m; empty where it is outside
        const auto row = [](const char* name, const Collider& collider, const Vec3& place,
                            const char* depth) {
            QTest::newRow(name) << collider << place << QString(depth);
        };

        row("above a plane", plane(), {0.0, 0.1, 0.0}, "");
        row("on a plane", plane(), {3.0, 0.0, 0.0}, "");
        row("under a plane", plane(), {3.0, -2.5, 0.0}, "2.5");
        Collider thick = plane();
        thick.thickness = 0.25;
        row("on a thick plane", thick, {0.0, 0.25, 0.0}, "");
        row("in the thickness of a plane", thick, {0.0, 0.125, 0.0}, "0.125");
        Collider long3 = plane();
        long3.normal = {0.0, 3.0, 0.0};
        row("under a plane with a long normal", long3, {3.0, -2.5, 0.0}, "2.5");

        Collider ball = shaped(ColliderShape::Sphere);
        ball.position = {1.0, 0.0, 0.0};
        row("beside a ball", ball, {2.0, 0.1, 0.0}, "");
        row("on a ball", ball, {1.6, 0.8, 0.0}, "");
        row("in a ball", ball, {1.0, 0.5, 0.0}, "0.5");

        // turned by 90 degrees about z, its height of 4 lies along x
        Collider box = shaped(ColliderShape::Box);
        box.size = {1.0, 4.0, 1.0};
        box.turn = {0.0, 0.0, 90.0};
        row("over a turned box", box, {0.0, 1.5, 0.0}, "");
        row("on a turned box", box, {0.0, 0.5, 0.0}, "");
        row("in a turned box", box, {1.75, 0.0, 0.0}, "0.25");

        Collider drum = shaped(ColliderShape::Cylinder);
        drum.size.y() = 3.0;
        row("beside a cylinder", drum, {1.1, 0.0, 0.0}, "");
        row("on a cylinder", drum, {0.6, 1.5, 0.0}, "");
        row("in a cylinder", drum, {0.5, 0.0, 0.0}, "0.5");

        // level ground of 2 m
        Collider ground = shaped(ColliderShape::HeightField);
        ground.size = {10.0, 2.0, 10.0};
        ground.file = "ground.pgm";
        row("over terrain", ground, {0.0, 2.1, 0.0}, "");
        row("on terrain", ground, {1.0, 2.0, 1.0}, "");
        row("in terrain", ground, {1.0, 1.5, 1.0}, "0.5");
        row("beside terrain", ground, {7.0, 1.0, 0.0}, "");

        Collider mesh = shaped(ColliderShape::Mesh);
        mesh.file = "cube.obj";
        mesh.scale = 2.0; // edges of 4
        row("beside a mesh", mesh, {2.1, 0.0, 0.0}, "");
        row("on a mesh", mesh, {2.0, 0.5, 0.0}, "");
        row("in a mesh", mesh, {1.25, 0.5, 0.0}, "0.75");

        Collider lift = plane();
        lift.path = "0: 0 4 0; 5: 0 -10 0";
        row("over a path that begins below", lift, {0.0, 4.5, 0.0}, "");
        row("under the beginning of a path", lift, {0.0, 3.5, 0.0}, "0.5");
    }

    void tellsHowDeep()
    {
        QFETCH(Collider, collider);
        QFETCH(Vec3, place);
        QFETCH(QString, depth);
        QTemporaryDir folder;
        write(folder.filePath("cube.obj"), cube);
        write(folder.filePath("ground.pgm"), "P2 2 2 255\n255 255 255 255\n");
        Scene scene = rodTo(place, collider);
        scene.folder.path = folder.path().toStdString();
        const QString told = warningOf(scene);
        QCOMPARE(told.isEmpty(), depth.isEmpty());
        if (depth.isEmpty())
            return;
        QVERIFY2(told.startsWith("1 particle of pole begins inside thing, by "), qPrintable(told));
        const QString number = told.section("by ", 1).section(" m:", 0, 0);
        QVERIFY2(std::abs(number.toDouble() - depth.toDouble()) < 1e-3, qPrintable(told));
        QCOMPARE(told.contains("thickness"), collider.thickness > 0.0);
    }

    // Contact leaves them where they are.
    void whatCannotMoveIsNoProblem()
    {
        Scene scene = rodTo({0.0, -1.0, 0.0}, plane());
        QVERIFY(!warningOf(scene).isEmpty());
        freeEnd(scene).pinned = true;
        QCOMPARE(warningOf(scene), QString());
        freeEnd(scene).pinned = false;
        freeEnd(scene).guide = Guide::Line; // along x, as the plane is
        QCOMPARE(warningOf(scene), QString());
        freeEnd(scene).guideAxis = Vec3::UnitY();
        QVERIFY(!warningOf(scene).isEmpty());
    }

    void countsThemAndNamesTheDeepest()
    {
        Scene scene = rodTo({0.0, -1.0, 0.0}, plane());
        std::get<Part>(scene.items[0].item)
            .particles.push_back({.id = Id{13}, .position = {0.0, -3.0, 0.0}});
        const auto problems = problemsOf(scene);
        const auto found = std::ranges::find(problems, "inside", &Finding::sort);
        QVERIFY(found != problems.end());
        QVERIFY(found->severity == Severity::Warning);
        QCOMPARE(found->culprit(), Id{13});
        const QString told = QString::fromStdString(found->message.english());
        QVERIFY2(told.startsWith("2 particles of pole begin inside thing, by up to 3 m:"),
                 qPrintable(told));
    }

    // Nothing else than its start explains a particle that is too fast.
    void aRunThatDivergesForItSaysSo()
    {
        const auto told = [](double height) {
            const auto system = compile(rodTo({0.0, height, 0.0}, plane()));
            State fast = (*system)->start;
            fast.velocity[1] = {0.0, 2000.0, 0.0};
            const auto trouble = findTrouble(**system, (*system)->start, fast, 1);
            return QString::fromStdString(trouble->message.english());
        };
        const QString likely = "likely because a particle began inside an obstacle, by 10 m";
        QVERIFY2(told(-10.0).contains(likely), qPrintable(told(-10.0)));
        QVERIFY2(!told(10.0).contains("likely"), qPrintable(told(10.0)));
    }

    void sampleBuildersBeginOutside()
    {
        for (const Builder& builder : allBuilders())
            QCOMPARE(warningOf(*build(builder, {})), QString());
    }

    // High stiffeners lift the rod, whichever way it swings.
    void aStiffenedRodStaysOverTheGround()
    {
        for (const double height : {0.1, 1.0, 2.5, 10.0, 100.0})
            QCOMPARE(warningOf(*build(*findBuilder("stiffened_rod"), {{"height", height}})),
                     QString());
    }

    // What is 1 m high cannot hang from 0.5 m.
    void aClothDoesNotHangIntoTheGround()
    {
        const Builder& cloth = *findBuilder("cloth");
        const auto refused = build(cloth, {{"flat", 0}, {"level", 0.5}, {"sphere", 0}});
        QVERIFY(!refused);
        const QString told = QString::fromStdString(refused.message().english());
        QVERIFY2(told.contains("level of at least its height"), qPrintable(told));
        QVERIFY(build(cloth, {{"flat", 0}, {"level", 1.0}, {"sphere", 0}}));
        QVERIFY(build(cloth, {{"flat", 1}, {"level", 0.5}, {"sphere", 0}}));
    }
};

const RegisteredTest registered("test_start_check", runPlain<TestStartCheck>);

} // namespace ripstop::test_start_check
#include "test_start_check.moc"
