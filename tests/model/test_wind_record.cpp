// Winds that were measured: how tables of them are read, and how they blow.
#include "check/check.h"
#include "compile/compile.h"
#include "forces/wind.h"
#include "io/scene_file.h"
#include "io/wind_record.h"
#include "model/cli_call.h"
#include "registered_test.h"
#include "scene/wind.h"
#include "simulation/simulation.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_wind_record {

namespace {

Scene blownBy(NumberRows velocities)
{
    Scene scene;
    Wind wind{"measured", Vec3::Zero(), WindKind::Measured};
    wind.velocities = std::move(velocities);
    Part part;
    part.particles = {{.id = Id{1}, .mass = 1.0}};
    scene.items = {{Id{2}, part}, {Id{3}, wind}};
    scene.nextId = Id{4};
    return scene;
}

bool warnsOf(std::string_view sort, const Scene& scene)
{
    return std::ranges::any_of(problemsOf(scene),
                               [&](const Finding& one) { return one.sort == sort; });
}

Vec3 windAtTime(const System& system, double time)
{
    State state = system.start;
    state.time = time;
    return commonWind(system, state);
}

void compareRows(const NumberRows& got, const NumberRows& expected)
{
    QCOMPARE(got.size(), expected.size());
    for (std::size_t i = 0; i < got.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k)
            QVERIFY2(std::abs(got[i][k] - expected[i][k]) < 1e-12,
                     qPrintable(QString("row %1, column %2: %3 for %4")
                                    .arg(i)
                                    .arg(k)
                                    .arg(got[i][k])
                                    .arg(expected[i][k])));
}

} // namespace

class TestWindRecord : public QObject
{
    Q_OBJECT

private slots:
    void tables_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<NumberRows>("rows");
        const NumberRows level = {{0.0, 5.0, 0.0, 0.0}, {1.0, 7.5, 0.0, 0.0}};
        QTest::newRow("time and speed") << QByteArray("0,5\n1,7.5\n") << level;
        QTest::newRow("a header") << QByteArray(
            "# logger 3\nWind speed (m/s),Time (s)\n5,0\n7.5,1\n")
                                  << level;
        QTest::newRow("km/h and minutes")
            << QByteArray("time [min]\tspeed [km/h]\n0\t18\n1\t27\n")
            << NumberRows{{0.0, 5.0, 0.0, 0.0}, {60.0, 7.5, 0.0, 0.0}};
        QTest::newRow("decimal commas") << QByteArray("time;speed\n0;5,0\n1;7,5\n") << level;
        QTest::newRow("a gap") << QByteArray("time,speed\n0,5\n0.5,\n1,7.5\n") << level;
        // From the north, then from the east: the mean is from the north-east, so that the first
        // comes 45 degrees to the left of x and the second as much to the right.
        const double part = 4.0 * std::sqrt(0.5);
        QTest::newRow("direction") << QByteArray("t,speed,direction\n0,4,0\n2,4,90\n")
                                   << NumberRows{{0.0, part, 0.0, -part}, {2.0, part, 0.0, part}};
        QTest::newRow("through north")
            << QByteArray("t,speed,direction\n0,4,315\n2,4,45\n")
            << NumberRows{{0.0, part, 0.0, -part}, {2.0, part, 0.0, part}};
        QTest::newRow("four columns") << QByteArray("0,1,2,3\n1,4,5,6\n")
                                      << NumberRows{{0.0, 1.0, 2.0, 3.0}, {1.0, 4.0, 5.0, 6.0}};
        // ahead, to the left and up, where the scene has ahead, up and to the right
        QTest::newRow("sonic") << QByteArray("time,u,v,w\n0,5,1,0.5\n")
                               << NumberRows{{0.0, 5.0, 0.5, -1.0}};
    }
    void tables()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const NumberRows, rows);
        const Result<NumberRows> read = readWindRecord(text.toStdString(), "wind.csv");
        QVERIFY2(bool(read), read ? "" : read.message().english().c_str());
        compareRows(*read, rows);
    }

    void badTables_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("said");
        QTest::newRow("nothing") << QByteArray() << "wind.csv has no rows.";
        QTest::newRow("a header alone") << QByteArray("time,speed\n") << "wind.csv has no rows.";
        QTest::newRow("three columns") << QByteArray("0,1,2\n") << "wind.csv, line 1: Begin with";
        QTest::newRow("no speed") << QByteArray("time,pressure\n0,1\n")
                                  << "wind.csv, line 1: The header names no column for the speed";
        QTest::newRow("a unit of another kind")
            << QByteArray("time (s),speed (kg)\n0,1\n") << "\"kg\" is no unit for the speed";
        QTest::newRow("time goes back") << QByteArray("time,speed\n0,1\n2,1\n1,1\n")
                                        << "wind.csv, line 4: Its time does not come after";
        QTest::newRow("a word") << QByteArray("time,speed\n0,1\n1,calm\n")
                                << "wind.csv, line 3: \"calm\" is no number";
        QTest::newRow("a cell too few") << QByteArray("time,speed\n0,1\n1\n") << "wind.csv, line 3";
    }
    void badTables()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QString, said);
        const Result<NumberRows> read = readWindRecord(text.toStdString(), "wind.csv");
        QVERIFY(!read);
        const QString message = QString::fromStdString(read.message().english());
        QVERIFY2(message.contains(said), qPrintable(message));
    }

    // Straight from row to row, and as at the ends beyond them; the mean is what blows without it.
    void blowsAsMeasured()
    {
        const Scene scene =
            blownBy({{1.0, 2.0, 0.0, 0.0}, {3.0, 6.0, 1.0, 0.0}, {4.0, 0.0, 0.0, 8.0}});
        const auto system = compile(scene);
        QVERIFY(bool(system));
        // by trapezoids over 3 s
        const Vec3 mean = Vec3(8.0 + 3.0, 1.0 + 0.5, 4.0) / 3.0;
        QVERIFY((meanWindAt(scene, Vec3::Zero()) - mean).norm() < 1e-12);
        QVERIFY(((*system)->wind - mean).norm() < 1e-12);
        const std::pair<double, Vec3> expected[] = {
            {0.0, {2.0, 0.0, 0.0}}, {1.0, {2.0, 0.0, 0.0}},   {2.0, {4.0, 0.5, 0.0}},
            {3.0, {6.0, 1.0, 0.0}}, {3.75, {1.5, 0.25, 6.0}}, {4.0, {0.0, 0.0, 8.0}},
            {99.0, {0.0, 0.0, 8.0}}};
        for (const auto& [time, velocity] : expected)
            QVERIFY2((windAtTime(**system, time) - velocity).norm() < 1e-12,
                     qPrintable(QString::number(time)));
    }

    void keptInTheFile()
    {
        const Scene scene = blownBy({{0.0, 2.0, 0.0, 0.0}, {3.0, 6.0, 1.0, 0.1}});
        const Result<Scene> again = parseScene(sceneText(scene, {}), "scene");
        QVERIFY(bool(again));
        QVERIFY(*again == scene);
    }

    void refused_data()
    {
        QTest::addColumn<QString>("rows");
        QTest::addColumn<QString>("said");
        QTest::newRow("none") << "[]"
                              << "needs a row";
        QTest::newRow("three numbers") << "[[0, 1, 2]]"
                                       << "must have 4 numbers in each row (row 1)";
        QTest::newRow("the same time twice") << "[[0, 1, 0, 0], [0, 2, 0, 0]]"
                                             << "must have times that rise from row to row (row 2)";
    }
    void refused()
    {
        QFETCH(const QString, rows);
        QFETCH(const QString, said);
        const QString text = QString(R"({"format": "ripstop-scene", "version": 1, "nextId": 2,
            "items": [{"type": "wind", "id": 1, "kind": "measured", "velocities": %1}]})")
                                 .arg(rows);
        const Result<Scene> read = parseScene(text.toStdString(), "scene");
        QVERIFY(!read);
        const QString message = QString::fromStdString(read.message().english());
        QVERIFY2(message.contains(said), qPrintable(message));
    }

    void oneRowIsWarnedOf()
    {
        QVERIFY(warnsOf("wind-record", blownBy({{0.0, 2.0, 0.0, 0.0}})));
        QVERIFY(!warnsOf("wind-record", blownBy({{0.0, 2.0, 0.0, 0.0}, {1.0, 2.0, 0.0, 0.0}})));
    }

    // Seconds of a day, as loggers count, are none of a run.
    void clocksAreWarnedOf()
    {
        QVERIFY(warnsOf("wind-clock", blownBy({{43200.0, 2, 0, 0}, {43201.0, 3, 0, 0}})));
        QVERIFY(!warnsOf("wind-clock", blownBy({{5.0, 2, 0, 0}, {43201.0, 3, 0, 0}})));
    }

    // The table of a file, on the command line, and what is said of one that ends before the run.
    void commandLine()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("wind.csv");
        write(file, "time (s),speed (m/s)\n0,6\n0.1,8\n");
        const QStringList run{"run",   scene("delta_kite"), "--seconds", "0.2",
                              "--set", "wind.kind=measured"};
        const Outcome read = call(run + QStringList{"--set", "wind.velocities=@" + file});
        QVERIFY2(read.exitCode == 0, qPrintable(read.error));
        QVERIFY2(read.error.contains("was measured until 0.1 s"), qPrintable(read.error));
        const Outcome typed =
            call(run + QStringList{"--set", "wind.velocities=0, 6, 0, 0; 0.1, 8, 0, 0", "--json"});
        QVERIFY(QString(read.out).contains(typed.json()["hash"].toString()));
        const Outcome missing = call(run + QStringList{"--set", "wind.velocities=@none.csv"});
        QCOMPARE(missing.exitCode, 2);
        QVERIFY2(missing.error.contains("none.csv"), qPrintable(missing.error));
    }
};

const RegisteredTest registered("test_wind_record", runPlain<TestWindRecord>);

} // namespace ripstop::test_wind_record
#include "test_wind_record.moc"
