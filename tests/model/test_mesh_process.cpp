// Meshes that assimp reads, in a process of its own: files that crash the library or ask for all
// memory are one sentence, buffers that a file names are read, and cancelling ends the process.
//
// Stages: broken files, small ones, each of which ended the whole program or took gigabytes when
// the library was called in it; sound files; how the process is found, ended and answered.
#include "model/cli_call.h"
#include "model/meshes.h"
#include "registered_test.h"
#include "shapes/mesh_answer.h"
#include "shapes/mesh_process.h"

#include <QtTest>

#include <cerrno>
#include <cstring>
#include <set>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ripstop::test_mesh_process {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isWatched = true;
#else
constexpr bool isWatched = false;
#endif

// One triangle with corners at 0 0 0, 1 0 0 and 0 0 2 m.
const QByteArray collada =
    "<?xml version=\"1.0\"?>"
    "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
    "<asset><unit name=\"meter\" meter=\"1\"/><up_axis>Y_UP</up_axis></asset>"
    "<library_geometries><geometry id=\"g\" name=\"sail\"><mesh><source id=\"p\">"
    "<float_array id=\"a\" count=\"9\">0 0 0 1 0 0 0 0 2</float_array><technique_common>"
    "<accessor source=\"#a\" count=\"3\" stride=\"3\"><param name=\"X\" type=\"float\"/>"
    "<param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
    "</technique_common></source>"
    "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
    "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
    "<p>0 1 2</p></triangles></mesh></geometry></library_geometries>"
    "<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\" name=\"sail\">"
    "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
    "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";

QByteArray changed(QByteArray text, const char* from, const char* to)
{
    Q_ASSERT(text.contains(from));
    return text.replace(from, to);
}

// JSON is easier to read with single quotes.
QByteArray json(QByteArray text) { return text.replace('\'', '"'); }

// The same triangle, whose points are in another file.
QByteArray gltf(const QByteArray& buffer, const QByteArray& more = {})
{
    return json(
        "{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],"
        "'meshes':[{'primitives':[{'attributes':{'POSITION':0},'targets':[{'POSITION':0}]}]}],"
        "'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'},"
        "{'bufferView':0,'componentType':5126,'count':0,'type':'SCALAR'},"
        "{'bufferView':0,'componentType':5126,'count':3,'type':'SCALAR'}],"
        "'bufferViews':[{'buffer':0,'byteLength':36}],'buffers':[{'byteLength':36,'uri':'"
        + buffer + "'}]" + more + "}");
}

QByteArray trianglePoints()
{
    constexpr std::array<float, 9> points{0, 0, 0, 1, 0, 0, 0, 0, 2};
    return {reinterpret_cast<const char*>(points.data()), qsizetype(sizeof points)};
}

// 79 bytes that claim to be 4 GB.
QByteArray shortGlb()
{
    const quint32 claimed = 4000000000u;
    QByteArray bytes("glTF\x02\0\0\0", 8);
    bytes.append(reinterpret_cast<const char*>(&claimed), 4);
    bytes.append(reinterpret_cast<const char*>(&claimed), 4);
    bytes += "JSON" + json("{'asset':{'version':'2.0'}}");
    return bytes.leftJustified(79, ' ');
}

PolygonMesh triangle()
{
    PolygonMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 2}};
    mesh.corners = {0, 1, 2};
    mesh.objects = {"sail"};
    mesh.materials = {{"cloth", "#ff0000"}};
    mesh.endFace(0, 0);
    return mesh;
}

} // namespace

class TestMeshProcess : public QObject, MeshFolder
{
    Q_OBJECT

private slots:
    void brokenFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("says");
        const QString crashed = "the library that reads its format crashed";
        const QString memory = isWatched ? "is damaged" : "asks for more memory";
        QTest::newRow("a misspelt count: SIGSEGV")
            << "misspelt.dae" << changed(collada, "count=\"9\"", "coumt=\"9\"") << crashed;
        QTest::newRow("an accessor of count 0: SIGFPE")
            << "zero.gltf"
            << gltf("points.bin",
                    ",'animations':[{'samplers':[{'input':1,'output':2}],"
                    "'channels':[{'sampler':0,'target':{'node':0,'path':'weights'}}]}]")
            << crashed;
        QTest::newRow("an index of 1e308: 6 GB")
            << "large.dae" << changed(collada, "<p>0 1 2", "<p>0 1 1e308") << memory;
        QTest::newRow("79 bytes that claim 4 GB") << "short.glb" << shortGlb() << memory;
        QTest::newRow("a device for a buffer")
            << "device.gltf" << gltf("/dev/zero") << "cannot be read";
    }

    void brokenFiles()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(QString, says);
        write("points.bin", trianglePoints());
        const QString file = write(name, content);
        const Result<PolygonMesh> refused = readPolygonFile(file.toStdString());
        QVERIFY(!refused);
        const QString message = QString::fromStdString(refused.message().english());
        QVERIFY2(message.contains(says), qPrintable(message));
        QVERIFY2(message.contains(name), qPrintable(message));

        // As a collider the mesh is a problem of the scene, and the program lives.
        const QString scene =
            write("scene.ripstop.json",
                  json("{'format':'ripstop-scene','version':1,'items':[{'id':1,'type':'collider',"
                       "'name':'rock','shape':'mesh','file':'"
                       + name.toUtf8() + "'}]}"));
        const Outcome info = call({"info", scene});
        QVERIFY2(info.exitCode == 0 || info.exitCode == 1, qPrintable(info.error));
        QVERIFY2((info.out + info.error.toUtf8()).contains(says.toUtf8()),
                 info.out + qPrintable(info.error));
    }

    void soundFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("Collada") << "sail.dae" << collada;
        QTest::newRow("glTF with a buffer beside it") << "sail.gltf" << gltf("points.bin");
    }

    void soundFiles()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        write("points.bin", trianglePoints());
        const Result<PolygonMesh> mesh = readPolygonFile(write(name, content).toStdString());
        QVERIFY2(mesh, mesh ? "" : mesh.message().english().c_str());
        QCOMPARE(mesh->points, triangle().points);
        QCOMPARE(mesh->corners, triangle().corners);
        QCOMPARE(mesh->unit, 1.0);
        QVERIFY(mesh->isUpright);
    }

    // A program that was copied without the reader says so, and reads what needs none.
    void withoutTheReader()
    {
        const QString folder = m_folder.filePath("alone");
        QVERIFY(QDir().mkpath(folder));
        const QString program = folder + "/ripstop-cli";
        QVERIFY(QFile::copy(CLI_PROGRAM, program));
        const auto importOf = [&](const QString& mesh) {
            QProcess process;
            process.start(program, {"import", mesh, "-o", folder + "/made.ripstop.json"});
            return process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit
                       ? QString::number(process.exitCode()) + process.readAllStandardError()
                       : QStringLiteral("crashed");
        };
        const QString said = importOf(write("cube.stl", cubeAsStl()));
        QVERIFY2(said.startsWith("1") && said.contains("ripstop-mesh-reader"), qPrintable(said));
        QVERIFY2(said.contains("save the mesh as OBJ"), qPrintable(said));
        QCOMPARE(importOf(write("cube.obj", cubeOfQuads)), QString("0"));
    }

    // What the manual says of the processor: 60 s and 2 s for each MiB, here of 19.07 MiB.
    void timeIsLimited()
    {
        const quint32 count = 400000;
        QByteArray mesh(84 + qsizetype(count) * 50, '\0');
        std::memcpy(mesh.data() + 80, &count, sizeof count);
        const QString file = write("long.stl", mesh);
        std::set<long> seen; // s
        const auto look = [&](double) {
            QFile children(QString("/proc/self/task/%1/children").arg(::getpid()));
            if (children.open(QIODevice::ReadOnly)) {
                rlimit limit{};
                const pid_t child = pid_t(children.readAll().trimmed().toInt());
                if (child > 0 && ::prlimit(child, RLIMIT_CPU, nullptr, &limit) == 0
                    && limit.rlim_cur != RLIM_INFINITY)
                    seen.insert(long(limit.rlim_cur));
            }
            return true;
        };
        (void)readPolygonFile(file.toStdString(), look);
        QVERIFY(seen.contains(98)); // 60 + 38
        seen.erase(98);
        seen.erase(60); // before it knew the size
        QVERIFY(seen.empty());
    }

    // However a reader ends, it is a sentence. These work until their second of the processor is
    // over, or are ended as by the clock and by a crash.
    void endsOfTheReader_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QString>("says");
        QTest::newRow("processor") << QByteArray("ulimit -S -t 1; while :; do :; done")
                                   << "takes longer to read than a file of its size may";
        QTest::newRow("clock") << QByteArray("kill -s ALRM $$")
                               << "takes longer to read than a file of its size may";
        QTest::newRow("crash") << QByteArray("kill -s SEGV $$") << "crashed on it";
        QTest::newRow("killed") << QByteArray("kill -s KILL $$") << "crashed on it";
    }

    void endsOfTheReader()
    {
        QFETCH(QByteArray, script);
        QFETCH(QString, says);
        QVERIFY(QDir().mkpath(m_folder.filePath("ends")));
        const QString program = m_folder.filePath("ends/ripstop-cli");
        QVERIFY(QFile::exists(program) || QFile::copy(CLI_PROGRAM, program));
        const QString reader = write("ends/ripstop-mesh-reader", "#!/bin/sh\n" + script + "\n");
        QVERIFY(
            QFile(reader).setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner));
        QProcess process;
        process.start(program, {"import", write("cube.stl", cubeAsStl()), "-o",
                                m_folder.filePath("ends.ripstop.json")});
        QVERIFY(process.waitForFinished(60000));
        const QString said = process.readAllStandardError();
        QCOMPARE(process.exitCode(), 1);
        QVERIFY2(said.contains(says) && said.count('\n') == 1, qPrintable(said));
    }

    // The process is gone, and waited for, when the call returns.
    void cancelling()
    {
        const QString file = write("cube.stl", cubeAsStl());
        int asked = 0;
        const Result<PolygonMesh> cancelled =
            readPolygonFile(file.toStdString(), [&](double) { return ++asked < 1; });
        QVERIFY(!cancelled);
        QCOMPARE(cancelled.message().english(), std::string("The import was cancelled."));
        QCOMPARE(::waitpid(-1, nullptr, WNOHANG), pid_t(-1));
        QCOMPARE(errno, ECHILD);
    }

    // --- answers -------------------------------------------------------------------------------

    void answersComeInPieces()
    {
        PolygonMesh sent = triangle();
        sent.unit = 0.001;
        sent.texture = {{0, 0}, {1, 0}, {0, 1}};
        sent.strayElements = 7;
        const std::string bytes = progressRecord(0.25) + meshRecord(sent);
        MeshAnswer answer;
        for (const char byte : bytes)
            QVERIFY(answer.take({&byte, 1}));
        QCOMPARE(answer.share(), 0.25);
        QVERIFY(answer.mesh());
        QCOMPARE(answer.mesh()->points, sent.points);
        QCOMPARE(answer.mesh()->texture, sent.texture);
        QCOMPARE(answer.mesh()->unit, sent.unit);
        QCOMPARE(answer.mesh()->strayElements, 7u);
        QCOMPARE(answer.mesh()->materials[0].color, std::string("#ff0000"));
    }

    // A reader that has gone mad: no count or index of its answer is believed.
    void answersAreNotBelieved()
    {
        const auto isTaken = [](const std::string& bytes) {
            MeshAnswer answer;
            return answer.take(bytes) && answer.isOver();
        };
        QVERIFY(isTaken(meshRecord(triangle())));
        for (const int corner : {-1, 3, 2147483647}) {
            PolygonMesh mesh = triangle();
            mesh.corners[1] = corner;
            QVERIFY(!isTaken(meshRecord(mesh)));
        }
        PolygonMesh mesh = triangle();
        mesh.first = {0, 4};
        QVERIFY(!isTaken(meshRecord(mesh)));
        mesh = triangle();
        mesh.material = {1};
        QVERIFY(!isTaken(meshRecord(mesh)));

        std::string bytes = meshRecord(triangle());
        const std::uint64_t many = std::uint64_t(1) << 40;
        for (const std::size_t place :
             {std::size_t(1), std::size_t(9)}) { // of the record, of points
            std::string forged = bytes;
            std::memcpy(forged.data() + place, &many, sizeof many);
            MeshAnswer answer;
            QVERIFY(!answer.take(forged));
        }
    }
};

const RegisteredTest registered("test_mesh_process", runWithCore<TestMeshProcess>);

} // namespace ripstop::test_mesh_process
#include "test_mesh_process.moc"
