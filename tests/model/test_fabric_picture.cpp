// Pictures on fabric: their size in pixels, where they lie, what is said when one is missing, and
// that they leave with a bundle, a glTF and an OBJ.
#include "derived/fabric_picture.h"
#include "model/cli_call.h"
#include "registered_test.h"

#include "bundle/bundle.h"
#include "check/check.h"
#include "compile/compile.h"
#include "export/export_run.h"
#include "io/scene_file.h"
#include "shapes/shape_files.h"
#include "simulation/simulation.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

namespace ripstop::test_fabric_picture {

namespace {

// The first and the last chunk of a PNG of 30 by 20 pixels, and a JPEG of the same with a segment
// before its frame, and 0xff and a mark of beginning anew within its picture.
const QByteArray png =
    QByteArray::fromHex("89504e470d0a1a0a0000000d494844520000001e000000140802000000"
                        "15c91a930000000049454e44ae426082");
const QByteArray jpeg = QByteArray::fromHex("ffd8ffe000104a46494600010100000100010000"
                                            "ffc0001108001400"
                                            "1e03012200021101031101"
                                            "ffda00080101003f0012ff0034ffd056ffd9");

QString written(const QTemporaryDir& folder, const QString& name, const QByteArray& bytes)
{
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        return {};
    return file.fileName();
}

// A square of 3 m by 2 m with u and v from corner to corner. Ids: part 1, particles 2 to 5 round
// from the lower left, panels 6 and 7, material 8.
Scene sheet(const std::string& picture)
{
    const auto corner = [](std::uint32_t id, double u, double v) {
        Particle particle{.id = Id{id}, .position = Vec3(3.0 * u, 2.0 * v, 0.0), .pinned = true};
        particle.textureU = u;
        particle.textureV = v;
        return particle;
    };
    Scene scene;
    Part part;
    part.particles = {corner(2, 0, 0), corner(3, 1, 0), corner(4, 1, 1), corner(5, 0, 1)};
    part.panels.push_back({Id{6}, Id{2}, Id{3}, Id{4}, Id{8}});
    part.panels.push_back({Id{7}, Id{2}, Id{4}, Id{5}, Id{8}});
    Material material;
    material.name = "sail";
    material.picture = picture;
    scene.items = {{Id{1}, part}, {Id{8}, material}};
    scene.nextId = Id{9};
    return scene;
}

Material& sail(Scene& scene) { return std::get<Material>(*findItem(scene, Id{8})); }

bool isAt(const PrintedPoint& point, double s, double t)
{
    return std::abs(point.at[0] - s) < 1e-9 && std::abs(point.at[1] - t) < 1e-9;
}

QByteArray content(const QString& name)
{
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestFabricPicture : public QObject
{
    Q_OBJECT

private slots:
    void sizesAreRead()
    {
        const QTemporaryDir folder;
        for (const auto& [name, bytes] : {std::pair("a.png", png), std::pair("a.jpg", jpeg)}) {
            const auto size = pictureSize(written(folder, name, bytes).toStdString());
            QVERIFY(size);
            QCOMPARE(size->width, 30);
            QCOMPARE(size->height, 20);
        }
        QVERIFY(
            !pictureSize(written(folder, "a.txt", "no picture at all, but long").toStdString()));
        QVERIFY(!pictureSize(folder.filePath("none.png").toStdString()));
    }

    // A picture that views cannot read is named, or the fabric would be plain without a word.
    void whatCannotBeDrawnIsSaid()
    {
        const QTemporaryDir folder;
        int number = 0; // each in a file of its own, as what was read is remembered
        const auto said = [&](const QByteArray& bytes) {
            const QString name = QString("%1a.png").arg(++number);
            const Scene scene = sheet(written(folder, name, bytes).toStdString());
            const auto warning = pictureWarning(scene, *findItem<Material>(scene, Id{8}));
            return QByteArray::fromStdString(warning ? warning->english() : "");
        };
        QVERIFY(said(png).isEmpty());
        QVERIFY(said(png.chopped(12)).contains("a.png is cut off"));
        QVERIFY(
            said(QByteArray(png).replace(25, 1, "\x03")).contains("a.png is cut off or damaged"));
        QVERIFY(said(jpeg).isEmpty());
        QVERIFY(!pictureSize(folder.path().toStdString()) && !pictureSize("/dev/zero"));
        QVERIFY(said(jpeg.chopped(2)).contains("cut off or damaged"));
        QVERIFY(said(jpeg + "of the camera").isEmpty());
        QVERIFY(said(QByteArray(png).replace(16, 8, QByteArray::fromHex("00004e2000004e20")))
                    .contains("20000 x 20000"));
    }

    void placesFollowFromUAndV()
    {
        const QTemporaryDir folder;
        Scene scene = sheet(written(folder, "a.png", png).toStdString());
        auto points = printedPoints(scene, Id{8});
        QCOMPARE(points.size(), std::size_t(4));
        QCOMPARE(points[0].particle, 2U);
        QVERIFY(isAt(points[0], 0.0, 0.0) && isAt(points[2], 1.0, 1.0)); // as u and v

        sail(scene).pictureRight = 0.25;
        sail(scene).pictureUp = -0.5;
        points = printedPoints(scene, Id{8});
        QVERIFY(isAt(points[0], -0.25, 0.5));

        // 1.5 m wide and, as 30 by 20 pixels are, 1 m tall: twice across and twice up
        sail(scene).pictureRight = sail(scene).pictureUp = 0.0;
        sail(scene).pictureWidth = 1.5;
        points = printedPoints(scene, Id{8});
        QVERIFY(isAt(points[0], -0.5, -0.5) && isAt(points[2], 1.5, 1.5));

        // turned by a quarter: its right points up, so that 3 m to the right go down in it
        sail(scene).pictureTurn = 90.0;
        points = printedPoints(scene, Id{8});
        QVERIFY(isAt(points[0], 0.5 - 1.0 / 1.5, 0.5 + 1.5));
        QVERIFY(isAt(points[1], 0.5 - 1.0 / 1.5, 0.5 - 1.5));
    }

    void fabricWithoutUAndVIsLaidOverItsBox()
    {
        const QTemporaryDir folder;
        Scene scene = sheet(written(folder, "a.png", png).toStdString());
        for (Particle& particle : std::get<Part>(*findItem(scene, Id{1})).particles)
            particle.textureU = particle.textureV = 0.0;
        const auto points = printedPoints(scene, Id{8});
        QVERIFY(isAt(points[0], 0.0, 0.0) && isAt(points[2], 1.0, 1.0));
    }

    void aMissingPictureIsAProblemAndNoError()
    {
        const Scene scene = sheet("nowhere.png");
        bool isFound = false;
        for (const Finding& finding : problemsOf(scene))
            if (finding.message.english().find("without its picture") != std::string::npos) {
                isFound = true;
                QCOMPARE(finding.severity, Severity::Warning);
            }
        QVERIFY(isFound);
        QVERIFY(printedPoints(scene, Id{8}).empty());
        QVERIFY(compile(scene));
    }

    void scenesNameThePictureFromWhereTheyLie()
    {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir("deeper"));
        written(folder, "a.png", png);
        Scene scene = sheet("a.png");
        scene.folder.path = folder.path().toStdString();
        const QString file = folder.filePath("deeper/b.ripstop.json");
        QVERIFY(!saveScene(scene, file.toStdString()));
        QVERIFY(content(file).contains("\"picture\": \"../a.png\""));
    }

    // Also the one that is not there: it stops neither the flight nor the bundle.
    void bundlesHoldThePicture()
    {
        const QTemporaryDir folder;
        written(folder, "a.png", png);
        for (const bool isThere : {true, false}) {
            Scene scene = sheet(isThere ? "a.png" : "b.png");
            scene.folder.path = folder.path().toStdString();
            const QString target = folder.filePath(isThere ? "with" : "without");
            const auto done = writeBundle(scene, {.seconds = 0.01}, target.toStdString());
            QVERIFY2(!done.failure, done.failure ? done.failure->message.english().c_str() : "");
            QCOMPARE(content(target + "/files/1_a.png"), isThere ? png : QByteArray());
            const auto bundled = content(target + "/scene.ripstop.json");
            QVERIFY(bundled.contains(isThere ? "\"picture\": \"files/1_a.png\"" : "b.png\""));
        }
    }

    // The terminal says it where several materials of a mesh become one.
    void severalThatBecomeOneAreTold()
    {
        const QTemporaryDir folder;
        const QString mesh = written(folder, "two.obj",
                                     "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"
                                     "usemtl blue\nf 1 3 4\n");
        const auto said = [&](const QStringList& more) {
            return call(QStringList{"import", mesh, "-o", folder.filePath("two.ripstop.json")}
                        + more)
                .out;
        };
        QVERIFY(said({}).contains("2 materials"));
        QVERIFY(!said({"--materials", "file"}).contains("2 materials"));
    }

    // An OBJ has the colours of its fabrics, with and without a picture.
    void exportsHaveTheColours()
    {
        const QTemporaryDir folder;
        Scene scene = sheet("");
        for (Entry& entry : scene.items)
            if (auto* material = std::get_if<Material>(&entry.item))
                material->color = "#ff0000";
        const auto compiled = compile(scene);
        QVERIFY(compiled);
        const QString obj = folder.filePath("sail.obj");
        QVERIFY(
            !writeMoment(*Simulation(*compiled).frame(), MeshAppearance(scene), obj.toStdString()));
        QVERIFY(content(obj).startsWith("mtllib sail.mtl\n"));
        QVERIFY(content(obj).contains("\nusemtl sail\n"));
        const QByteArray materials = content(folder.filePath("sail.mtl"));
        QVERIFY2(materials.contains("newmtl sail\nKd 1 0 0\n"), materials);
        QVERIFY(!materials.contains("map_Kd"));
    }

    void exportsHaveThePicture()
    {
        const QTemporaryDir folder;
        const Scene scene = sheet(written(folder, "a.png", png).toStdString());
        const auto compiled = compile(scene);
        QVERIFY(compiled);
        const auto frame = Simulation(*compiled).frame();
        const MeshAppearance appearance(scene);

        const QString obj = folder.filePath("sail.obj");
        QVERIFY(!writeMoment(*frame, appearance, obj.toStdString()));
        QVERIFY(content(obj).startsWith("mtllib sail.mtl\n"));
        QVERIFY(content(obj).contains("\nusemtl sail\n"));
        QCOMPARE(content(obj).count("\nvt "), 8); // by u and v, and in the picture
        QVERIFY(content(obj).contains("\nf 1/5/1 "));
        QVERIFY(content(folder.filePath("sail.mtl")).contains("\nmap_Kd a.png\n"));

        const QString glb = folder.filePath("sail.glb");
        QVERIFY(!writeMoment(*frame, appearance, glb.toStdString()));
        const QByteArray bytes = content(glb);
        const auto length = qFromLittleEndian<quint32>(bytes.constData() + 12);
        const QJsonObject json = QJsonDocument::fromJson(bytes.mid(20, qsizetype(length))).object();
        const QJsonObject image = json["images"].toArray()[0].toObject();
        QCOMPARE(image["mimeType"].toString(), QString("image/png"));
        const QJsonObject view =
            json["bufferViews"].toArray()[image["bufferView"].toInt()].toObject();
        const qsizetype start = 20 + qsizetype(length) + 8 + view["byteOffset"].toInt();
        QCOMPARE(bytes.mid(start, view["byteLength"].toInt()), png);
        bool isUsed = false;
        for (const auto& material : json["materials"].toArray())
            isUsed |= material.toObject()["pbrMetallicRoughness"]
                          .toObject()["baseColorTexture"]
                          .isObject();
        QVERIFY(isUsed);
    }
};

const RegisteredTest registered("test_fabric_picture", runPlain<TestFabricPicture>);

} // namespace ripstop::test_fabric_picture
#include "test_fabric_picture.moc"
