// Colliders as authored: what becomes of them, what is wrong with them, and where their files are.
//
// Stages: turns, fields, paths and hills, with the words of refusals; scenes with and without
// flaws; then files of shapes beside the scene and in other folders; and colliders in a live scene
// and under a control.
#include "builders/builder.h"
#include "check/check.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "compile/patch.h"
#include "derived/collider_shape.h"
#include "io/scene_file.h"
#include "model/systems.h"
#include "registered_test.h"
#include "scene/collider_path.h"
#include "scene/path.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <Eigen/LU>

namespace ripstop::test_colliders {

namespace {

constexpr Id colliderId{900};
constexpr const char* squareObj = "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 4 3 2\n";

// A cloth without colliders, and one collider.
Scene sceneWith(const Collider& collider)
{
    Scene scene = *build(*findBuilder("cloth"), {{"columns", 4}, {"rows", 4}, {"sphere", 0}});
    std::erase_if(scene.items,
                  [](const Entry& entry) { return std::holds_alternative<Collider>(entry.item); });
    scene.items.push_back({colliderId, collider});
    scene.nextId = Id{901};
    return scene;
}

Collider shaped(ColliderShape shape)
{
    Collider collider;
    collider.name = "thing";
    collider.shape = shape;
    return collider;
}

Obstacle obstacleOf(const Collider& collider)
{
    const auto system = compile(sceneWith(collider));
    if (!system)
        qFatal("%s", system.message().english().c_str());
    return (*system)->obstacles.back();
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QString problem(const Collider& collider)
{
    const auto problems = problemsOf(sceneWith(collider));
    for (const Finding& found : problems)
        if (found.culprit() == colliderId)
            return QString::fromStdString(found.message.english());
    return {};
}

} // namespace

class TestColliders : public QObject
{
    Q_OBJECT

private slots:
    // Euler angles in degrees about x, then y, then z.
    void turn()
    {
        Collider box = shaped(ColliderShape::Box);
        box.turn = Vec3(90.0, 0.0, 0.0);
        QVERIFY(isNear(obstacleOf(box).turn * Vec3::UnitY(), Vec3::UnitZ(), 1e-15));
        box.turn = Vec3(90.0, 90.0, 0.0); // y to z by the first, z to x by the second
        QVERIFY(isNear(obstacleOf(box).turn * Vec3::UnitY(), Vec3::UnitX(), 1e-15));
        box.turn = Vec3(90.0, 90.0, 90.0); // and x to y by the third
        QVERIFY(isNear(obstacleOf(box).turn * Vec3::UnitY(), Vec3::UnitY(), 1e-15));
        box.turn = Vec3(12.0, 34.0, 56.0);
        QVERIFY(isNear(obstacleOf(box).turn.determinant(), 1.0, 1e-14));
    }

    void fields()
    {
        Collider box = shaped(ColliderShape::Box);
        box.size = Vec3(1.0, 2.0, 3.0);
        box.thickness = 0.02;
        box.path = "0: 0 1 0; 2.5: 3, 1, 0";
        const Obstacle obstacle = obstacleOf(box);
        QCOMPARE(obstacle.size, box.size);
        QCOMPARE(obstacle.thickness, 0.02);
        QCOMPARE(obstacle.key, Key(colliderId));
        QCOMPARE(obstacle.path.size(), std::size_t(2));
        QCOMPARE(obstacle.path[1].time, 2.5);
        QCOMPARE(obstacle.path[1].place, Vec3(3.0, 1.0, 0.0));
        Collider drum = shaped(ColliderShape::Cylinder);
        drum.radius = 0.4;
        drum.size.y() = 3.0;
        drum.turn = Vec3(90.0, 0.0, 0.0);
        const Obstacle lying = obstacleOf(drum);
        QVERIFY(lying.shape == ColliderShape::Cylinder);
        QCOMPARE(lying.radius, 0.4);
        QCOMPARE(lying.size.y(), 3.0);
        QVERIFY(isNear(lying.turn * Vec3::UnitY(), Vec3::UnitZ(), 1e-15));
        const Obstacle hills = obstacleOf(shaped(ColliderShape::HeightField));
        QVERIFY(hills.grid);
        QCOMPARE(hills.grid->columns, 256); // the default
        QCOMPARE(hills.grid->rows, 256);
    }

    void paths_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("keys"); // -1 is refused
        QTest::newRow("none") << "" << 0;
        QTest::newRow("blank") << "  " << 0;
        QTest::newRow("one") << "1: 2 3 4" << 1;
        QTest::newRow("end mark, commas") << " 0:0,0,0 ; 1e-1: -2, 3.5, 4; " << 2;
        QTest::newRow("a number short") << "0: 1 2" << -1;
        QTest::newRow("a number over") << "0: 1 2 3 4" << -1;
        QTest::newRow("no colon") << "0 1 2 3" << -1;
        QTest::newRow("a word") << "0: 1 2 three" << -1;
        QTest::newRow("back in time") << "1: 0 0 0; 1: 1 0 0" << -1;
        QTest::newRow("infinite") << "inf: 0 0 0" << -1;
        QTest::newRow("an empty row") << "0: 0 0 0;; 1: 0 0 0" << -1;
    }
    void paths()
    {
        QFETCH(QString, text);
        QFETCH(int, keys);
        const auto path = pathFromText(text.toStdString());
        QCOMPARE(path ? int(path->size()) : -1, keys);
        const Property& property = *findProperty(Kind::Collider, "path");
        QCOMPARE(refusal(property, text.toStdString()).has_value(), keys < 0);
    }

    void pathRefusalsNameTheRow()
    {
        const auto message = [](const char* text) {
            return QString::fromStdString(pathFromText(text).message().english());
        };
        QVERIFY(message("0: 1 2 3; 1: 2 3").contains("row 2, \" 1: 2 3\", is not"));
        QVERIFY(message("0: 1 2 3; 2: 2 3 4; 1: 0 0 0").contains("row 3"));
    }

    // Neither the engine nor the view is given a field without width: they would never end.
    void hillsNeedASize_data()
    {
        QTest::addColumn<double>("width");
        QTest::newRow("none") << 0.0;
        QTest::newRow("negative") << -2.0;
        QTest::newRow("not a number") << std::nan("");
    }
    void hillsNeedASize()
    {
        QFETCH(double, width);
        Collider hills = shaped(ColliderShape::HeightField);
        for (const int axis : {0, 2}) {
            hills.size = Vec3(4.0, 1.0, 4.0);
            hills.size[axis] = width;
            const Scene scene = sceneWith(hills);
            QVERIFY(!gridOf(scene, hills));
            QVERIFY(!compile(scene));
        }
        hills.size = Vec3(4.0, 0.0, 4.0); // flat ground is ground
        QVERIFY(gridOf(sceneWith(hills), hills));
    }

    void flaws_data()
    {
        QTest::addColumn<Collider>("collider");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, ColliderShape shape, auto spoil, const char* says) {
            Collider collider = shaped(shape);
            spoil(collider);
            QTest::newRow(name) << collider << says;
        };
        using enum ColliderShape;
        row(
            "plane", Plane, [](Collider& c) { c.normal.setZero(); }, "needs a normal");
        row(
            "box", Box, [](Collider& c) { c.size.y() = 0.0; }, "needs edges above 0");
        row(
            "cylinder", Cylinder, [](Collider& c) { c.size.y() = 0.0; }, "needs a height above 0");
        row(
            "thin pole", Cylinder, [](Collider& c) { c.radius = 0.01; }, "fits between particles");
        row(
            "hills", HeightField, [](Collider& c) { c.size.x() = -1.0; }, "needs a width");
        row(
            "no file", Mesh, [](Collider&) {}, "set its file");
        row(
            "missing mesh", Mesh, [](Collider& c) { c.file = "no/such.obj"; }, "no/such.obj");
        row(
            "missing picture", HeightField, [](Collider& c) { c.file = "no/such.png"; },
            "no/such.png");
        row(
            "path", Sphere, [](Collider& c) { c.path = "0: 1"; }, "its path must be");
        row(
            "small ball", Sphere, [](Collider& c) { c.radius = 0.01; }, "fits between particles");
        row(
            "thin rod", Box, [](Collider& c) { c.size = Vec3(5.0, 0.01, 0.01); }, "fits between");
    }
    void flaws()
    {
        QFETCH(Collider, collider);
        QFETCH(QString, says);
        const QString message = problem(collider);
        QVERIFY2(message.contains(says) && message.contains("thing") && message.endsWith('.'),
                 qPrintable(message));
    }
    // A line slips by a bar that is thinner than its links are long.
    void barThinnerThanLinks()
    {
        const auto warns = [](double segments) {
            Scene scene = *build(*findBuilder("rope"), {{"length", 2.0}, {"segments", segments}});
            Collider bar = shaped(ColliderShape::Cylinder);
            bar.radius = 0.02;
            scene.items.push_back({colliderId, bar});
            scene.nextId = Id{901};
            const auto problems = problemsOf(scene);
            return std::ranges::any_of(problems, [](const Finding& found) {
                return found.culprit() == colliderId
                       && found.message.english().find("the links of rope are 0.1 m long")
                              != std::string::npos;
            });
        };
        QVERIFY(warns(20.0));
        QVERIFY(!warns(100.0));
    }
    void sound()
    {
        for (std::size_t i = 0; i < choiceNames<ColliderShape>.size(); ++i)
            if (rowOf(ColliderShape(i)).madeOf != MadeOf::Triangles) // which need a file
                QCOMPARE(problem(shaped(ColliderShape(i))), QString());
        Collider plate = shaped(ColliderShape::Box);
        plate.size = Vec3(2.0, 0.001, 2.0); // thin, and wider than the gaps: nothing tunnels
        QCOMPARE(problem(plate), QString());
        Collider disc = shaped(ColliderShape::Cylinder);
        disc.size = Vec3(0.0, 0.001, 0.0); // only its height counts
        QCOMPARE(problem(disc), QString());
    }

    // Every shape comes back from a file as it was.
    void filesKeepTheShape()
    {
        QTemporaryDir folder;
        const std::string file = folder.filePath("a.ripstop.json").toStdString();
        for (std::size_t i = 0; i < choiceNames<ColliderShape>.size(); ++i) {
            Collider collider = shaped(ColliderShape(i));
            collider.radius = 0.4;
            collider.size = Vec3(1.0, 3.0, 2.0);
            collider.turn = Vec3(10.0, 20.0, 30.0);
            const Scene written = sceneWith(collider);
            QVERIFY(!saveScene(written, file));
            const Result<Scene> read = readScene(file);
            QVERIFY(read && *read == written);
        }
    }

    // A path in a scene starts at the scene file, wherever the program is.
    void filesLieBesideTheScene()
    {
        QTemporaryDir folder;
        QDir(folder.path()).mkdir("meshes");
        write(folder.filePath("meshes/square.obj"), squareObj);
        Collider mesh = shaped(ColliderShape::Mesh);
        mesh.file = "meshes/square.obj";
        mesh.scale = 2.0;
        const Scene written = sceneWith(mesh);
        QVERIFY(hasErrors(problemsOf(written))); // not in the working directory
        const std::string file = folder.filePath("a.ripstop.json").toStdString();
        QVERIFY(!saveScene(written, file));

        const Result<Scene> scene = readScene(file);
        QVERIFY(scene);
        QVERIFY(*scene == written); // where it lies is not part of it
        QVERIFY(!hasErrors(problemsOf(*scene)));
        const auto system = compile(*scene);
        QVERIFY(system);
        const Obstacle& obstacle = (*system)->obstacles.back();
        QCOMPARE(obstacle.mesh->faces().size(), std::size_t(2));
        QCOMPARE(obstacle.scale, 2.0);

        Simulation simulation(*system);
        QVERIFY(simulation.runUntil(3.0)); // 1.6 m down onto it
        for (const Vec3& x : simulation.state().position)
            QVERIFY2(std::max(std::abs(x.x()), std::abs(x.z())) > 2.0 || x.y() > 0.0,
                     told(x, Vec3::Zero()));

        QFile::remove(folder.filePath("meshes/square.obj"));
        const auto problems = problemsOf(*scene);
        QVERIFY(hasErrors(problems));
        const QString message = QString::fromStdString(problems.front().message.english());
        QVERIFY2(message.contains(folder.filePath("meshes/square.obj"))
                     && message.contains("does not exist; put it there"),
                 qPrintable(message));
        QVERIFY(!compile(*scene));
    }

    // A scene that is saved in another folder still finds what lay beside the first one.
    void filesAreFoundFromAnotherFolder()
    {
        QTemporaryDir folder;
        QDir(folder.path()).mkpath("first/meshes");
        QDir(folder.path()).mkdir("second");
        write(folder.filePath("first/meshes/square.obj"), squareObj);
        Collider mesh = shaped(ColliderShape::Mesh);
        mesh.file = "meshes/square.obj";
        Scene scene = sceneWith(mesh);
        scene.folder.path = folder.filePath("first").toStdString();
        const auto fileIn = [&](const char* place) {
            const std::string file = folder.filePath(place).toStdString();
            if (saveScene(scene, file))
                return std::string("not saved");
            const Result<Scene> read = readScene(file);
            return hasErrors(problemsOf(*read)) ? std::string("not found")
                                                : findItem<Collider>(*read, colliderId)->file;
        };
        QCOMPARE(fileIn("first/a.ripstop.json"), std::string("meshes/square.obj"));
        QCOMPARE(fileIn("second/a.ripstop.json"), std::string("../first/meshes/square.obj"));
        QCOMPARE(fileIn("a.ripstop.json"), std::string("first/meshes/square.obj"));
        std::get<Collider>(*findItem(scene, colliderId)).file =
            folder.filePath("first/meshes/square.obj").toStdString();
        QCOMPARE(QString::fromStdString(fileIn("second/b.ripstop.json")),
                 folder.filePath("first/meshes/square.obj"));
    }

    // A live scene whose file is missing goes on as it was, and says why.
    void liveScene()
    {
        Scene scene = sceneWith(shaped(ColliderShape::Box));
        LiveSystem live(scene);
        QVERIFY(std::holds_alternative<Update>(live.update(1, 1)));
        const auto set = [&](const char* assigned) {
            const auto edit = assignment(live.scene(), assigned);
            if (!edit)
                qFatal("%s", edit.message().english().c_str());
            live.apply(*edit);
        };
        set("thing.shape=mesh");
        const auto failed = live.update(2, 1);
        QVERIFY(std::holds_alternative<Finding>(failed));
        set("thing.shape=height_field");
        const auto update = live.update(3, 1);
        QVERIFY(std::holds_alternative<Update>(update));
        const auto& patch = std::get<Update>(update).patch;
        QVERIFY(patch && patch->obstacles && patch->obstacles->back().grid);
        set("sheet.selfContact=0.01");
        const auto layers = live.update(4, 1);
        QVERIFY(std::get<Update>(layers).patch->fabricLayers);
        QCOMPARE(std::get<Update>(layers).patch->fabricLayers->front().thickness, 0.01);
    }

    // A control moves a collider; frames say where it is.
    void control()
    {
        Scene scene = sceneWith(shaped(ColliderShape::Box));
        Control control;
        control.name = "push";
        control.targets = {colliderId};
        control.axis = Vec3(0.0, 0.0, 2.0);
        scene.items.push_back({Id{901}, control});
        scene.nextId = Id{902};
        QVERIFY(!hasErrors(problemsOf(scene)));
        const auto system = compile(scene);
        QVERIFY(system);
        Simulation simulation(*system);
        simulation.command({{901, 0.25}});
        QVERIFY(simulation.runUntil(1.0));
        const auto frame = simulation.frame();
        QCOMPARE(frame->layout->colliderId, std::vector<std::uint32_t>{900});
        QVERIFY2(isNear(frame->colliderPosition[0], Vec3(0.0, 0.0, 0.25), 1e-12),
                 told(frame->colliderPosition[0], Vec3(0.0, 0.0, 0.25)));
    }
};

const RegisteredTest registered("test_colliders", runPlain<TestColliders>);

} // namespace ripstop::test_colliders
#include "test_colliders.moc"
