// Files of meshes: formats, refusals, and the command line that brings them in.
//
// Stages: each format is read as the same mesh; units and axes; then refusals, huge, scrambled and
// missing files, none of which may crash; at the end the command line, and a flight that is
// exported and brought in again.
#include "model/cli_call.h"
#include "model/meshes.h"
#include "registered_test.h"
#include "shapes/mesh_file.h"
#include "shapes/packed_pictures.h"

#include <QJsonArray>
#include <QtTest>

#include <random>
#include <set>

namespace ripstop::test_mesh_files {
class TestMeshFiles : public QObject, MeshFolder
{
    Q_OBJECT

private slots:
    // --- files
    // --------------------------------------------------------------------------------------

    void otherFormats_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QByteArray off = "OFF\n8 6 0\n";
        QByteArray ply = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\n"
                         "property float y\nproperty float z\nelement face 6\n"
                         "property list uchar int vertex_indices\nend_header\n";
        const PolygonMesh cube = meshOf(cubeOfQuads);
        for (const Vec3& p : cube.points) {
            const QByteArray line =
                QStringLiteral("%1 %2 %3\n").arg(p.x()).arg(p.y()).arg(p.z()).toUtf8();
            off += line;
            ply += line;
        }
        for (std::size_t i = 0; i < cube.faceCount(); ++i) {
            QByteArray line = "4";
            for (const int corner : cube.face(i))
                line += " " + QByteArray::number(corner);
            off += line + "\n";
            ply += line + "\n";
        }
        QTest::newRow("OFF") << "cube.off" << off;
        QTest::newRow("PLY") << "cube.ply" << ply;
        QTest::newRow("STL") << "cube.stl" << cubeAsStl();
    }

    void otherFormats()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        const PreparedMesh mesh = preparedOf(fileOf(name, content));
        QCOMPARE(mesh.surfaces.front().mesh.points.size(), 8u);
        QCOMPARE(mesh.surfaces.front().triangles.size(), 12u);
        QCOMPARE(mesh.report.count(MeshFault::OpenEdges), 0u);
    }

    // Two quads with texture points and a colour for each vertex, a list that nobody reads, and an
    // edge; in both orders of bytes.
    void binaryPly()
    {
        for (const bool isBig : {false, true}) {
            QByteArray content = QByteArray("ply\nformat binary_") + (isBig ? "big" : "little")
                                 + "_endian 1.0\ncomment by a scanner\nelement vertex 6\n"
                                   "property double x\nproperty double y\nproperty float z\n"
                                   "property uchar red\nproperty float s\nproperty float t\n"
                                   "element face 2\nproperty list uchar float weights\n"
                                   "property list uint8 int32 vertex_index\n"
                                   "element edge 1\nproperty short vertex1\nproperty short "
                                   "vertex2\nend_header\n";
            const auto add = [&](auto value) {
                QByteArray bytes(reinterpret_cast<const char*>(&value), sizeof value);
                if (isBig)
                    std::reverse(bytes.begin(), bytes.end());
                content += bytes;
            };
            for (int i = 0; i < 6; ++i) {
                add(double(i % 3));
                add(double(i / 3));
                add(-0.5f);
                add(quint8(200));
                add(0.5f * float(i % 3));
                add(float(i / 3));
            }
            for (const std::array<int, 4> corners : {std::array{0, 1, 4, 3}, {1, 2, 5, 4}}) {
                add(quint8(1));
                add(9.0f);
                add(quint8(4));
                for (const int corner : corners)
                    add(qint32(corner));
            }
            add(qint16(0));
            add(qint16(5));
            const PreparedMesh mesh = preparedOf(fileOf("binary.ply", content));
            const RepairedMesh& surface = mesh.surfaces.front();
            QCOMPARE(surface.mesh.faceCount(), 2u);
            QVERIFY((surface.mesh.points[5] - Vec3(2.0, 1.0, -0.5)).norm() < 1e-12);
            QCOMPARE(surface.texture[5], (PolygonMesh::TexturePoint{1.0, 1.0}));
            QCOMPARE(mesh.report.count(MeshFault::StrayElements), 1u);
        }
    }

    void offWithCommentsAndColours()
    {
        const PreparedMesh mesh = preparedOf(
            fileOf("colours.off", "COFF # colours\n\n4 1 0\n# points\n0 0 0 255 0 0 255\n"
                                  "1 0 0 255 0 0 255\n1 1 0 255 0 0 255\n0 1 0 255 0 0 255\n"
                                  "4 0 1 2 3 0.5 0.5 0.5\n"));
        QCOMPARE(mesh.surfaces.front().mesh.points.size(), 4u);
        QCOMPARE(mesh.surfaces.front().triangles.size(), 2u);
    }

    // A file that says centimetres and z up: the sail is 2 m high whatever the options say.
    void colladaSaysItsUnit()
    {
        const QByteArray text =
            "<?xml version=\"1.0\"?>"
            "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
            "<asset><unit name=\"centimeter\" meter=\"0.01\"/><up_axis>Z_UP</up_axis></asset>"
            "<library_geometries><geometry id=\"g\" name=\"sail\"><mesh>"
            "<source id=\"p\"><float_array id=\"a\" count=\"9\">0 0 0 100 0 0 0 0 200</float_array>"
            "<technique_common><accessor source=\"#a\" count=\"3\" stride=\"3\"><param name=\"X\" "
            "type=\"float\"/>"
            "<param name=\"Y\" type=\"float\"/><param name=\"Z\" "
            "type=\"float\"/></accessor></technique_common></source>"
            "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
            "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 "
            "2</p></triangles>"
            "</mesh></geometry></library_geometries>"
            "<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\" "
            "name=\"sail\"><instance_geometry url=\"#g\"/>"
            "</node></visual_scene></library_visual_scenes>"
            "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
        MeshShape shape;
        shape.scale = 1e-3;
        shape.up = UpAxis::X;
        const PreparedMesh mesh = preparedOf(fileOf("sail.dae", text), shape);
        QVERIFY((mesh.size - Vec3(1.0, 2.0, 0.0)).norm() < 1e-6);
    }

    // Pictures of materials are found from the mesh's folder; one that is not there is told.
    void pictures()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("art"));
        const std::string picture = write("art/my sail.png", "not looked at").toStdString();
        const std::string other = write("art/two sails.png", "").toStdString();
        write("flag.mtl", "newmtl a\nKd 1 0 0\nmap_Kd art/my sail.png\n"
                          "newmtl b\nmap_Kd -s 2 2 -clamp on .\\art\\two sails.png\n"
                          "newmtl c\nmap_Kd no.png\n");
        const PolygonMesh flag =
            fileOf("flag.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                               "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 3/3 2/2 1/1\n"
                               "usemtl c\nf 1/1 3/3 2/2\n");
        QCOMPARE(flag.materials[0].color, std::string("#ff0000"));
        QCOMPARE(flag.materials[0].picture, picture);
        QCOMPARE(flag.materials[1].picture, other);
        QCOMPARE(flag.materials[2].picture, std::string());
        QCOMPARE(flag.missingFiles, std::vector<std::string>{"no.png"});
        QCOMPARE(preparedOf(flag).report.findings().at(0).name, "no.png");

        const PolygonMesh sail = fileOf("sail.gltf", texturedTriangle("art/my%20sail.png"));
        QCOMPARE(sail.materials.front().picture, picture);
        QCOMPARE(sail.texture.front()[1], 1.0); // glTF counts from the top, here it is from below
    }

    // A triangle and a line from its corner to a point below, as a primitive of lines.
    void linesOfGltf()
    {
        QByteArray numbers;
        for (const float number : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, // the triangle
                                   1.f, 0.f, 0.f, 1.f, -2.f, 0.f})              // the line
            numbers.append(reinterpret_cast<const char*>(&number), sizeof number);
        const QByteArray text =
            "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
            "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":["
            "{\"attributes\":{\"POSITION\":0}},{\"attributes\":{\"POSITION\":1},\"mode\":1}]}],"
            "\"buffers\":[{\"byteLength\":60,\"uri\":\"data:application/octet-stream;base64,"
            + numbers.toBase64()
            + "\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":60}],\"accessors\":["
              "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
              "\"min\":[0,0,0],\"max\":[1,1,0]},{\"bufferView\":0,\"byteOffset\":36,"
              "\"componentType\":5126,\"count\":2,\"type\":\"VEC3\",\"min\":[1,-2,0],"
              "\"max\":[1,0,0]}]}";
        const PolygonMesh read = fileOf("line.gltf", text);
        QCOMPARE(read.lines.size(), 1u);
        QCOMPARE(read.strayElements, 0u);
        const RepairedMesh surface = preparedOf(read).surfaces.front();
        QCOMPARE(surface.mesh.points.size(), 4u); // one end is the corner
        QCOMPARE(surface.mesh.lines.size(), 1u);
    }

    // The file of materials that the mesh names, in its folder or below, whatever it is called;
    // with blanks in its name or several on a line. Where none is there, that of the mesh's own
    // name, and never one elsewhere. What nobody finds is told.
    void materialsAreInTheFileThatIsNamed()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("sails/my colours"));
        write("sails/my colours/red one.mtl", "newmtl a\nKd 1 0 0\n");
        write("sails/green.mtl", "newmtl a\nKd 0 1 0\n");
        write("sails/own.mtl", "newmtl a\nKd 0 0 1\n");
        write("outside.mtl", "newmtl a\nKd 1 1 1\n");
        const QByteArray triangle = "\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        const auto colorOf = [&](const QByteArray& named) {
            return fileOf("sails/own.obj", named + triangle).materials.front().color;
        };
        QCOMPARE(colorOf("mtllib my colours/red one.mtl\n"), std::string("#ff0000"));
        QCOMPARE(colorOf("mtllib green.mtl none.mtl\n"), std::string("#00ff00"));
        QCOMPARE(colorOf("mtllib none.mtl\n"), std::string("#0000ff"));
        QCOMPARE(colorOf("mtllib ../outside.mtl\n"), std::string("#0000ff"));
        QCOMPARE(colorOf("mtllib my colours/../../outside.mtl\n"), std::string("#0000ff"));
        QCOMPARE(colorOf("mtllib " + m_folder.filePath("outside.mtl").toUtf8() + "\n"),
                 std::string("#0000ff"));
        QCOMPARE(colorOf(""), std::string("#0000ff"));
        const auto missing = [&](const QByteArray& named) {
            return fileOf("sails/lone.obj", "mtllib " + named + triangle).missingFiles;
        };
        QCOMPARE(missing("green.mtl none.mtl").at(0), "none.mtl");
        QCOMPARE(missing("red one.mtl").at(0), "red one.mtl");
    }

    void refusals_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("says");
        QTest::newRow("empty") << "empty.obj" << QByteArray() << "is empty";
        QTest::newRow("no faces") << "points.obj" << QByteArray("v 0 0 0\n") << "no faces";
        QTest::newRow("no such format") << "mesh.docx" << QByteArray("x") << "no known format";
        QTest::newRow("cut off in a vertex")
            << "cut.obj" << QByteArray("v 0 0 0\nv 1 0") << "line 2: a vertex needs three numbers";
        QTest::newRow("cut off before its vertices")
            << "short.obj" << QByteArray("v 0 0 0\nv 1 0 0\nf 1 2 3\n")
            << "line 3: a face names vertex 3 of 2. Vertices count from 1";
        QTest::newRow("cut off in a face")
            << "face.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2")
            << "line 4: a face needs three corners. The file may be cut off";
        QTest::newRow("not a number")
            << "nan.obj" << QByteArray("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n") << "line 2";
        QTest::newRow("infinite") << "inf.obj" << QByteArray("v 0 0 0\nv inf 0 0\nf 1 2 1\n")
                                  << "not finite";
        QTest::newRow("a word for a corner")
            << "word.obj" << QByteArray("v 0 0 0\nf 1 a 1\n") << "\"a\" is not a corner";
        QTest::newRow("a line to a vertex that is not there")
            << "line.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 3 4\n")
            << "line 5: a line names vertex 4 of 3";
        QTest::newRow("a word for an end")
            << "end.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 b\n")
            << "line 5: \"b\" is not an end of a line";
        QTest::newRow("STL, cut off behind a triangle")
            << "half.stl" << cubeAsStl().left(cubeAsStl().indexOf("endfacet") + 9)
            << "in the middle of a solid";
        QTest::newRow("nonsense") << "bad.ply" << QByteArray("plyff nonsense") << "cannot be read";
        const QByteArray ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                               "property float y\nproperty float z\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n";
        QTest::newRow("PLY, cut off in its vertices") << "points.ply" << ply + "0 0 0\n1 0"
                                                      << "vertex 2 of 3 is not there";
        QTest::newRow("PLY, cut off in its faces")
            << "faces.ply" << ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1"
            << "face 1 of 1 is not there";
        QTest::newRow("PLY, a vertex too high")
            << "high.ply" << ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"
            << "face 1 names vertex 7";
        QTest::newRow("OFF, cut off") << "cut.off" << QByteArray("OFF\n3 1 0\n0 0 0\n1 0 0\n")
                                      << "vertex 3 of 3 needs three numbers";
        QTest::newRow("OFF, a vertex too high")
            << "high.off" << QByteArray("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n")
            << "line 6: face 1 of 1";
        QTest::newRow("binary STL, cut off")
            << "cut.stl" << QByteArray(80, 'x') + QByteArray("\x09\x00\x00\x00", 4) + "abc"
            << "cannot be read";
    }

    void refusals()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QString, says);
        const Result<PolygonMesh> refused =
            readPolygonFile(write("refused_" + name, content).toStdString());
        QVERIFY(!refused);
        const QString message = QString::fromStdString(refused.message().english());
        QVERIFY2(message.contains(says), qPrintable(message));
        QVERIFY2(message.contains(name), qPrintable(message));
    }

    // A file of 2 GiB, none of which is on the disk.
    void hugeFilesAreRefused()
    {
        QFile huge(m_folder.filePath("huge.stl"));
        QVERIFY(huge.open(QIODevice::WriteOnly));
        QVERIFY(huge.resize(qint64(2) << 30));
        huge.close();
        const Result<PolygonMesh> refused = readPolygonFile(huge.fileName().toStdString());
        QVERIFY(!refused);
        QVERIFY(refused.message().english().find("larger than 1 GiB") != std::string::npos);
        QVERIFY(huge.remove());
    }

    // Bytes changed, cut off or doubled: there is a mesh or a sentence, and never a crash.
    void scrambledFiles()
    {
        QByteArray binary(80, ' ');
        const quint32 count = 4;
        binary.append(reinterpret_cast<const char*>(&count), 4).append(QByteArray(200, '\x3f'));
        const std::pair<QString, QByteArray> files[]{
            {"obj", QByteArray(cubeOfQuads) + "vt 0 0\nf 1/1 2/1 3/1\nf -1 -2 -3\n"},
            {"stl", cubeAsStl()},
            {"stl", binary},
            {"off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"},
            {"ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                    "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                    "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}};
        std::mt19937 random(7);
        int read = 0;
        for (const auto& [ending, content] : files)
            for (int round = 0; round < 120; ++round) {
                QByteArray text = content;
                for (int change = 0; change < 1 + round % 4; ++change) {
                    const auto at = qsizetype(random() % unsigned(text.size()));
                    if (round % 3 == 0)
                        text[at] = char(random() % 256);
                    else if (round % 3 == 1)
                        text.truncate(std::max<qsizetype>(at, 1));
                    else
                        text.insert(at, text.mid(qsizetype(random() % unsigned(text.size())), 9));
                }
                const QString name = QStringLiteral("scrambled.") + ending;
                const Result<PolygonMesh> mesh = readPolygonFile(write(name, text).toStdString());
                if (!mesh) {
                    QVERIFY(mesh.message().english().find(name.toStdString()) != std::string::npos);
                    continue;
                }
                ++read;
                if (const Result<PreparedMesh> made = prepared(*mesh, {}))
                    QVERIFY(fabricOf(*made, plainFabric(), "sail", {}));
            }
        QVERIFY(read > 0);
    }

    void missingFilesAndFolders()
    {
        const Result<PolygonMesh> missing = readPolygonFile("no/such/mesh.obj");
        QVERIFY(!missing);
        QVERIFY(missing.message().english().find("does not exist") != std::string::npos);
        const Result<PolygonMesh> folder = readPolygonFile(m_folder.path().toStdString());
        QVERIFY(!folder);
        QVERIFY(folder.message().english().find("is a folder") != std::string::npos);
    }

    // --- the command line
    // -------------------------------------------------------------------------

    void commandLine()
    {
        const QString mesh = write("cli.stl", cubeAsStl());
        const QString scene = m_folder.filePath("cli.ripstop.json");
        const Outcome made =
            call({"import", mesh, "--unit", "cm", "--up", "z", "--json", "-o", scene});
        QCOMPARE(made.error, QString());
        QCOMPARE(made.exitCode, 0);
        const QJsonObject first = made.json()["meshes"].toArray().first().toObject();
        QCOMPARE(first["particles"].toInt(), 8);
        QCOMPARE(first["panels"].toInt(), 12);
        QCOMPARE(first["links"].toInt(), 0); // panels carry
        // 6 cm^2 of kite cloth of 47 g/m^2
        QVERIFY(std::abs(first["mass"].toDouble() - 6e-4 * 0.047) < 1e-9);
        const QJsonArray report = first["report"].toArray();
        QCOMPARE(report.first().toObject()["fault"].toString(), "odd_size"); // 1 cm
        const Outcome info = call({"info", scene, "--json"});
        QCOMPARE(info.json()["particles"].toInt(), 8);
        QCOMPARE(info.json()["panels"].toInt(), 12);

        // the mesh comes once more, into that scene, of the same material, with options as
        // key=value
        const Outcome more = call({"import", mesh, "scale=0.5", "shear=springs", "--into", scene,
                                   "--material", "fabric", "-o", scene});
        QVERIFY(more.error.contains("this mesh is another")); // than a grid, as threads want one
        QVERIFY(more.out.contains("28 vertices lie on another one: joined."));
        const QJsonObject both = call({"info", scene, "--json"}).json();
        QCOMPARE(both["particles"].toInt(), 16);
        QCOMPARE(both["parts"].toArray().size(), 2);
        // the second has threads, as links across faces were asked for: 18 edges, the other
        // diagonal of each side, and across the edges of the cube its four diagonals
        QCOMPARE(both["links"].toInt(), 18 + 6 + 4);
    }

    // The scene names a picture from where it is.
    void commandLineWithPicture()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("mesh"));
        QVERIFY(QDir(m_folder.path()).mkpath("scene"));
        write("mesh/sail.png", // one pixel
              QByteArray::fromBase64(
                  "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAC"
                  "hwGA60e6kgAAAABJRU5ErkJggg=="));
        write("mesh/sail.mtl", "newmtl a\nmap_Kd sail.png\n");
        const QString mesh =
            write("mesh/sail.obj", "usemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const QString scene = m_folder.filePath("scene/sail.ripstop.json");
        const Outcome made = call({"import", mesh, "-o", scene});
        QCOMPARE(made.error, QString());
        QFile file(scene);
        QVERIFY(file.open(QFile::ReadOnly));
        QVERIFY(file.readAll().contains("\"picture\": \"../mesh/sail.png\""));
    }

    // A picture within a .gltf or .glb is written beside it, once, and what is there is not
    // touched.
    void packedPictures()
    {
        QVERIFY(QDir(m_folder.path()).mkpath("packed"));
        const QString mesh = write("packed/kite.gltf", trianglePackedWith(redPoint()));
        const QString scene = m_folder.filePath("packed/kite.ripstop.json");
        const QString picture = m_folder.filePath("packed/kite-1.png");
        const auto import = [&] { return call({"import", mesh, "-o", scene}); };
        const auto content = [](const QString& name) {
            QFile file(name);
            return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
        };
        for (int time = 0; time < 2; ++time) {
            QCOMPARE(import().error, QString());
            QCOMPARE(content(picture), redPoint());
            QVERIFY(content(scene).contains("\"picture\": \"kite-1.png\""));
            QVERIFY(!QFile::exists(m_folder.filePath("packed/kite-1-2.png")));
        }
        write("packed/kite-1.png", "another's");
        QCOMPARE(import().error, QString());
        QCOMPARE(content(picture), QByteArray("another's"));
        QCOMPARE(content(m_folder.filePath("packed/kite-1-2.png")), redPoint());
        QVERIFY(content(scene).contains("\"picture\": \"kite-1-2.png\""));

        const QString odd = write("packed/odd.gltf", trianglePackedWith("no picture"));
        QCOMPARE(call({"import", odd, "-o", scene}).error, QString());
        QVERIFY(!content(scene).contains("\"picture\""));
    }

    void packedPicturesOfOneName()
    {
        const std::string point = redPoint().toStdString();
        std::vector<PolygonMesh::PackedPicture> pictures(2000);
        for (PolygonMesh::PackedPicture& picture : pictures) {
            picture.name = "sail";
            picture.bytes = point;
        }
        nameFilesBeside(m_folder.filePath("kite.glb").toStdString(), pictures);
        std::set<std::string> names;
        for (const PolygonMesh::PackedPicture& picture : pictures)
            names.insert(picture.file);
        QCOMPARE(names.size(), pictures.size());
        QCOMPARE(pictures.front().file, m_folder.filePath("kite-sail.png").toStdString());
        QCOMPARE(pictures[1].file, m_folder.filePath("kite-sail-2.png").toStdString());
    }

    void commandLineRefuses()
    {
        const QString out = m_folder.filePath("refused.ripstop.json");
        const QString mesh = write("good.stl", cubeAsStl());
        const Outcome missing = call({"import", "nowhere.obj", "-o", out});
        QCOMPARE(missing.exitCode, 1);
        QVERIFY(missing.error.contains("nowhere.obj"));
        QVERIFY(!QFile::exists(out));
        QCOMPARE(call({"import", mesh, "--up", "w", "-o", out}).exitCode, 2);
        QCOMPARE(call({"import", mesh, "size=large", "-o", out}).exitCode, 2);
        QCOMPARE(call({"import", mesh, "wight=1", "-o", out}).exitCode, 2);
        QCOMPARE(call({"import", mesh, "--preset", "liros_ltc80", "-o", out}).exitCode, 2);
        QCOMPARE(call({"import", "-o", out}).exitCode, 2);
        QVERIFY(!QFile::exists(out));
    }

    // What flies can be brought in again: same vertices, faces and texture.
    void thereAndBack()
    {
        const QString mesh = write("sheet.obj", QByteArray::fromStdString(sheet(5, 0.2, false)));
        const QString scene = m_folder.filePath("sheet.ripstop.json");
        const QString exported = m_folder.filePath("exported.obj");
        QCOMPARE(call({"import", mesh, "-o", scene}).exitCode, 0);
        QCOMPARE(call({"export", scene, "-o", exported}).exitCode, 0);
        const PreparedMesh before = preparedOf(*readPolygonFile(mesh.toStdString()));
        const PreparedMesh after = preparedOf(*readPolygonFile(exported.toStdString()));
        const RepairedMesh& a = before.surfaces.front();
        const RepairedMesh& b = after.surfaces.front();
        QCOMPARE(b.mesh.points.size(), 36u);
        for (std::size_t i = 0; i < 36; ++i)
            QVERIFY((a.mesh.points[i] - b.mesh.points[i]).norm() < 1e-12);
        QCOMPARE(b.triangles, a.triangles);
        QCOMPARE(b.texture, a.texture);
    }
};

const RegisteredTest registered("test_mesh_files", runWithCore<TestMeshFiles>);

} // namespace ripstop::test_mesh_files
#include "test_mesh_files.moc"
