// Exported flights opened by the programs that they are for: Blender and ParaView, without a
// window. Where one of them is not installed, its test says so and does not run.
//
// Stages: five flights, two of which tear, are exported, and their starts as single meshes; the
// program runs a script that reads the files and compares each frame with the places that the test
// has written beside them; the test reads the largest distance from what the script prints.
#include "export/export_run.h"
#include "export/surface.h"
#include "model/sample_scenes.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_elsewhere {

namespace {

constexpr double fps = 24.0; // each of these frames is a whole number of steps of the samples
constexpr double rounding =
    2e-5; // m, single precision some metres from the origin, turned by Blender

struct Flight
{
    const char* scene;
    double seconds;
    bool isSplit; // or what tears goes from the mesh
};

constexpr std::array flights{Flight{"delta_kite", 10.0, false}, Flight{"ripstop_kite", 4.0, false},
                             Flight{"nylon_parachute", 2.0, false},
                             Flight{"torn_sheet", 2.0, false}, Flight{"split_sheet", 2.0, true}};

QJsonArray placesOf(const Frame& frame)
{
    QJsonArray places;
    for (const Vec3& x : frame.position)
        places.append(QJsonArray{x.x(), x.y(), x.z()});
    return places;
}

enum class Lines { Taken, Left };

// Corners of panels that still stand, and ends of lines.
QJsonArray standingPlacesOf(const Surface& surface, Lines lines = Lines::Taken)
{
    std::vector<char> used(surface.position.size(), 0);
    for (const auto& panel : surface.panels)
        for (const int corner : panel)
            used[std::size_t(corner)] = 1;
    if (lines == Lines::Taken)
        for (const auto& line : surface.lines)
            for (const int end : line)
                used[std::size_t(end)] = 1;
    QJsonArray places;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) {
            const Vec3& x = surface.position[i];
            places.append(QJsonArray{x.x(), x.y(), x.z()});
        }
    return places;
}

struct Expected
{
    QJsonArray times;
    QJsonArray all;      // [frames][particles]
    QJsonArray standing; // [frames][vertices]
};

Expected fly(const Flight& flight)
{
    const MeshAppearance appearance(sample(flight.scene));
    Simulation simulation = started(flight.scene);
    Expected expected;
    const std::size_t count = frameCount({0.0, flight.seconds, fps});
    for (std::size_t i = 0; i < count; ++i) {
        simulation.runUntil(double(i) / fps);
        const auto frame = simulation.frame();
        expected.times.append(frame->time);
        expected.all.append(placesOf(*frame));
        expected.standing.append(standingPlacesOf(surfaceOf(*frame, appearance)));
    }
    return expected;
}

bool write(const QString& path, const QJsonObject& object)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(object).toJson()) > 0;
}

std::optional<Failure> exported(const Flight& flight, const QString& target)
{
    Simulation simulation = started(flight.scene);
    FlownFrames flown(simulation);
    return exportRun(flown, MeshAppearance(sample(flight.scene)), {0.0, flight.seconds, fps},
                     target.toStdString());
}

// What the program printed, and its largest "frame N: DISTANCE".
struct Reading
{
    QByteArray text;
    double largest = 0.0; // m
    int count = 0;
};

Reading read(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    process.waitForFinished(-1);
    Reading reading{process.readAll()};
    static const QRegularExpression gap("frame \\d+: ([-+.e\\d]+)");
    for (auto found = gap.globalMatch(reading.text); found.hasNext();) {
        reading.largest = std::max(reading.largest, found.next().captured(1).toDouble());
        ++reading.count;
    }
    return reading;
}

// The program that an environment variable names, else the one that is installed.
QString programFor(const char* variable, const QString& name)
{
    const QString named = qEnvironmentVariable(variable);
    return named.isEmpty() ? QStandardPaths::findExecutable(name) : named;
}

void addFlights()
{
    QTest::addColumn<int>("number");
    for (std::size_t i = 0; i < flights.size(); ++i)
        QTest::newRow(flights[i].scene) << int(i);
}

} // namespace

class TestElsewhere : public QObject
{
    Q_OBJECT

private slots:
    void blender_data() { addFlights(); }

    void blender()
    {
        const QString program = programFor("RIPSTOP_BLENDER", "blender");
        if (program.isEmpty())
            QSKIP(
                "Blender is not installed; \"apt install blender\" or name it by RIPSTOP_BLENDER");
        QFETCH(int, number);
        const Flight& flight = flights[std::size_t(number)];
        QTemporaryDir folder;
        for (const char* name : {"a.glb", "b.pc2", "c.mdd"}) {
            const auto failure = exported(flight, folder.filePath(name));
            QVERIFY2(!failure, failure ? failure->message.english().c_str() : "");
        }
        const Simulation simulation = started(flight.scene);
        const Frame start = *simulation.frame();
        const MeshAppearance appearance(sample(flight.scene));
        for (const char* name : {"moment.obj", "moment.ply", "moment.stl", "moment.dae"})
            QVERIFY(!writeMoment(start, appearance, folder.filePath(name).toStdString()));
        QVERIFY(write(folder.filePath("expected.json"),
                      {{"fps", fps},
                       {"frames", fly(flight).standing},
                       {"corners", standingPlacesOf(surfaceOf(start, appearance), Lines::Left)}}));
        const Reading reading =
            read(program, {"--background", "--factory-startup", "--python",
                           SOURCE_DIR "/tests/elsewhere/blender_reads.py", "--", folder.path()});
        QVERIFY2(reading.text.contains("all read"), reading.text.constData());
        QCOMPARE(reading.count, 3 * 4 + 4);
        QVERIFY2(reading.largest < rounding, reading.text.constData());
    }

    void paraview_data() { addFlights(); }

    void paraview()
    {
        const QString program = programFor("RIPSTOP_PVBATCH", "pvbatch");
        if (program.isEmpty())
            QSKIP("ParaView is not installed (Debian's cannot be beside libvtk9-dev); name its "
                  "pvbatch by RIPSTOP_PVBATCH");
        QFETCH(int, number);
        const Flight& flight = flights[std::size_t(number)];
        QTemporaryDir folder;
        const auto failure = exported(flight, folder.filePath("series.pvd"));
        QVERIFY2(!failure, failure ? failure->message.english().c_str() : "");
        const Expected expected = fly(flight);
        QVERIFY(write(folder.filePath("expected.json"),
                      {{"times", expected.times}, {"frames", expected.all}}));
        const Reading reading =
            read(program, {SOURCE_DIR "/tests/elsewhere/paraview_reads.py", folder.path()});
        QVERIFY2(reading.text.contains("all read"), reading.text.constData());
        QCOMPARE(reading.count, 4);
        QCOMPARE(reading.largest, 0.0); // all bits are there
        for (const char* array : {"velocity (m/s)", "strain (1)", "tension (N)", "panel load (N)"})
            QVERIFY2(reading.text.contains(QByteArray("array ") + array), array);
    }
};

const RegisteredTest registered("test_elsewhere", runPlain<TestElsewhere>);

} // namespace ripstop::test_elsewhere
#include "test_elsewhere.moc"
