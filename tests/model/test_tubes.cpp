// Round lines as tubes, and in glTF files as a mesh beside the fabric.
#include "base/tubes_mark.h"
#include "compile/compile.h"
#include "export/tubes.h"
#include "model/files.h"
#include "model/written_series.h"
#include "registered_test.h"
#include "shapes/mesh_file.h"
#include "simulation/simulation.h"

#include <Eigen/Geometry>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include <numbers>

namespace ripstop::test_tubes {

namespace {

constexpr double diameter = 0.25; // m
constexpr float rounding = 1e-6F;

// A spar that is 2 m long, from 0 to 1, and a hem of no thickness.
Surface sparAndHem()
{
    Surface surface;
    surface.name = "wing";
    surface.position = {{1, 0, 0}, {3, 0, 0}, {1, 1, 0}};
    surface.lines = {{0, 1}, {0, 2}};
    surface.lineFabric = {0, 1};
    surface.fabrics = {{"spar", {0, 0, 0}, {}, diameter}, {"hem", {0, 0, 0}}};
    return surface;
}

std::vector<Eigen::Vector3f> placesOf(const Surface& surface)
{
    std::vector<Eigen::Vector3f> places;
    for (const Vec3& place : surface.position)
        places.push_back(place.cast<float>());
    return places;
}

// A panel, and a line of 6 mm that hangs from its first corner.
Scene flag()
{
    Part part;
    part.name = "flag";
    part.particles = {{.id = Id{11}, .position = {0, 0, 0}},
                      {.id = Id{12}, .position = {1, 0, 0}},
                      {.id = Id{13}, .position = {0, 1, 0}},
                      {.id = Id{14}, .position = {0, -1, 0}}};
    part.links = {{.id = Id{21}, .from = Id{11}, .to = Id{14}, .material = Id{2}}};
    part.panels = {{Id{31}, Id{11}, Id{12}, Id{13}}};
    Material cord{"cord"};
    cord.diameter = 0.006;
    Scene scene;
    scene.items = {{Id{1}, part}, {Id{2}, cord}};
    scene.nextId = Id{40};
    return scene;
}

} // namespace

class TestTubes : public QObject
{
    Q_OBJECT

private slots:
    // The mantle of a prism of six sides that the circle goes around has the area 6 r L.
    void isARoundPrism()
    {
        const Tubes tubes(sparAndHem());
        const Surface& mesh = tubes.surface();
        QCOMPARE(mesh.position.size(), Tubes::vertices);
        for (std::size_t i = 0; i < mesh.position.size(); ++i) {
            const Vec3& place = mesh.position[i];
            QVERIFY(std::abs(std::hypot(place.y(), place.z()) - 0.5 * diameter) < double(rounding));
            QVERIFY(std::abs(place.x() - (i < Tubes::sides ? 1.0 : 3.0)) < double(rounding));
        }
        double area = 0.0;
        for (const auto& [a, b, c] : mesh.panels) {
            const Vec3 &first = mesh.position[std::size_t(a)],
                       &second = mesh.position[std::size_t(b)],
                       &third = mesh.position[std::size_t(c)];
            const Vec3 doubled = (second - first).cross(third - first);
            const Vec3 outward(0.0, (first + second + third).y(), (first + second + third).z());
            QVERIFY(doubled.dot(outward) > 0.0);
            area += 0.5 * doubled.norm();
        }
        QVERIFY(std::abs(area - 6.0 * 0.5 * diameter * 2.0) < 1e-5);
    }

    // What turns about an axis across the line takes the tube along as if it were stiff.
    void turnsWithItsLine()
    {
        const Surface surface = sparAndHem();
        const Tubes tubes(surface);
        const Eigen::AngleAxisf turn(float(std::numbers::pi / 3.0), Eigen::Vector3f::UnitZ());
        std::vector<Eigen::Vector3f> places = placesOf(surface);
        const std::vector<Eigen::Vector3f> before = tubes.positions(places);
        for (Eigen::Vector3f& place : places)
            place = turn * place;
        const std::vector<Eigen::Vector3f> after = tubes.positions(places);
        for (std::size_t i = 0; i < before.size(); ++i)
            QVERIFY((after[i] - turn * before[i]).norm() < rounding);
    }

    // So it is where a line has broken in a file of one mesh for all frames.
    void isAPointWhereItsLineIs()
    {
        const Surface surface = sparAndHem();
        std::vector<Eigen::Vector3f> places = placesOf(surface);
        places[0] = places[1] = {2, 5, 7};
        for (const Eigen::Vector3f& place : Tubes(surface).positions(places))
            QCOMPARE(place, Eigen::Vector3f(2, 5, 7));
    }

    // Both meshes are moved by the animation.
    void areAMeshOfTheirOwn()
    {
        QTemporaryDir folder;
        const Scene scene = flag();
        const Frame frame = *Simulation(*compile(scene)).frame();
        Frame later = frame;
        later.time += 0.04;
        for (Vec3& place : later.position)
            place.y() += 2.0;
        const QString path = folder.filePath("flag.gltf");
        QVERIFY(!writeSeries(std::array{frame, later}, MeshAppearance(scene), path.toStdString()));
        const QJsonObject model = QJsonDocument::fromJson(contentOf(path)).object();
        const QJsonArray nodes = model["nodes"].toArray();
        QCOMPARE(nodes.size(), 2);
        QCOMPARE(nodes[0]["name"].toString(), QString("flag"));
        QCOMPARE(nodes[1]["name"].toString(), QString("flag lines"));
        QVERIFY(!nodes[0]["extras"].isObject());
        QVERIFY(nodes[1]["extras"][tubesMark].toBool());
        QCOMPARE(model["animations"][0]["channels"].toArray().size(), 2);
        const QJsonValue tubes = model["meshes"][1]["primitives"][0];
        const QJsonArray accessors = model["accessors"].toArray();
        const auto least = [&](int accessor) { return accessors[accessor]["min"].toArray(); };
        QCOMPARE(tubes["targets"].toArray().size(), 1);
        QCOMPARE(least(tubes["targets"][0]["POSITION"].toInt())[1].toDouble(), 2.0);
        QVERIFY(std::abs(least(tubes["attributes"]["POSITION"].toInt())[1].toDouble() + 1.0)
                < double(rounding));
    }

    // Whoever makes fabric of the file again gets the line, and no fabric around it.
    void stayOutOfWhatIsImported()
    {
        QTemporaryDir folder;
        const Scene scene = flag();
        const std::string path = folder.filePath("flag.glb").toStdString();
        QVERIFY(!writeMoment(*Simulation(*compile(scene)).frame(), MeshAppearance(scene), path));
        const Result<PolygonMesh> mesh = readPolygonFile(path, {});
        QVERIFY2(bool(mesh), mesh ? "" : mesh.message().english().c_str());
        QCOMPARE(mesh->faceCount(), std::size_t(1));
        QCOMPARE(mesh->lines.size(), std::size_t(1));
    }
};

const RegisteredTest registered("test_tubes", runPlain<TestTubes>);

} // namespace ripstop::test_tubes
#include "test_tubes.moc"
