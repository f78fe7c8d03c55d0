// Files that appear whole or not at all (base/new_file.h).
//
// In order: names of files under way and what becomes of those that dead processes left; targets
// that a command reads; signals; recordings of killed runs.
#include "base/new_file.h"
#include "io/recording_file.h"
#include "model/cli_call.h"
#include "registered_test.h"

#include <QDirIterator>
#include <QTemporaryDir>

#include <array>
#include <csignal>

#include <sys/wait.h>
#include <unistd.h>

namespace ripstop::test_whole_files {

namespace {

namespace fs = std::filesystem;

QStringList namesIn(const QString& folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
}

// The number of a process that has ended.
pid_t deadProcess()
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

// A name that a process would have given to a file under way.
QString partOf(const QString& target, pid_t process)
{
    const std::string own = std::to_string(::getpid());
    std::string name = partBeside(target.toStdString()).string();
    return QString::fromStdString(
        name.replace(name.rfind("." + own + "-") + 1, own.size(), std::to_string(process)));
}

// A rope that flies for longer than anyone waits.
struct EndlessRun
{
    QTemporaryDir folder;
    QProcess process;

    QString path(const char* name) const { return folder.filePath(name); }

    // Whether there is a file under way that has grown beyond `size`, after a while.
    bool start(const QStringList& more, qint64 size)
    {
        process.setWorkingDirectory(folder.path());
        process.start(CLI_PROGRAM,
                      QStringList{"run", scene("rope"), "--seconds", "1e8", "--threads", "1"}
                          + more);
        return QTest::qWaitFor(
            [&] {
                for (const QFileInfo& file : QDir(folder.path()).entryInfoList(QDir::Files))
                    if (file.size() > size)
                        return true;
                return false;
            },
            60000);
    }

    int end(int signal)
    {
        ::kill(pid_t(process.processId()), signal);
        return process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit
                   ? process.exitCode()
                   : -signal;
    }
};

} // namespace

class TestWholeFiles : public QObject
{
    Q_OBJECT

private slots:
    void comesIntoItsPlaceWhole()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("table.csv");
        write(path, "old");
        {
            Result<NewFile> file = NewFile::open(path.toStdString());
            QVERIFY(bool(file));
            file->out() << "new" << std::flush;
            QCOMPARE(contentOf(path), QByteArray("old"));
            QCOMPARE(contentOf(QString::fromStdString(file->written().string())),
                     QByteArray("new"));
        }
        QCOMPARE(contentOf(path), QByteArray("old")); // it was not committed
        QCOMPARE(namesIn(folder.path()), QStringList{"table.csv"});
        Result<NewFile> file = NewFile::open(path.toStdString());
        file->out() << "new";
        QVERIFY(!file->commit());
        QCOMPARE(contentOf(path), QByteArray("new"));
        QCOMPARE(namesIn(folder.path()), QStringList{"table.csv"});
    }

    void writersOfOneTargetDoNotMeet()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("table.csv").toStdString();
        Result<NewFile> a = NewFile::open(path), b = NewFile::open(path);
        QVERIFY(a->written() != b->written());
        a->out() << "a";
        b->out() << "b";
        QVERIFY(!a->commit());
        QCOMPARE(contentOf(QString::fromStdString(path)), QByteArray("a"));
        QVERIFY(!b->commit());
        QCOMPARE(contentOf(QString::fromStdString(path)), QByteArray("b"));
    }

    // Each writes its own files, and the last to end has the target.
    void exportsOfOneNameDoNotMix_data()
    {
        QTest::addColumn<QString>("target");
        for (const char* target : {"a.glb", "a.pvd", "a.csv", "a_{frame}.obj", "a.zip"})
            QTest::newRow(target) << target;
    }

    void exportsOfOneNameDoNotMix()
    {
        QFETCH(QString, target);
        const QTemporaryDir folder;
        const QStringList end = target.endsWith("zip") ? QStringList{"bundle", "--seconds"}
                                                       : QStringList{"export", "--to"};
        std::array<QProcess, 2> writers;
        const std::array scenes{scene("rope"), scene("pendulum")};
        std::array<QMap<QString, QByteArray>, 2> alone;
        for (std::size_t i = 0; i < 2; ++i) {
            const QTemporaryDir own;
            QProcess one;
            one.setWorkingDirectory(own.path());
            one.start(CLI_PROGRAM, {end[0], scenes[i], "-o", target, end[1], "1"});
            QVERIFY(one.waitForFinished(60000));
            QDirIterator files(own.path(), QDir::Files, QDirIterator::Subdirectories);
            while (files.hasNext()) {
                const QString path = files.next();
                alone[i][QDir(own.path()).relativeFilePath(path)] = contentOf(path);
            }
            QVERIFY(!alone[i].isEmpty());
        }
        for (std::size_t i = 0; i < 2; ++i) {
            writers[i].setWorkingDirectory(folder.path());
            writers[i].start(CLI_PROGRAM, {end[0], scenes[i], "-o", target, end[1], "1"});
        }
        for (QProcess& writer : writers) {
            QVERIFY(writer.waitForFinished(60000));
            QCOMPARE(writer.exitCode(), 0);
        }
        int count = 0;
        QDirIterator files(folder.path(), QDir::Files, QDirIterator::Subdirectories);
        for (; files.hasNext(); ++count) {
            const QString path = files.next();
            const QString name = QDir(folder.path()).relativeFilePath(path);
            const QByteArray content = contentOf(path);
            QVERIFY2(content == alone[0][name] || content == alone[1][name], qPrintable(name));
        }
        QCOMPARE(count, int(alone[0].size()));
    }

    void takesAwayWhatDeadProcessesLeft()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("table.csv");
        const QString ofDead = partOf(path, deadProcess());
        const QString folderOfDead = partOf(folder.filePath("bundle"), deadProcess());
        const QString ofLiving = partOf(path, ::getppid());
        QString ofAnotherMachine = ofDead;
        ofAnotherMachine.replace(ofDead.size() - QString(".part").size() - 8, 8, "00000000");
        const QString like = folder.filePath("my.1-2.part");
        for (const QString& file : {ofDead, ofLiving, ofAnotherMachine, like})
            write(file, "half");
        QVERIFY(QDir().mkpath(folderOfDead + "/inside"));
        QVERIFY(!NewFile::open(path.toStdString())->commit());
        for (const QString& file : {path, ofLiving, ofAnotherMachine, like})
            QVERIFY2(QFile::exists(file), qPrintable(file));
        QVERIFY(!QFile::exists(ofDead));
        QVERIFY(!QFile::exists(folderOfDead));
    }

    void longNamesFit()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QString(250, 'k') + ".csv");
        Result<NewFile> file = NewFile::open(path.toStdString());
        QVERIFY(bool(file));
        QVERIFY(!file->commit());
        QVERIFY(QFile::exists(path));
    }

    // --- targets that are read -----------------------------------------------------------------

    void refusesToDestroyWhatItReads_data()
    {
        QTest::addColumn<QStringList>("arguments"); // S is the scene, C its controls, M a mesh
        const QStringList run{"run", "S", "--seconds", "0.1"};
        for (const char* option :
             {"--csv", "--tears", "--loads", "--events", "--record", "--final"})
            QTest::newRow(option) << run + QStringList{option, "S"};
        QTest::newRow("by a link") << run + QStringList{"--csv", "L"};
        QTest::newRow("controls") << run + QStringList{"--controls", "C", "--events", "C"};
        QTest::newRow("file of a collider") << run + QStringList{"--csv", "M"};
        QTest::newRow("sweep") << QStringList{"sweep", "S", "--seconds", "0.1", "-o", "S"};
        QTest::newRow("certify") << QStringList{"certify", "S", "--seconds", "0.1", "--csv", "S"};
        QTest::newRow("import") << QStringList{"import", "M", "-o", "M"};
        QTest::newRow("export") << QStringList{"export", "M.obj", "-o", "M.obj"};
        QTest::newRow("bundle") << QStringList{"bundle", "S.zip", "-o", "S.zip"};
    }

    void refusesToDestroyWhatItReads()
    {
        QFETCH(QStringList, arguments);
        const QTemporaryDir folder;
        const QString design = folder.filePath("S"), mesh = folder.filePath("M");
        QByteArray text = contentOf(scene("sheet_on_boxes"));
        text.replace("\"shape\": \"box\"", "\"shape\": \"mesh\",\n   \"file\": \"M\"");
        write(design, text);
        write(folder.filePath("C"), "time (s),control,value (m)\n");
        for (const char* name : {"M", "M.obj", "S.zip"})
            write(folder.filePath(name), "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
        QVERIFY(QFile::link(design, folder.filePath("L")));
        QMap<QString, QByteArray> before;
        for (const QString& name : namesIn(folder.path()))
            before[name] = contentOf(folder.filePath(name));
        for (QString& argument : arguments)
            if (before.contains(argument))
                argument = folder.filePath(argument);

        const Outcome outcome = call(arguments);
        QVERIFY2(outcome.error.contains("is read by this command"), qPrintable(outcome.error));
        QCOMPARE(outcome.exitCode, 2);
        for (const QString& name : namesIn(folder.path()))
            QCOMPARE(contentOf(folder.filePath(name)), before[name]);
    }

    // The mesh that a point cache moves is written beside it, without having been named.
    void refusesToReplaceAMeshThatWasNotNamed()
    {
        const QTemporaryDir folder;
        const auto exported = [&] {
            return call({"export", scene("flag"), "-o", folder.filePath("sail.pc2"), "--to", "0"});
        };
        const QByteArray others = "# Blender\nv 0 0 0\n";
        write(folder.filePath("sail.obj"), others);
        const Outcome refused = exported();
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.error.contains("sail.obj is written beside"), qPrintable(refused.error));
        QCOMPARE(namesIn(folder.path()), QStringList{"sail.obj"});
        QCOMPARE(contentOf(folder.filePath("sail.obj")), others);
        QVERIFY(QFile::remove(folder.filePath("sail.obj")));
        QVERIFY(!exported().error.contains("written anew"));
        const Outcome again = exported(); // one's own may be made again, and is told of
        QCOMPARE(again.exitCode, 0);
        QVERIFY2(again.error.contains("sail.obj was there, and is written anew"),
                 qPrintable(again.error));
        write(folder.filePath("sail.obj"), others); // not by the export that is there
        QCOMPARE(exported().exitCode, 2);
        QCOMPARE(contentOf(folder.filePath("sail.obj")), others);
    }

    // Nor one that Ripstop wrote, of an export by itself.
    void refusesToReplaceAMeshOfAnotherExport()
    {
        const QTemporaryDir folder;
        const auto exported = [&](const QString& name, const QStringList& more = {}) {
            return call(QStringList{"export", scene("flag"), "-o", folder.filePath(name)} + more);
        };
        QCOMPARE(exported("sail.obj", {"--to", "0.5"}).exitCode, 0);
        const QByteArray mesh = contentOf(folder.filePath("sail.obj"));
        const QStringList before = namesIn(folder.path());
        for (const char* cache : {"sail.pc2", "sail.mdd"}) {
            const Outcome refused = exported(cache, {"--to", "0"});
            QCOMPARE(refused.exitCode, 2);
            QVERIFY2(refused.error.contains("or say --replace"), qPrintable(refused.error));
            QCOMPARE(namesIn(folder.path()), before);
            QCOMPARE(contentOf(folder.filePath("sail.obj")), mesh);
        }
        QCOMPARE(exported("sail.pc2", {"--to", "0", "--replace"}).exitCode, 0);
        QVERIFY(contentOf(folder.filePath("sail.obj")) != mesh);
    }

    void refusesOneFileForTwo()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.csv");
        const Outcome outcome =
            call({"run", scene("rope"), "--seconds", "0.1", "--csv", path, "--events", path});
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY2(outcome.error.contains("written twice"), qPrintable(outcome.error));
        QCOMPARE(namesIn(folder.path()), QStringList());
    }

    // --- signals -------------------------------------------------------------------------------

    void endsInOrder_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGHUP") << SIGHUP;
    }

    void endsInOrder()
    {
        QFETCH(int, signal);
        EndlessRun run;
        QVERIFY(run.start({"--csv", "a.csv", "--record", "a.ripstop-run", "--json"}, 100000));
        QVERIFY(!QFile::exists(run.path("a.csv")));
        QCOMPARE(run.end(signal), 128 + signal);
        QCOMPARE(namesIn(run.folder.path()), QStringList({"a.csv", "a.ripstop-run"}));
        const QByteArray table = contentOf(run.path("a.csv"));
        QVERIFY(table.contains("\n# end; state at ") && table.endsWith('\n'));
        const auto recording = openRecording(run.path("a.ripstop-run").toStdString());
        QVERIFY(bool(recording));
        QVERIFY(recording->damage.empty());
        const QJsonObject said =
            QJsonDocument::fromJson(run.process.readAllStandardOutput()).object();
        QVERIFY(said["interrupted"].toBool());
        const std::int64_t steps = recording->recording->lastStep();
        QCOMPARE(double(steps), said["steps"].toDouble());
    }

    // timeout sends its signal twice at once; only a person presses Ctrl-C again.
    void aSignalThatComesTwiceIsOne()
    {
        EndlessRun run;
        QVERIFY(run.start({"--csv", "a.csv"}, 5000));
        ::kill(pid_t(run.process.processId()), SIGINT);
        QCOMPARE(run.end(SIGINT), 130);
        QCOMPARE(namesIn(run.folder.path()), QStringList{"a.csv"});
    }

    void anExportThatIsEndedLeavesNothing()
    {
        const QTemporaryDir folder;
        QProcess process;
        process.setWorkingDirectory(folder.path());
        process.start(CLI_PROGRAM, {"export", scene("rope"), "-o", "a.pvd", "--to", "100000"});
        QVERIFY(QTest::qWaitFor([&] { return !namesIn(folder.filePath("a")).isEmpty(); }, 60000));
        ::kill(pid_t(process.processId()), SIGTERM);
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 143);
        QCOMPARE(namesIn(folder.path()), QStringList());
    }

    // --- recordings that grow --------------------------------------------------------------------

    void aKilledRunLeavesItsRecording()
    {
        EndlessRun run;
        QVERIFY(run.start({"--record", "a.ripstop-run"}, 300000));
        QCOMPARE(run.end(SIGKILL), -SIGKILL);
        const QStringList left = namesIn(run.folder.path());
        QCOMPARE(left.size(), 1);
        QVERIFY2(left.first().startsWith("a.ripstop-run.")
                     && left.first().endsWith(".part.ripstop-run"),
                 qPrintable(left.first()));
        const Outcome replayed = call({"run", "--replay", run.path(qPrintable(left.first()))});
        QVERIFY2(replayed.error.contains("is cut off after")
                     && replayed.out.contains("the same bits in every step"),
                 qPrintable(replayed.error));

        // it stays until a whole one has come
        const QStringList again{"run", scene("rope"), "--seconds",
                                "0.1", "--record",    run.path("a.ripstop-run")};
        QCOMPARE(call(again + QStringList{"--csv", "/nowhere/a.csv"}).exitCode, 1);
        QCOMPARE(namesIn(run.folder.path()), left);
        QCOMPARE(call(again).exitCode, 0);
        QCOMPARE(namesIn(run.folder.path()), QStringList{"a.ripstop-run"});
    }

    // The same bytes as when all is saved at the end, but for what is said about it.
    void whatGrowsIsWhatIsSaved()
    {
        const QTemporaryDir folder;
        const std::string grown = folder.filePath("a.ripstop-run").toStdString();
        QCOMPARE(call({"run", scene("split_sheet"), "--seconds", "2", "--record",
                       folder.filePath("a.ripstop-run")})
                     .exitCode,
                 0);
        const auto opened = openRecording(grown);
        QVERIFY(bool(opened));
        QVERIFY(opened->recording->chunkCount() > 2);
        const std::string saved = folder.filePath("b.ripstop-run").toStdString();
        QVERIFY(!saveRecording(*opened->recording, saved));
        QCOMPARE(contentOf(QString::fromStdString(grown)),
                 contentOf(QString::fromStdString(saved)));
    }
};

const RegisteredTest registered("test_whole_files", runWithCore<TestWholeFiles>);

} // namespace ripstop::test_whole_files
#include "test_whole_files.moc"
