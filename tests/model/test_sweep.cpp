// One table of many runs.
//
// Stages: a table of falls against the formula; times that do not count; the same numbers as from
// `run`, for any number of jobs; runs that stop; and refusals.
#include "model/cli_call.h"
#include "registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

namespace ripstop::test_sweep {

namespace {

// A weight that falls from 5 m, and probes of its height and of what has no reading. One step is
// 0.01 s.
QByteArray fall()
{
    return "{\"format\": \"ripstop-scene\", \"version\": 1,\n"
           "\"settings\": {\"timeStep\": 0.01, \"substeps\": 1, \"airDensity\": 0,\n"
           "\"gravity\": [0, -10, 0]},\n"
           "\"items\": [\n"
           "{\"type\": \"part\", \"id\": 1, \"name\": \"weights\", \"particles\": [\n"
           "{\"id\": 2, \"position\": [0, 5, 0], \"mass\": 2}]},\n"
           "{\"type\": \"probe\", \"id\": 5, \"name\": \"height, own\", \"target\": 2}]}";
}

// Cells of a table without quoted line ends.
QList<QStringList> cellsOf(const QByteArray& text)
{
    QList<QStringList> rows;
    for (const QByteArray& line : text.trimmed().split('\n')) {
        if (line.startsWith('#'))
            continue;
        QStringList cells{QString()};
        bool quoted = false;
        for (const QChar c : QString::fromUtf8(line))
            if (c == '"')
                quoted = !quoted;
            else if (c == ',' && !quoted)
                cells << QString();
            else
                cells.last() += c;
        rows << cells;
    }
    return rows;
}

struct Folder : QTemporaryDir
{
    QString file = filePath("fall.ripstop.json");
    QString output = filePath("table.csv");

    Folder()
    {
        QFile scene(file);
        if (scene.open(QIODevice::WriteOnly))
            scene.write(fall());
    }

    QList<QStringList> table() const
    {
        QFile written(output);
        return written.open(QIODevice::ReadOnly) ? cellsOf(written.readAll())
                                                 : QList<QStringList>();
    }
};

} // namespace

class TestSweep : public QObject
{
    Q_OBJECT

private slots:
    // A fall from rest: y = y0 - g t^2 / 2, which the mean over the time is y0 - g t^2 / 6; to the
    // first order in the step, which is what all integrators here keep.
    void aRowForEachRun()
    {
        Folder folder;
        const Outcome outcome = call(
            {"sweep", folder.file, "--sweep", "settings.gravity=0,-10,0; 0,-5,0; 0,0,0", "--sweep",
             "weights.particles.mass=1:0.5:2", "--seconds", "0.5", "-o", folder.output});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        const auto table = folder.table();
        QCOMPARE(table.size(), 1 + 9);
        QCOMPARE(table[0], (QStringList{"scene", "settings.gravity", "weights.particles.mass",
                                        "time (s)", "steps", "hash", "torn links", "stopped",
                                        "accuracy", "height, own final (m)", "height, own mean (m)",
                                        "height, own min (m)", "height, own max (m)"}));
        for (int i = 0; i < 9; ++i) {
            const QStringList& row = table[i + 1];
            const double gravity = 10.0 - 5.0 * (i / 3);
            QCOMPARE(row[2].toDouble(), 1.0 + 0.5 * (i % 3));
            QCOMPARE(row[4], QString("50"));
            QVERIFY(std::abs(row[9].toDouble() - (5.0 - gravity * 0.125)) < 0.03);
            QVERIFY(std::abs(row[10].toDouble() - (5.0 - gravity * 0.25 / 6.0)) < 0.03);
            QCOMPARE(row[11], row[9]); // it is lowest in the end and highest at the start
            QCOMPARE(row[12].toDouble(), 5.0);
        }
    }

    // What comes before --from does not count: from 0.3 s to 0.5 s the mean of y0 - g t^2 / 2 is
    // y0 - g (0.5^3 - 0.3^3) / (6 x 0.2), and it is highest at 0.3 s.
    void aStartDiesAway()
    {
        Folder folder;
        const Outcome outcome =
            call({"sweep", folder.file, "--seconds", "0.5", "--from", "0.3", "-o", folder.output});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        const QStringList row = folder.table().at(1);
        QVERIFY(std::abs(row[7].toDouble() - 3.75) < 0.03);
        QVERIFY(std::abs(row[8].toDouble() - (5.0 - 10.0 * 0.098 / 1.2)) < 0.03);
        QVERIFY(std::abs(row[10].toDouble() - 4.55) < 0.03);
    }

    // The same bits as by run, and the same table for any number of jobs.
    void agreesWithRun()
    {
        Folder folder;
        const QStringList sweep{"sweep",   scene("delta_kite"),         scene("pendulum"),
                                "--sweep", "settings.airDensity=1,1.2", "--seconds",
                                "0.5"};
        const Outcome one = call(sweep), three = call(sweep + QStringList{"--jobs", "3"});
        QVERIFY2(one.exitCode == 0, qPrintable(one.error));
        QCOMPARE(three.out, one.out);
        const auto table = cellsOf(one.out);
        QCOMPARE(table.size(), 1 + 4);
        for (int i = 0; i < 4; ++i) {
            const Outcome flown = call({"run", table[i + 1][0], "--seconds", "0.5", "--set",
                                        "settings.airDensity=" + table[i + 1][1], "--json"});
            QCOMPARE(table[i + 1][4], flown.json()["hash"].toString());
            const QJsonObject probes = flown.json()["probes"].toObject();
            for (int c = 0; c < table[0].size(); ++c)
                if (table[0][c].contains(" final") && !table[i + 1][c].isEmpty()) {
                    const QString name = table[0][c].section(" final", 0, 0);
                    QCOMPARE(table[i + 1][c].toDouble(), probes[name].toDouble());
                }
        }
    }

    // One vector, with ; behind it; and steps that are thirds to so many digits.
    void endsOfAxes()
    {
        Folder folder;
        const auto rowsOf = [&](const QString& sweep) {
            const Outcome outcome =
                call({"sweep", folder.file, "--sweep", sweep, "--seconds", "0.01"});
            return outcome.exitCode == 0 ? cellsOf(outcome.out).size() - 1 : -1;
        };
        QCOMPARE(rowsOf("settings.gravity=0,-10,0;"), 1);
        QCOMPARE(rowsOf("settings.airDensity=0:0.3333333:1"), 4);
        QCOMPARE(rowsOf("settings.airDensity=1:0.1:1.3"), 4);
    }

    void rangesThatAreNone()
    {
        Folder folder;
        for (const auto& [range, said] :
             {std::pair("1:0:2", "and 0 does not"),
              {"2:0.1:1", "and 0.1 does not"},
              {"1:1e-6:2", "has 1000001 values, and 100000 can be flown at most"}}) {
            const Outcome outcome =
                call({"sweep", folder.file, "--sweep", QString("settings.airDensity=%1").arg(range),
                      "--seconds", "0.01"});
            QCOMPARE(outcome.exitCode, 2);
            QVERIFY2(outcome.error.contains(said), qPrintable(outcome.error));
        }
    }

    // Whatever a sweep varies can be flown again by --set: a number of a vector, a parameter of a
    // builder, and threads that carry from now on.
    void rowsAreFlownAgain_data()
    {
        QTest::addColumn<QString>("design");
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        QTest::newRow("one number of a vector") << scene("delta_kite") << "wind.velocity.x"
                                                << "7";
        QTest::newRow("a builder's parameter") << scene("delta_kite") << "kite.built.span"
                                               << "2.1";
        QTest::newRow("threads that carry") << scene("elastic_sheet") << "sheet.carrier"
                                            << "threads";
    }

    void rowsAreFlownAgain()
    {
        QFETCH(QString, design);
        QFETCH(QString, path);
        QFETCH(QString, value);
        const Outcome swept =
            call({"sweep", design, "--sweep", path + '=' + value, "--seconds", "0.1"});
        QVERIFY2(swept.exitCode == 0, qPrintable(swept.error));
        const auto table = cellsOf(swept.out);
        const Outcome flown =
            call({"run", design, "--seconds", "0.1", "--set", path + '=' + value, "--json"});
        QVERIFY2(flown.exitCode == 0, qPrintable(flown.error));
        QCOMPARE(table[1][4], flown.json()["hash"].toString());
        const Outcome plain = call({"run", design, "--seconds", "0.1", "--json"});
        QVERIFY(flown.json()["hash"] != plain.json()["hash"]);
    }

    // Faster than 4 m/s is refused: with 10 m/s^2 that is after 0.4 s, with 5 never.
    void aRunThatStopsSaysSo()
    {
        Folder folder;
        const Outcome outcome =
            call({"sweep", folder.file, "--sweep", "settings.gravity=0,-10,0; 0,-5,0", "--set",
                  "settings.speedLimit=4", "--seconds", "0.5", "-o", folder.output});
        QCOMPARE(outcome.exitCode, 3);
        QVERIFY2(outcome.error.contains("1 of 2 runs"), qPrintable(outcome.error));
        const auto table = folder.table();
        QVERIFY(std::abs(table[1][2].toDouble() - 0.4) < 0.02);
        QVERIFY(!table[1][6].isEmpty());
        QVERIFY(std::abs(table[2][2].toDouble() - 0.5) < 0.01);
        QVERIFY(table[2][6].isEmpty());
    }

    // Two cloths of the library: each row is a flight of the scene that presets --apply makes. A
    // scene without cloth is flown once.
    void everyClothIsFlown()
    {
        Folder folder;
        const Outcome outcome =
            call({"sweep", scene("flag"), folder.file, "--cloth", "ripstop_050,dacron_sail",
                  "--seconds", "0.2", "-o", folder.output});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        const auto table = folder.table();
        QCOMPARE(table.size(), 1 + 3);
        QCOMPARE(table[0][1], QString("cloth"));
        QCOMPARE(table[3][1], QString());
        const QString made = folder.filePath("made.ripstop.json");
        for (const int row : {1, 2}) {
            QStringList apply{"presets", scene("flag"), "--apply", table[row][1], "-o", made};
            for (const char* material : {"cloth", "shear", "structural"})
                apply << "--material" << material;
            const Outcome changed = call(apply);
            QVERIFY2(changed.exitCode == 0, qPrintable(changed.error));
            const Outcome flown = call({"run", made, "--seconds", "0.2", "--json"});
            QCOMPARE(table[row][4], flown.json()["hash"].toString());
        }
        QVERIFY(table[1][4] != table[2][4]);
    }

    // Each of these is refused before the first run, with a word that says why.
    void refusesCloth_data()
    {
        QTest::addColumn<QString>("cloth");
        QTest::addColumn<QString>("words");
        QTest::newRow("no such preset") << "ripstop_076"
                                        << "did you mean";
        QTest::newRow("a line") << "dyneema_1"
                                << "no fabric";
    }

    void refusesCloth()
    {
        QFETCH(QString, cloth);
        QFETCH(QString, words);
        Folder folder;
        const Outcome outcome = call({"sweep", scene("flag"), "--cloth", cloth, "--seconds", "1"});
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY2(outcome.error.contains(words), qPrintable(outcome.error));
    }

    // What misses the accuracy that is wanted is told in its row.
    void tellsOfMissedAccuracy()
    {
        Folder folder;
        const Outcome outcome =
            call({"sweep", scene("paper_kite"), "--seconds", "1", "-o", folder.output});
        QVERIFY2(outcome.exitCode == 0, qPrintable(outcome.error));
        QCOMPARE(folder.table()[0][6], QString("accuracy"));
        QVERIFY(folder.table()[1][6].contains("missed the wanted accuracy"));
    }

    // Two lists of one path would leave rows that say what was not flown; measures after the end
    // would leave empty columns.
    void refusesWhatComesToNothing()
    {
        Folder folder;
        const Outcome twice =
            call({"sweep", folder.file, "--sweep", "settings.airDensity=1,2", "--sweep",
                  "settings.airDensity=3,4", "--seconds", "1", "-o", folder.output});
        QCOMPARE(twice.exitCode, 2);
        QVERIFY2(twice.error.contains("is varied twice"), qPrintable(twice.error));
        const Outcome late = call({"sweep", folder.file, "--sweep", "settings.airDensity=1,2",
                                   "--seconds", "1", "--from", "1", "-o", folder.output});
        QCOMPARE(late.exitCode, 2);
        QVERIFY2(late.error.contains("are over at 1 s"), qPrintable(late.error));
        QVERIFY(!QFile::exists(folder.output));
    }

    void refuses_data()
    {
        QTest::addColumn<QString>("sweep");
        QTest::addColumn<QString>("words");
        QTest::newRow("no such property") << "settings.timeStap=1,2"
                                          << "timeStep";
        QTest::newRow("no such item") << "nobody.mass=1"
                                      << "nobody";
        QTest::newRow("no value") << "settings.airDensity="
                                  << "missing";
        QTest::newRow("an empty value") << "settings.airDensity=1,,2"
                                        << "missing";
        QTest::newRow("no path") << "=1"
                                 << "PATH=VALUES";
        QTest::newRow("nothing") << "airDensity"
                                 << "PATH=VALUES";
        QTest::newRow("not in the range") << "settings.airDensity=1,-1"
                                          << "-1";
        QTest::newRow("not a number") << "settings.airDensity=1:a:2"
                                      << "three numbers";
        QTest::newRow("no way there") << "settings.airDensity=1:-1:2"
                                      << "no value";
        QTest::newRow("an end beside the steps") << "settings.airDensity=4:5:20"
                                                 << "come to 19 and 24";
        QTest::newRow("one vector") << "settings.gravity=0,-10,0"
                                    << "\"settings.gravity=0,-10,0;\"";
        QTest::newRow("no step") << "settings.airDensity=1:0:2"
                                 << "no value";
        QTest::newRow("control tracks") << "controls=still.csv,pulled.csv"
                                        << "--controls";
    }

    void refuses()
    {
        QFETCH(QString, sweep);
        QFETCH(QString, words);
        Folder folder;
        const Outcome outcome =
            call({"sweep", folder.file, "--sweep", sweep, "--seconds", "1", "-o", folder.output});
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY2(outcome.error.contains(words), qPrintable(outcome.error));
        QVERIFY(!QFile::exists(folder.output));
    }

    void saysWhenTheTableCannotBeWritten()
    {
        Folder folder;
        const Outcome outcome =
            call({"sweep", folder.file, "--seconds", "0.1", "-o", "/proc/table.csv"});
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.error.contains("/proc/table.csv"), qPrintable(outcome.error));
    }
};

const RegisteredTest registered("test_sweep", runWithCore<TestSweep>);

} // namespace ripstop::test_sweep
#include "test_sweep.moc"
