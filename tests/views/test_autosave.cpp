// Copies of unsaved work and their recovery (document/autosave.h, document/rescue.h).
//
// Stages: what is kept and what is forgotten while a program lives; then this program starts
// itself with --crash-in, changes a scene and is killed, and the copy that it left is recovered;
// then copies that are older than the file or damaged, folders that cannot be written, and files
// that another program has changed. Folders are temporary.
#include "document/autosave.h"
#include "document/document.h"
#include "document/follower.h"
#include "document/rescue.h"
#include "registered_test.h"
#include "small_scenes.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <filesystem>

namespace ripstop::test_autosave {

namespace {

constexpr int soon = 10; // ms
constexpr const char* crashing = "--crash-in";

// An editor without a window.
struct Desk
{
    Document document;
    Follower follower{document};
    Autosave autosave;

    explicit Desk(const QString& folder)
        : autosave(document, follower, folder, soon)
    {}

    bool change(double mass)
    {
        QSignalSpy kept(&autosave, &Autosave::kept);
        document.push(setValue(document.scene(), Id{3}, "mass", mass));
        return kept.wait(10000);
    }
};

// What the killed program does: it opens a file, changes it, keeps a copy, and kills itself.
[[noreturn]] void crash(const QString& folder)
{
    Desk desk(folder);
    if (desk.document.open(folder + "/sheet.ripstop.json") || !desk.change(0.7))
        std::_Exit(1);
    std::raise(SIGKILL);
    std::_Exit(1);
}

QStringList filesIn(const QString& folder) { return QDir(folder).entryList(QDir::Files); }

} // namespace

class TestAutosave : public QObject
{
    Q_OBJECT

private slots:
    void keepsWhatHasNoFileYet()
    {
        const QTemporaryDir folder;
        Desk desk(folder.path());
        desk.document.replace(fallingPair(), "sketch");
        QVERIFY(desk.change(0.3));
        // its program still runs, so it is not left behind
        QVERIFY(leftBehind(folder.path()).isEmpty());
        const QStringList copies = QDir(folder.path()).entryList({"*.ripstop.json"});
        QCOMPARE(copies.size(), 1);
        Document copy;
        QVERIFY(!copy.open(folder.filePath(copies.first())));
        QVERIFY(copy.scene() == desk.document.scene());
    }

    void forgetsWhatIsSavedOrTakenBack()
    {
        const QTemporaryDir folder;
        const QTemporaryDir saved;
        Desk desk(folder.path());
        desk.document.replace(fallingPair(), "sketch");
        QVERIFY(desk.change(0.3));
        QVERIFY(!desk.document.save(saved.filePath("a.ripstop.json")));
        QCOMPARE(filesIn(folder.path()), QStringList());
        QVERIFY(desk.change(0.4));
        QVERIFY(!filesIn(folder.path()).isEmpty());
        desk.document.history().undo(); // back to what was saved
        QCOMPARE(filesIn(folder.path()), QStringList());
    }

    void leavesNothingWhenTheProgramEnds()
    {
        const QTemporaryDir folder;
        {
            Desk desk(folder.path());
            desk.document.replace(fallingPair(), "sketch");
            QVERIFY(desk.change(0.3));
        }
        QCOMPARE(filesIn(folder.path()), QStringList());
    }

    // Told to end, a program neither asks nor waits for the next copy.
    void leavesWhatIsNotSavedWhenToldToEnd()
    {
        const QTemporaryDir folder;
        Scene changed;
        {
            Document document;
            Follower follower{document};
            constexpr int never = 1000000; // ms
            Autosave autosave(document, follower, folder.path(), never);
            document.replace(fallingPair(), "sketch");
            document.push(setValue(document.scene(), Id{3}, "mass", 0.3));
            changed = document.scene();
            autosave.leave();
        }
        const QList<Rescue> found = leftBehind(folder.path());
        QCOMPARE(found.size(), 1);
        QCOMPARE(found.first().title, QString("sketch"));
        Document next;
        QVERIFY(!next.open(found.first().place.scene()));
        QVERIFY(next.scene() == changed);
    }

    void recoversWhatAKilledProgramLeft()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("sheet.ripstop.json");
        Document original;
        original.replace(fallingPair(), "sheet");
        QVERIFY(!original.save(file));
        const QString unsaved = folder.path();
        QProcess program;
        program.start(QCoreApplication::applicationFilePath(),
                      {"test_autosave", crashing, unsaved});
        QVERIFY(program.waitForFinished(30000));
        QCOMPARE(program.exitStatus(), QProcess::CrashExit);

        QList<Rescue> found = leftBehind(unsaved);
        found.removeIf([](const Rescue& rescue) { return rescue.place.name == "sheet"; });
        QCOMPARE(found.size(), 1);
        QCOMPARE(found.first().file, file);
        QCOMPARE(found.first().title, QString("sheet.ripstop.json"));
        QVERIFY(!found.first().isOlderThanFile());

        Desk desk(unsaved);
        QVERIFY(!desk.autosave.recover(found.first()));
        QCOMPARE(desk.document.file(), file);
        QVERIFY(desk.document.isModified());
        Scene expected = original.scene();
        (void)apply(expected, setValue(expected, Id{3}, "mass", 0.7));
        QVERIFY(desk.document.scene() == expected);
        QVERIFY(QFile::exists(found.first().place.scene())); // until it is saved
        QVERIFY(!desk.document.save(file));
        QVERIFY(!QFile::exists(found.first().place.scene()));
    }

    void saysWhenTheCopyIsTheOlderOne()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("a.json");
        QFile written(file);
        QVERIFY(written.open(QIODevice::WriteOnly));
        const Rescue rescue{{}, file, "a", QDateTime::currentDateTime().addSecs(-60)};
        QVERIFY(rescue.isOlderThanFile());
    }

    void keepsADamagedCopyAndTheOpenScene()
    {
        const QTemporaryDir folder;
        const RescuePlace place{folder.path(), "broken"};
        QFile file(place.scene());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{ \"format\": ") > 0);
        file.close();
        Desk desk(folder.path());
        desk.document.replace(fallingPair(), "sketch");
        const QList<Rescue> found = leftBehind(folder.path());
        QCOMPARE(found.size(), 1);
        const auto failure = desk.autosave.recover(found.first());
        QVERIFY(failure);
        QVERIFY(failure->message.english().find("broken") != std::string::npos);
        QVERIFY(desk.document.scene() == fallingPair());
        QVERIFY(QFile::exists(place.scene()));
    }

    void saysOnceWhyNothingIsKept()
    {
        const QTemporaryDir folder;
        QFile inTheWay(folder.filePath("unsaved"));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        Desk desk(folder.filePath("unsaved"));
        QSignalSpy failed(&desk.autosave, &Autosave::failed);
        desk.document.replace(fallingPair(), "sketch");
        QVERIFY(failed.wait(10000));
        desk.document.push(setValue(desk.document.scene(), Id{3}, "mass", 0.5));
        QTest::qWait(10 * soon);
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed.first().first().toString().contains("unsaved"));
    }

    void knowsThatAnotherProgramWroteTheFile()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("a.ripstop.json");
        Document document;
        document.replace(fallingPair(), "a");
        QVERIFY(!document.isOlderThanFile());
        QVERIFY(!document.save(file));
        QVERIFY(!document.isOlderThanFile());
        const std::filesystem::path path(file.toStdU16String());
        std::filesystem::last_write_time(path, std::filesystem::last_write_time(path)
                                                   + std::chrono::seconds(5));
        QVERIFY(document.isOlderThanFile());
        QVERIFY(!document.open(file));
        QVERIFY(!document.isOlderThanFile());
    }
};

static int run(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    if (application.arguments().value(1) == crashing)
        crash(application.arguments().value(2));
    TestAutosave test;
    return QTest::qExec(&test, argc, argv);
}

const RegisteredTest registered("test_autosave", run);

} // namespace ripstop::test_autosave
#include "test_autosave.moc"
