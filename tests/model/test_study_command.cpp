// ripstop-cli study, as people call it: shards, kills, longer studies, and what it refuses.
#include "model/cli_call.h"
#include "registered_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_study_command {

namespace {

// A study of the pendulum in a folder of its own.
class Folder
{
public:
    explicit Folder(const QString& values = "1:0.5:8", const QString& seconds = "2")
    {
        const Outcome made = call({"study", "new", study(), "--scene", scene("pendulum"), "--vary",
                                   "settings.airDensity=" + values, "--vary",
                                   "settings.substeps=4,8", "--seconds", seconds});
        m_made = made.exitCode == 0;
        m_why = made.error;
    }

    QString study() const { return m_folder.filePath("s.ripstop-study.json"); }
    QString file(const char* name) const { return m_folder.filePath(name); }
    bool made() const { return m_made; }
    QString why() const { return m_why; }

    Outcome run(const QStringList& more = {}) const
    {
        return call(QStringList{"study", "run", study()} + more);
    }
    QByteArray table() const { return call({"study", "merge", study()}).out; }
    QJsonObject status() const { return call({"study", "status", study(), "--json"}).json(); }

private:
    QTemporaryDir m_folder;
    bool m_made = false;
    QString m_why;
};

} // namespace

class TestStudyCommand : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const Folder whole;
        QVERIFY2(whole.made(), qPrintable(whole.why()));
        QCOMPARE(whole.status()["points"].toInt(), 30);
        const Outcome run = whole.run();
        QVERIFY2(run.exitCode == 0, qPrintable(run.error));
        m_table = whole.table();
        QCOMPARE(m_table.count('\n'), 32); // a comment and a heading before them
        QCOMPARE(whole.status()["missing"].toInt(), 0);
    }

    // Three shards, in any order, make the same table to the byte.
    void shardsMakeTheSameTable()
    {
        const Folder parts;
        for (const char* shard : {"3/3", "1/3", "2/3"})
            QCOMPARE(parts.run({"--shard", shard, "--jobs", "1"}).exitCode, 0);
        QCOMPARE(parts.table(), m_table);
        QCOMPARE(QDir(parts.file("s.ripstop-runs")).entryList({"*.jsonl"}, QDir::Files).size(), 3);
    }

    // Killed again and again, it comes to the same table, and has flown none twice.
    void killsLoseNothingButWhatWasUnderWay()
    {
        const Folder killed;
        int kills = 0;
        for (int wait = 20; killed.status()["missing"].toInt() > 0 && kills < 100; ++kills) {
            QProcess process;
            process.start(CLI_PROGRAM, {"study", "run", killed.study(), "--jobs", "2"});
            QVERIFY(process.waitForStarted());
            process.waitForFinished(wait);
            if (process.state() != QProcess::NotRunning) {
                process.kill();
                process.waitForFinished();
            }
            wait += 10; // so that it comes to an end on a slow machine too
        }
        QVERIFY(kills > 1);
        QCOMPARE(killed.table(), m_table);
        QCOMPARE(killed.status()["differing"].toInt(), 0);
    }

    void longerStudiesKeepWhatTheyHave()
    {
        const Folder grown("1:0.5:7.5");
        QVERIFY(grown.run().error.contains("Flown: 28"));
        QFile file(grown.study());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll().replace("\"7.5\"", "\"7.5\", \"8\"");
        file.close();
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        QCOMPARE(grown.status()["missing"].toInt(), 2);
        QVERIFY(grown.run().error.contains("Flown: 2"));
        QCOMPARE(grown.table(), m_table);
        QVERIFY(grown.run().error.contains("flown already"));
    }

    // A design that was edited: nothing is flown until it is said of which.
    void editedDesignsAreAskedAbout()
    {
        QTemporaryDir folder;
        const QString design = folder.filePath("a.ripstop.json");
        const QString study = folder.filePath("s.ripstop-study.json");
        QFile::copy(scene("pendulum"), design);
        const Outcome made = call({"study", "new", study, "--scene", design, "--vary",
                                   "settings.substeps=4,8,16", "--seconds", "1"});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        QCOMPARE(call({"study", "run", study, "--shard", "1/2"}).exitCode, 0);
        QFile file(design);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();
        file.close();
        const auto edit = [&](const QByteArray& text) {
            if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0)
                qFatal("the design cannot be written");
            file.close();
        };
        QByteArray after = before;
        after.replace("\"settings\": {", "\"settings\": {\n    \"gravity\": [0, -5, 0],");
        QVERIFY(after != before);
        edit(after);
        const Outcome asked = call({"study", "run", study});
        QVERIFY2(asked.exitCode != 0 && asked.error.contains("--anew")
                     && asked.error.contains("--keep"),
                 qPrintable(asked.error));
        const QString output = folder.filePath("s.csv");
        QVERIFY(QFile::copy(design, output)); // stands for a table of the flights of before
        for (const char* writes : {"merge", "report"}) {
            const Outcome refused = call({"study", writes, study, "-o", output});
            QVERIFY(refused.exitCode != 0);
            QCOMPARE(refused.error, asked.error);
            QCOMPARE(contentOf(output), after);
        }
        const Outcome told = call({"study", "status", study, "--json"});
        QCOMPARE(told.json()["flown"].toInt(), 0);
        QVERIFY2(told.error.contains("--anew"), qPrintable(told.error));
        QVERIFY(call({"study", "status", study, "--keep"}).error.isEmpty());
        const Outcome kept = call({"study", "run", study, "--keep"});
        QVERIFY2(kept.error.contains("Flown: 1;"), qPrintable(kept.error));
        const QByteArray table = call({"study", "merge", study, "--keep"}).out;
        const Outcome anew = call({"study", "run", study, "--anew"});
        QVERIFY2(anew.error.contains("Flown: 3;"), qPrintable(anew.error));
        QVERIFY(call({"study", "merge", study}).out != table);
        QCOMPARE(call({"study", "run", study}).exitCode, 0); // now it is known
        edit(before);
        QCOMPARE(call({"study", "merge", study}).out, table);
    }

    // A study that was edited so that it has none of its flights leaves the table of before alone.
    void tablesWithoutFlightsTakeNoPlace()
    {
        const Folder folder;
        const QString output = folder.file("s.csv");
        QCOMPARE(folder.run({"--shard", "1/10"}).exitCode, 0);
        QCOMPARE(call({"study", "merge", folder.study(), "-o", output}).exitCode, 0);
        const QByteArray table = contentOf(output);
        write(folder.study(),
              contentOf(folder.study()).replace("\"seconds\": 2", "\"seconds\": 1"));
        const Outcome refused = call({"study", "merge", folder.study(), "-o", output});
        QVERIFY2(refused.exitCode != 0 && refused.error.contains("study run"),
                 qPrintable(refused.error));
        QCOMPARE(contentOf(output), table);
    }

    // A control track is a value like others, and what counts is what stands in the file.
    void controlTracksVary()
    {
        QTemporaryDir folder;
        const QString study = folder.filePath("s.ripstop-study.json");
        const auto track = [&](const char* name, const char* text) {
            QFile file(folder.filePath(name));
            if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0)
                qFatal("the track cannot be written");
        };
        track("still.csv", "time (s),control,value (m)\n");
        track("pulled.csv", "time (s),control,value (m)\n0.1,corner x,0.05\n");
        const Outcome made = call({"study", "new", study, "--scene", scene("cloth"), "--vary",
                                   "controls=still.csv,pulled.csv", "--seconds", "0.5"});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        const Outcome run = call({"study", "run", study});
        QVERIFY2(run.error.contains("Flown: 2;"), qPrintable(run.error));
        const QList<QByteArray> rows = call({"study", "merge", study}).out.split('\n');
        QVERIFY(rows[2].split(',')[4] != rows[3].split(',')[4]); // hashes
        track("pulled.csv", "time (s),control,value (m)\n0.2,corner x,0.05\n");
        QCOMPARE(call({"study", "status", study, "--json"}).json()["missing"].toInt(), 1);
        QFile::remove(folder.filePath("still.csv"));
        QVERIFY(call({"study", "run", study}).error.contains("still.csv"));
    }

    // The paper's kite has a fixed solver that holds no accuracy; with the automatic one it does.
    void whatMissesTheAccuracySaysSo()
    {
        QTemporaryDir folder;
        const QString study = folder.filePath("s.ripstop-study.json");
        const Outcome made = call({"study", "new", study, "--scene", scene("paper_kite"), "--vary",
                                   "settings.solver=paper_jacobi,auto", "--seconds", "0.2"});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        const Outcome run = call({"study", "run", study});
        QVERIFY2(run.error.contains("1 missed the accuracy"), qPrintable(run.error));
        QCOMPARE(call({"study", "status", study, "--json"}).json()["inaccurate"].toInt(), 1);
        const QByteArray table = call({"study", "merge", study}).out;
        QCOMPARE(table.count("missed the wanted accuracy"), 1);
    }

    // A point that cannot be flown is a row with its reason.
    void whatDivergesIsARow()
    {
        QTemporaryDir folder;
        const QString study = folder.filePath("s.ripstop-study.json");
        const Outcome made = call({"study", "new", study, "--scene", scene("delta_kite"), "--vary",
                                   "wind.velocity=6,0,0; 1e6,0,0", "--seconds", "0.1"});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        QCOMPARE(call({"study", "run", study}).exitCode, 0);
        QCOMPARE(call({"study", "status", study, "--json"}).json()["stopped"].toInt(), 1);
        QCOMPARE(call({"study", "merge", study}).out.count('\n'), 4);
    }

    void shippedStudiesCanBeFlown()
    {
        const QDir scenes(SCENES_DIR);
        const QStringList studies = scenes.entryList({"*.ripstop-study.json"}, QDir::Files);
        QVERIFY(!studies.isEmpty());
        for (const QString& study : studies) {
            const Outcome told = call({"study", "status", scenes.filePath(study), "--json"});
            QVERIFY2(told.exitCode == 0, qPrintable(told.error));
            QVERIFY(told.json()["points"].toInt() > 1);
        }
    }

    // The script of a job array is one that a shell can read, whatever the folder is called.
    void scriptsAreOfTheShell()
    {
        const Folder folder;
        const QString odd = folder.file("it's a folder");
        QVERIFY(QDir().mkpath(odd));
        const QString study = odd + "/s.ripstop-study.json";
        const Outcome made = call({"study", "new", study, "--scene", scene("pendulum"), "--vary",
                                   "settings.airDensity=1,2", "--seconds", "0.1"});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        const QByteArray script = call({"study", "slurm", study, "--tasks", "1"}).out;
        QProcess shell; // as a task has it: its shard, and no Slurm that takes it again
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("SLURM_ARRAY_TASK_ID", "1");
        shell.setProcessEnvironment(environment);
        shell.start("bash", {"-c", script});
        QVERIFY(shell.waitForFinished(60000));
        QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
        QCOMPARE(call({"study", "status", study, "--json"}).json()["flown"].toInt(), 2);
    }

    void refusals()
    {
        const Folder folder;
        const auto says = [&](const QStringList& arguments, const char* words) {
            const Outcome outcome = call(arguments);
            QVERIFY2(outcome.exitCode == 1 || outcome.exitCode == 2,
                     qPrintable(QString::number(outcome.exitCode)));
            QVERIFY2(outcome.error.contains(words), qPrintable(outcome.error));
        };
        says({"study", "run", folder.file("none.ripstop-study.json")}, "none.ripstop-study.json");
        says({"study", "run", folder.study(), "--shard", "4/3"}, "K/N");
        says({"study", "run", scene("pendulum")}, "is no study");
        says({"study", "merge", folder.study(), "-o", folder.study()}, "would be destroyed");
        says({"study", "new", folder.file("t.ripstop-study.json"), "--scene", scene("pendulum"),
              "--vary", "settings.airDensty=1,2"},
             "airDensity");
        const QStringList begun{
            "study",  "new",     folder.file("t.ripstop-study.json"), "--scene", scene("pendulum"),
            "--plan", "optimise"};
        for (const char* goal : {"--minimise", "--maximise"})
            says(begun + QStringList{"--vary", "settings.airDensity=1..2", goal, "line tensin max"},
                 "measures the probe line tensin");
        says({"study", "new", folder.file("t.ripstop-study.json"), "--scene", scene("pendulum"),
              "--vary", "settings.gravity=0,-10,0"},
             "separated by ;");
        QVERIFY(!QFile::exists(folder.file("t.ripstop-study.json")));
        QFile file(folder.study());
        const auto textNow = [&] { return file.open(QIODevice::ReadOnly) ? file.readAll() : ""; };
        const QByteArray text = textNow();
        file.close();
        const QStringList another{"study",           "new",    folder.study(),           "--scene",
                                  scene("pendulum"), "--vary", "settings.airDensity=1,2"};
        says(another, "--replace");
        QCOMPARE(textNow(), text);
        file.close();
        QCOMPARE(call(another + QStringList{"--replace"}).exitCode, 0);
        QVERIFY(textNow() != text);
        file.close();
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            QByteArray(text).replace("\"plan\"", "\"measures\": [{\"probe\": \"pul\"}],\"plan\""));
        file.close();
        says({"study", "run", folder.study()}, "measures the probe pul");
    }

private:
    QByteArray m_table;
};

const RegisteredTest registered("test_study_command", runWithCore<TestStudyCommand>);

} // namespace ripstop::test_study_command
#include "test_study_command.moc"
