// Meshes and animations for other programs, read back by other means than ours where there are any.
//
// Stages: each format is written and read back; caches with fabric that tears or has split;
// designs that change on the way or show nothing; then files that stay until the new one is whole,
// sequences of files, and formats that are chosen by name.
#include "compile/compile.h"
#include "export/export_run.h"
#include "export/format.h"
#include "model/files.h"
#include "model/meshes.h"
#include "model/written_series.h"
#include "registered_test.h"
#include "shapes/mesh_file.h"
#include "simulation/simulation.h"

#include <Eigen/Geometry>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtEndian>
#include <QtTest>

#include <cstring>

namespace ripstop::test_export_series {

namespace {

// Two panels with a place each in the picture on the fabric, and a line below.
//
//     3---2
//     | / |      4: hangs on 0
//     0---1
Scene kite()
{
    Part part;
    const auto particle = [](unsigned id, Vec3 position, double u, double v) {
        return Particle{.id = Id{id}, .position = position, .textureU = u, .textureV = v};
    };
    part.particles = {particle(11, {0, 0, 0.125}, 0.25, 0.25), particle(12, {1, 0, 0}, 0.75, 0.25),
                      particle(13, {1, 1, 0.5}, 0.75, 1.0), particle(14, {0, 1, 0}, 0.25, 1.0),
                      particle(15, {0, -1, 0}, 0.0, 0.0)};
    part.particles[0].pinned = true;
    part.links = {{.id = Id{21}, .from = Id{11}, .to = Id{13}},
                  {.id = Id{22}, .from = Id{11}, .to = Id{15}}};
    part.panels = {{Id{31}, Id{11}, Id{12}, Id{13}}, {Id{32}, Id{11}, Id{13}, Id{14}}};
    Scene scene;
    scene.settings.timeStep = 0.01;
    scene.items = {{Id{1}, part}};
    scene.nextId = Id{40};
    return scene;
}

std::shared_ptr<Frame> startOf(const Scene& scene) { return Simulation(*compile(scene)).frame(); }

using Triangle = std::array<std::array<double, 3>, 3>;

// The faces as sets of places, with the corner that sorts first in front and the sense kept; so
// compare meshes whose vertices have other numbers.
std::vector<Triangle> trianglesOf(const PolygonMesh& mesh)
{
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < mesh.faceCount(); ++i) {
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k)
            for (Eigen::Index x = 0; x < 3; ++x)
                triangle[k][std::size_t(x)] = mesh.points[std::size_t(mesh.face(i)[k])][x];
        std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
        triangles.push_back(triangle);
    }
    std::ranges::sort(triangles);
    return triangles;
}

template <typename T>
T numberAt(const QByteArray& bytes, qsizetype at, QSysInfo::Endian order)
{
    using Raw = std::conditional_t<sizeof(T) == 4, quint32, quint64>;
    const Raw raw = order == QSysInfo::BigEndian ? qFromBigEndian<Raw>(bytes.constData() + at)
                                                 : qFromLittleEndian<Raw>(bytes.constData() + at);
    T value;
    std::memcpy(&value, &raw, sizeof value);
    return value;
}

// The design as it stands, and 1/25 s later lifted by 2 m, with the diagonal torn and the panel
// beside it gone.
std::array<Frame, 2> tearing(const Scene& scene)
{
    const Frame before = *startOf(scene);
    Frame after = before;
    after.time = 0.04;
    for (Vec3& place : after.position)
        place.y() += 2.0;
    after.torn[0] = 1;
    after.gone[1] = 1;
    return {before, after};
}

} // namespace

class TestExportSeries : public QObject
{
    Q_OBJECT

private slots:
    void comesBack_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<bool>("hasTexture");
        QTest::newRow("OBJ") << "kite.obj" << true;
        QTest::newRow("PLY") << "kite.ply" << false;
        QTest::newRow("STL") << "kite.stl" << false;
        QTest::newRow("glTF") << "kite.glb" << true;
        QTest::newRow("Collada") << "kite.dae" << true;
    }

    // The numbers of the scene are exact in single precision.
    void comesBack()
    {
        QFETCH(QString, file);
        QFETCH(bool, hasTexture);
        QTemporaryDir folder;
        const std::string path = folder.filePath(file).toStdString();
        const Scene scene = kite();
        const auto failure = writeMoment(*startOf(scene), MeshAppearance(scene), path);
        QVERIFY2(!failure, failure ? failure->message.english().c_str() : "");

        const Result<PolygonMesh> mesh = readPolygonFile(path, {});
        QVERIFY2(bool(mesh), mesh ? "" : mesh.message().english().c_str());
        const std::vector<Triangle> expected{{{{0, 0, 0.125}, {1, 0, 0}, {1, 1, 0.5}}},
                                             {{{0, 0, 0.125}, {1, 1, 0.5}, {0, 1, 0}}}};
        QVERIFY(trianglesOf(*mesh) == expected);
        QCOMPARE(!mesh->texture.empty(), hasTexture);
        for (std::size_t i = 0; i < mesh->texture.size(); ++i) {
            const Vec3& place = mesh->points[std::size_t(mesh->corners[i])];
            QCOMPARE(mesh->texture[i][0], place.x() == 0.0 ? 0.25 : 0.75);
            QCOMPARE(mesh->texture[i][1], place.y() == 0.0 ? 0.25 : 1.0);
        }
    }

    // What faces and lines take their numbers from says which of these it is (COLLADA 1.4.1,
    // "input" of a primitive); readers that check this, as Blender does, refuse the file otherwise.
    void inputsOfColladaHaveOffsets()
    {
        QTemporaryDir folder;
        const Scene scene = kite();
        const QString path = folder.filePath("kite.dae");
        QVERIFY(!writeMoment(*startOf(scene), MeshAppearance(scene), path.toStdString()));
        QXmlStreamReader xml(contentOf(path));
        QStringList within;
        int inputs = 0;
        while (!xml.atEnd()) {
            xml.readNext();
            if (xml.isEndElement())
                within.pop_back();
            if (!xml.isStartElement())
                continue;
            const bool isOfPrimitive =
                !within.empty() && (within.back() == "lines" || within.back() == "polylist");
            if (xml.name() == QString("input") && isOfPrimitive) {
                QVERIFY2(xml.attributes().hasAttribute("offset"), qPrintable(within.join(" / ")));
                ++inputs;
            }
            within.push_back(xml.name().toString());
        }
        QVERIFY(!xml.hasError());
        QCOMPARE(inputs, 3 + 1); // place, normal and texture point of faces, the place of lines
    }

    // Two triangles that do not lie in one plane have two normals (binary STL: 84 bytes, then 50 of
    // each, the normal first).
    void facetsOfStlHaveTheirOwnNormals()
    {
        QTemporaryDir folder;
        const Scene scene = kite();
        const QString path = folder.filePath("kite.stl");
        QVERIFY(!writeMoment(*startOf(scene), MeshAppearance(scene), path.toStdString()));
        const QByteArray bytes = contentOf(path);
        QCOMPARE(bytes.size(), qsizetype(84 + 2 * 50));
        for (qsizetype facet = 84; facet < bytes.size(); facet += 50) {
            std::array<Vec3, 4> row; // the normal, then the corners
            for (qsizetype i = 0; i < 12; ++i)
                row[std::size_t(i / 3)][i % 3] =
                    double(numberAt<float>(bytes, facet + 4 * i, QSysInfo::LittleEndian));
            const Vec3 expected = (row[2] - row[1]).cross(row[3] - row[1]).normalized();
            QVERIFY((row[0] - expected).norm() < 1e-6);
        }
    }

    void caches_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("order");
        QTest::addColumn<qsizetype>("header");
        QTest::addColumn<qsizetype>("points"); // where the number of points stands
        QTest::addColumn<qsizetype>("frames"); // and that of frames
        QTest::newRow("PC2") << "pc2" << int(QSysInfo::LittleEndian) << qsizetype(32)
                             << qsizetype(16) << qsizetype(28);
        QTest::newRow("MDD") << "mdd" << int(QSysInfo::BigEndian) << qsizetype(8 + 2 * 4)
                             << qsizetype(4) << qsizetype(0);
    }

    // The panel that goes has three corners of its own and the line that breaks two ends, beside
    // the three corners of the panel that stays and the end of the other line.
    void caches()
    {
        QFETCH(QString, ending);
        QFETCH(int, order);
        QFETCH(qsizetype, header);
        QFETCH(qsizetype, points);
        QFETCH(qsizetype, frames);
        const auto byteOrder = QSysInfo::Endian(order);
        QTemporaryDir folder;
        const Scene scene = kite();
        const auto failure = writeSeries(tearing(scene), MeshAppearance(scene),
                                         folder.filePath("kite." + ending).toStdString());
        QVERIFY2(!failure, failure ? failure->message.english().c_str() : "");
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files),
                 (ending < "obj" ? QStringList{"kite." + ending, "kite.mtl", "kite.obj"}
                                 : QStringList{"kite.mtl", "kite.obj", "kite." + ending}));

        const QByteArray bytes = contentOf(folder.filePath("kite." + ending));
        constexpr qsizetype vertices = 3 + 3 + 2 + 1;
        QCOMPARE(numberAt<qint32>(bytes, points, byteOrder), qint32(vertices));
        QCOMPARE(numberAt<qint32>(bytes, frames, byteOrder), 2);
        QCOMPARE(bytes.size(), header + 2 * vertices * 12);
        if (ending == "mdd")
            QCOMPARE(numberAt<float>(bytes, 12, byteOrder), 0.04f);

        const auto place = [&](qsizetype frame, qsizetype vertex) {
            Vec3 x;
            for (qsizetype i = 0; i < 3; ++i)
                x[i] = double(numberAt<float>(
                    bytes, header + (frame * vertices + vertex) * 12 + 4 * i, byteOrder));
            return x;
        };
        const Result<PolygonMesh> mesh =
            readPolygonFile(folder.filePath("kite.obj").toStdString(), {});
        QVERIFY(mesh);
        QCOMPARE(mesh->faceCount(), std::size_t(2));
        for (qsizetype i = 0; i < vertices; ++i)
            QCOMPARE(place(0, i), mesh->points[std::size_t(i)]);

        // what stays has moved, what went is a point: the mean of its corners
        const Vec3 up(0.0, 2.0, 0.0);
        const Vec3 mean = (Vec3(0, 0, 0.125) + Vec3(1, 1, 0.5) + Vec3(0, 1, 0)) / 3.0 + up;
        for (const int i : mesh->face(0))
            QCOMPARE(place(1, i), Vec3(place(0, i) + up));
        for (const int i : mesh->face(1))
            QVERIFY((place(1, i) - mean).norm() < 1e-6);
    }

    // Vertex i of a cache is vertex i of the mesh of a moment, which is particle i, in whatever
    // order panels name the particles, and also where one is loose: caches go onto that mesh.
    void cachesHaveTheOrderOfTheMesh_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<int>("order");
        QTest::addColumn<qsizetype>("header");
        QTest::newRow("PC2") << "pc2" << int(QSysInfo::LittleEndian) << qsizetype(32);
        QTest::newRow("MDD") << "mdd" << int(QSysInfo::BigEndian) << qsizetype(8 + 2 * 4);
    }
    void cachesHaveTheOrderOfTheMesh()
    {
        QFETCH(QString, ending);
        QFETCH(int, order);
        QFETCH(qsizetype, header);
        Scene scene = kite();
        Part& part = std::get<Part>(scene.items.front().item);
        std::ranges::reverse(part.panels);
        std::ranges::rotate(part.links, part.links.begin() + 1);
        part.particles.insert(part.particles.begin(), {.id = Id{10}, .position = {7, 8, 9}});
        QTemporaryDir folder;
        const Frame start = *startOf(scene);
        const MeshAppearance appearance(scene);
        QVERIFY(!writeMoment(start, appearance, folder.filePath("one.obj").toStdString()));
        Frame end = start;
        end.time = 0.04;
        QVERIFY(!writeSeries(std::array{start, end}, appearance,
                             folder.filePath("kite." + ending).toStdString()));
        const QByteArray bytes = contentOf(folder.filePath("kite." + ending));
        QCOMPARE(bytes.size(), header + qsizetype(2 * 6 * 12));
        for (const char* name : {"one.obj", "kite.obj"}) {
            const Result<PolygonMesh> mesh =
                readPolygonFile(folder.filePath(name).toStdString(), {});
            QVERIFY(mesh);
            QCOMPARE(mesh->points.size(), part.particles.size());
            for (std::size_t i = 0; i < mesh->points.size(); ++i) {
                QCOMPARE(mesh->points[i], part.particles[i].position);
                for (qsizetype axis = 0; axis < 3; ++axis)
                    QCOMPARE(double(numberAt<float>(bytes, header + qsizetype(i) * 12 + 4 * axis,
                                                    QSysInfo::Endian(order))),
                             part.particles[i].position[axis]);
            }
        }
    }

    // Fabric that a tear has split has both sides from the start, in one place.
    void splitFromTheStart()
    {
        QTemporaryDir folder;
        const Scene scene = kite();
        Frame before = *startOf(scene);
        Frame after = before;
        auto layout = std::make_shared<Layout>(*before.layout);
        for (const std::size_t i : {0u, 2u}) { // twins of the ends of the diagonal
            layout->particleId.push_back(layout->particleId[i]);
            after.position.push_back(after.position[i] - Vec3(3.0, 0.0, 0.0));
            after.velocity.push_back(Vec3::Zero());
        }
        layout->particleKey = {11, 12, 13, 14, 15, 101, 102};
        layout->panelCorners[1] = {5, 6, 3};
        after.layout = layout;
        after.time = 0.04;
        const std::array frames{before, after};
        const auto failure =
            writeSeries(frames, MeshAppearance(scene), folder.filePath("a.pc2").toStdString());
        QVERIFY2(!failure, failure ? failure->message.english().c_str() : "");
        const Result<PolygonMesh> mesh =
            readPolygonFile(folder.filePath("a.obj").toStdString(), {});
        QVERIFY(mesh);
        QCOMPARE(mesh->points.size(), std::size_t(7));
        const std::vector<Triangle> expected{{{{0, 0, 0.125}, {1, 0, 0}, {1, 1, 0.5}}},
                                             {{{0, 0, 0.125}, {1, 1, 0.5}, {0, 1, 0}}}};
        QVERIFY(trianglesOf(*mesh) == expected); // the first frame, whole
    }

    void anotherDesignOnTheWay()
    {
        QTemporaryDir folder;
        const Scene scene = kite();
        Scene larger = scene;
        std::get<Part>(larger.items[0].item).panels.pop_back();
        const std::array frames{*startOf(scene), *startOf(larger)};
        const auto failure =
            writeSeries(frames, MeshAppearance(scene), folder.filePath("a.glb").toStdString());
        QVERIFY(failure);
        QVERIFY2(failure->message.english().find("sequence") != std::string::npos,
                 failure->message.english().c_str());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void nothingToShow()
    {
        QTemporaryDir folder;
        Frame frame;
        frame.layout = std::make_shared<Layout>();
        for (const char* name : {"a.glb", "a.pc2", "a.mdd", "a.gltf"})
            QVERIFY(writeSeries(std::array{frame}, MeshAppearance(),
                                folder.filePath(name).toStdString()));
        for (const char* name : {"a.glb", "a.stl", "a.dae"})
            QVERIFY(writeMoment(frame, MeshAppearance(), folder.filePath(name).toStdString()));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    // n frames of a glTF are n - 1 morph targets, each of which has a weight in each frame
    // (glTF 2.0, 3.11), four bytes or, as text, a third more: of a small mesh they are the most of
    // it.
    void sizesOfAnimationsAreAboutAsTold()
    {
        QTemporaryDir folder;
        const Scene scene = kite();
        std::vector<Frame> frames(400, *startOf(scene));
        for (std::size_t i = 0; i < frames.size(); ++i) {
            frames[i].time = 0.01 * double(i);
            frames[i].position[1].z() += 0.001 * double(i);
        }
        for (const char* name : {"a.glb", "a.gltf"}) {
            const std::string target = folder.filePath(name).toStdString();
            QVERIFY(!writeSeries(frames, MeshAppearance(scene), target));
            const double size = double(QFileInfo(folder.filePath(name)).size());
            QVERIFY(size > 4.0 * 400.0 * 399.0);
            const double told = expectedSize(*formatOf(target), *frames[0].layout,
                                             MeshAppearance(scene), frames.size());
            QVERIFY2(std::abs(told / size - 1.0) < 0.15,
                     qPrintable(QString("%1: %2 of %3 bytes").arg(name).arg(told).arg(size)));
        }
    }

    // Lines of several materials are a primitive (mode 1 of glTF 2.0, LINES) for each.
    void linesHaveTheirMaterials()
    {
        QTemporaryDir folder;
        Scene scene = kite();
        scene.items.push_back({Id{2}, Material{"cord"}});
        scene.items.push_back({Id{3}, Material{"bridle"}});
        Part& part = std::get<Part>(scene.items[0].item);
        part.links[0].material = Id{2};
        part.links[1].material = Id{3};
        const QString path = folder.filePath("kite.gltf");
        QVERIFY(!writeSeries(tearing(scene), MeshAppearance(scene), path.toStdString()));
        const QJsonObject model = QJsonDocument::fromJson(contentOf(path)).object();
        QStringList names;
        for (const QJsonValue mesh : model["meshes"].toArray())
            for (const QJsonValue primitive : mesh["primitives"].toArray())
                if (primitive["mode"].toInt() == 1)
                    names << model["materials"][primitive["material"].toInt()]["name"].toString();
        QCOMPARE(names, (QStringList{"cord", "bridle"}));
    }

    // What was there stays until the new one is whole.
    void theOldFileStays()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kite.glb");
        QFile old(path);
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("old");
        old.close();
        Simulation simulation(*compile(kite()));
        FlownFrames flown(simulation);
        QVERIFY(exportRun(flown, MeshAppearance(), {.to = 1.0}, path.toStdString(),
                          [](double done) { return done < 0.9; }));
        QCOMPARE(contentOf(path), QByteArray("old"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void sequence()
    {
        QTemporaryDir folder;
        const Scene scene = kite();
        const std::string target = folder.filePath("sail_{frame}.obj").toStdString();
        QVERIFY(!writeSeries(tearing(scene), MeshAppearance(scene), target));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files),
                 (QStringList{"sail_0000.mtl", "sail_0000.obj", "sail_0001.obj"}));
        const auto first = readPolygonFile(folder.filePath("sail_0000.obj").toStdString(), {});
        const auto second = readPolygonFile(folder.filePath("sail_0001.obj").toStdString(), {});
        QVERIFY(first && second);
        QCOMPARE(first->faceCount(), std::size_t(2));
        QCOMPARE(second->faceCount(), std::size_t(1));
    }

    // Each name is known by its own row only, so that dialog and command line mean the same.
    void formatsAreToldByTheirNames()
    {
        for (const ExportFormat& format : exportFormats()) {
            const ExportFormat* found = formatOf("kite" + std::string(format.ending));
            QVERIFY2(found == &format, format.ending.data());
        }
        QCOMPARE(formatOf("KITE.STL"), formatOf("kite.stl"));
        QVERIFY(!formatOf("kite.abc"));
        QVERIFY(!formatOf("kite"));
    }
};

const RegisteredTest registered("test_export_series", runPlain<TestExportSeries>);

} // namespace ripstop::test_export_series
#include "test_export_series.moc"
