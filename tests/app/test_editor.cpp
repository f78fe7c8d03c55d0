// The editor as a whole: the window by keys and actions, and the program by its command line.
//
// Stages: Editor is a window without a remembered layout; it plays, edits, deletes, saves and
// exports by the keys and actions of a person. Then the program itself is started: its frames are
// compared with those of ripstop-cli by their bits, pictures, help without a display, and refusals
// by their exit codes. At the end the verification dialog, its failures and its closing while
// cases run.
#include "dialogs/result_page.h"
#include "dialogs/verification_dialog.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "editor/options.h"
#include "files/export_dialog.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"

#include "base/hash_text.h"
#include "compile/compile.h"
#include "io/scene_file.h"
#include "scene/path.h"
#include "simulation/simulation.h"
#include "verify/case.h"
#include "verify/reference.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QProcess>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>

namespace ripstop::test_editor {

namespace {

const QString samples = QStringLiteral(SCENES_DIR "/");

struct Finished
{
    int exitCode = -1;
    QString output;
    QString error;
};

Finished run(const QString& program, const QStringList& arguments,
             const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment())
{
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    if (!process.waitForFinished(120000))
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

QProcessEnvironment withoutDisplay()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(name);
    return environment;
}

// A window as a user has it, but without a remembered layout.
struct Editor
{
    Document document;
    Selection selection{document};
    Player player{document};
    MainWindow window{document, selection, player, MainWindow::Memory::Ignore};

    explicit Editor(const QString& sample = {})
    {
        window.show();
        QApplication::setActiveWindow(&window); // Xvfb has no window manager to do it
        if (!sample.isEmpty())
            window.files().open(samples + sample + ".ripstop.json");
    }

    bool isReady() const { return player.frame() != nullptr; }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(&window.viewport(), key, modifiers);
    }
};

} // namespace

class TestEditor : public QObject
{
    Q_OBJECT

private slots:
    void spacePlaysAndPauses()
    {
        Editor editor("delta_kite");
        QVERIFY(QTest::qWaitForWindowExposed(&editor.window));
        QTRY_VERIFY(editor.isReady());
        editor.press(Qt::Key_Space);
        QVERIFY(editor.player.isPlaying());
        QTRY_VERIFY(editor.player.frame()->time > 0.1);
        editor.press(Qt::Key_Space);
        QVERIFY(!editor.player.isPlaying());
        editor.press(Qt::Key_R, Qt::ControlModifier);
        QTRY_COMPARE(editor.player.frame()->time, 0.0);
    }

    // The hand that holds the line goes back against the wind, which blows towards +x: Down is
    // 0.25 m each time.
    void keysDriveControls()
    {
        Editor editor("delta_kite");
        QVERIFY(QTest::qWaitForWindowExposed(&editor.window));
        QTRY_VERIFY(editor.isReady());
        editor.player.play();
        QTRY_VERIFY(editor.player.frame()->time > 0.0);
        editor.press(Qt::Key_Down);
        editor.press(Qt::Key_Down);
        QTRY_COMPARE(editor.player.frame()->inputValue.at(0), 0.5);
        QTRY_COMPARE(editor.player.frame()->inputValue.at(1), 0.0);
        editor.press(Qt::Key_Up);
        QTRY_COMPARE(editor.player.frame()->inputValue.at(0), 0.25);
    }

    void editsReachTheRunAndAreUndone()
    {
        Editor editor("delta_kite");
        QTRY_VERIFY(editor.isReady());
        QVERIFY(!editor.window.actions()["undo"]->isEnabled());
        const Scene before = editor.document.scene();
        editor.player.play();
        QTRY_VERIFY(editor.player.frame()->time > 0.05);
        const auto edit = assignment(before, "wind.velocity=9,0,0");
        QVERIFY(edit);
        const auto generation = editor.player.frame()->generation;
        editor.document.push(*edit);
        QTRY_VERIFY(editor.player.frame()->generation > generation);
        QVERIFY(editor.player.frame()->time > 0.05); // not started over
        QVERIFY(editor.window.actions()["undo"]->isEnabled());
        QVERIFY(editor.window.isWindowModified());
        editor.window.actions()["undo"]->trigger();
        QVERIFY(editor.document.scene() == before);
        QVERIFY(!editor.window.isWindowModified());
        QVERIFY(editor.window.actions()["redo"]->isEnabled());
    }

    void deletesWhatIsSelectedAndBringsItBack()
    {
        Editor editor("cloth");
        const Scene before = editor.document.scene();
        QVERIFY(!editor.window.actions()["delete"]->isEnabled());
        editor.window.actions()["selectAll"]->trigger();
        editor.window.actions()["delete"]->trigger();
        forEachPart(editor.document.scene(), [](Id, const Part& part) {
            QVERIFY(part.particles.empty() && part.links.empty() && part.panels.empty());
        });
        editor.window.actions()["undo"]->trigger();
        QVERIFY(editor.document.scene() == before);
    }

    void everyActionHasATextATipAndAKeyOfItsOwn()
    {
        Editor editor;
        QSet<QString> keys;
        for (const QAction* action : editor.window.actions().all()) {
            QVERIFY(!action->text().isEmpty());
            QVERIFY2(action->statusTip().endsWith('.'), qPrintable(action->text()));
            const QString key = action->shortcut().toString();
            QVERIFY2(key.isEmpty() || !keys.contains(key), qPrintable(key));
            keys.insert(key);
        }
    }

    void savesAndOpensAgain()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath("my kite.ripstop.json");
        Editor editor("delta_kite");
        const Scene before = editor.document.scene();
        QVERIFY(!editor.document.save(file));
        Editor other;
        QVERIFY(other.window.files().open(file));
        QVERIFY(other.document.scene() == before);
        QCOMPARE(other.window.windowTitle(), QString("my kite.ripstop.json[*] – Ripstop"));
    }

    // The table of what tore is that of the run on the screen.
    void exportsWhatHasTorn()
    {
        const Result<Scene> scene = readScene((samples + "tear_test.ripstop.json").toStdString());
        Simulation simulation(*compile(*scene));
        QVERIFY(simulation.runUntil(3.05));
        const auto frame = simulation.frame();
        QVERIFY(!frame->tears.empty());
        QTemporaryDir folder;
        ExportDialog dialog({*scene, frame}, folder.filePath("strip"), {}, QSize(640, 480),
                            nullptr);
        auto* format = dialog.findChild<QComboBox*>();
        format->setCurrentIndex(format->findText("Table of what has torn, CSV"));
        QCOMPARE(dialog.target(), folder.filePath("strip_tears.csv"));
        dialog.findChild<QDialogButtonBox*>()->accepted();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        QFile table(dialog.target());
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = table.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(1 + frame->tears.size()));
        QVERIFY(lines[0].startsWith("time (s),element"));
    }

    // For the same scene and the same seconds the window ends in the same bits as the command line.
    void windowAndCommandLineAgree_data()
    {
        QTest::addColumn<QString>("sample");
        for (const char* name : {"delta_kite", "hang_glider", "cloth", "pendulum"})
            QTest::newRow(name) << QString(name);
    }

    void windowAndCommandLineAgree()
    {
        QFETCH(QString, sample);
        const QString file = samples + sample + ".ripstop.json";
        Editor editor(sample);
        editor.player.playUntil(0.7);
        QTRY_VERIFY_WITH_TIMEOUT(editor.isReady() && !editor.player.isPlaying(), 60000);

        const Finished done = run(CLI_PROGRAM, {"run", file, "--seconds", "0.7", "--json"});
        QCOMPARE(done.exitCode, 0);
        const QJsonObject json = QJsonDocument::fromJson(done.output.toUtf8()).object();
        QCOMPARE(QString::fromStdString(hashText(editor.player.frame()->hash)),
                 json["hash"].toString());
    }

    void takesPicturesFromTheCommandLine()
    {
        QTemporaryDir folder;
        const QString picture = folder.filePath("kite.png");
        const Finished done =
            run(EDITOR_PROGRAM, {samples + "delta_kite.ripstop.json", "--screenshot", picture,
                                 "--after", "0.5", "--size", "900x600", "--theme", "dark"});
        QVERIFY2(done.exitCode == 0, qPrintable(done.error));
        QVERIFY(done.output.contains("step 120"));
        const QImage image(picture);
        QCOMPARE(image.size(), QSize(900, 600));
    }

    // What the program has recorded is opened as it is from the menu, and looked back at.
    void opensARecordingFromTheCommandLine()
    {
        const QTemporaryDir folder;
        const QString recording = folder.filePath("rope.ripstop-run");
        const Finished flown = run(CLI_PROGRAM, {"run", samples + "rope.ripstop.json", "--seconds",
                                                 "0.5", "--record", recording, "--json"});
        QVERIFY2(flown.exitCode == 0, qPrintable(flown.error));
        const QString hash =
            QJsonDocument::fromJson(flown.output.toUtf8()).object()["hash"].toString();
        QVERIFY(!hash.isEmpty());
        const QString picture = folder.filePath("rope.png");
        const Finished done = run(EDITOR_PROGRAM, {recording, "--screenshot", picture, "--after",
                                                   "0.5", "--dock", "plots", "--size", "900x600"});
        QVERIFY2(done.exitCode == 0, qPrintable(done.error));
        QVERIFY2(done.output.contains(hash), qPrintable(done.output + hash));
        QCOMPARE(QImage(picture).size(), QSize(900, 600));
    }

    void takesPicturesForPapersFromTheCommandLine()
    {
        QTemporaryDir folder;
        const QString picture = folder.filePath("kite.png"), drawing = folder.filePath("kite.svg");
        const Finished done =
            run(EDITOR_PROGRAM, {samples + "delta_kite.ripstop.json", "--screenshot", picture,
                                 "--picture-width", "1500", "--backdrop", "transparent"});
        QVERIFY2(done.exitCode == 0, qPrintable(done.error));
        const QImage image(picture);
        QCOMPARE(image.width(), 1500);
        QCOMPARE(image.pixelColor(5, 5).alpha(), 0);
        const Finished drawn =
            run(EDITOR_PROGRAM, {samples + "delta_kite.ripstop.json", "--screenshot", drawing,
                                 "--legend", "--color-by", "tension", "--backdrop", "white"});
        QVERIFY2(drawn.exitCode == 0, qPrintable(drawn.error));
        QFile file(drawing);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("<text"));
    }

    // Shaders and files are written with a point, whatever the session's numbers have.
    void drawsTheSameInASessionWithCommas()
    {
        const QTemporaryDir folder;
        const Finished made =
            run("localedef", {"-i", "fr_FR", "-f", "UTF-8", folder.filePath("fr_FR.UTF-8")});
        QVERIFY2(made.exitCode == 0, qPrintable(made.error));
        const auto pictureIn = [&](const QString& locale) {
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert("LOCPATH", folder.path());
            environment.insert("LC_ALL", locale);
            const QString picture = folder.filePath(locale + ".png");
            const Finished done =
                run(EDITOR_PROGRAM,
                    {samples + "delta_kite.ripstop.json", "--screenshot", picture, "--after", "0.1",
                     "--view-only", "--size", "640x320", "--language", "en"},
                    environment);
            return done.exitCode == 0 && done.error.isEmpty() ? QImage(picture) : QImage();
        };
        const QImage french = pictureIn("fr_FR.UTF-8");
        QVERIFY(!french.isNull());
        QCOMPARE(french, pictureIn("C.UTF-8"));
    }

    void helpsWithoutADisplay()
    {
        const Finished help = run(EDITOR_PROGRAM, {"--help"}, withoutDisplay());
        QCOMPARE(help.exitCode, 0);
        QVERIFY(help.output.contains("--screenshot"));
        const Finished version = run(EDITOR_PROGRAM, {"--version"}, withoutDisplay());
        QCOMPARE(version.exitCode, 0);
        QVERIFY(version.output.startsWith("Ripstop "));
    }

    void saysThatThereIsNoOpenGl_data()
    {
        QTest::addColumn<QString>("platform"); // of Qt; empty for its own choice
        QTest::addColumn<bool>("display");
        QTest::addColumn<QStringList>("variables");
        QTest::addColumn<QString>("reason");
        const QStringList none;
        QTest::newRow("no display") << "" << false << none << "no display for the window: could";
        QTest::newRow("no such platform")
            << "attic" << false << none << "Could not find the Qt platform plugin \"attic\"";
        QTest::newRow("off screen") << "offscreen" << false << none << "\"offscreen\" has no";
        QTest::newRow("off screen beside a display")
            << "offscreen" << true << none << "\"offscreen\" has no OpenGL 3.2";
        QTest::newRow("a display without OpenGL")
            << "xcb" << true << QStringList{"QT_XCB_GL_INTEGRATION=none"} << "\"xcb\" has no";
        QTest::newRow("an old OpenGL")
            << "xcb" << true << QStringList{"MESA_GL_VERSION_OVERRIDE=2.1"} << "\"xcb\" has no";
    }

    // One sentence in place of a core dump: what is missing and what one can do.
    void saysThatThereIsNoOpenGl()
    {
        QFETCH(QString, platform);
        QFETCH(bool, display);
        QFETCH(QStringList, variables);
        QFETCH(QString, reason);
        QProcessEnvironment environment =
            display ? QProcessEnvironment::systemEnvironment() : withoutDisplay();
        if (display && environment.value("DISPLAY").isEmpty())
            return; // somebody tests on Wayland alone
        if (!platform.isEmpty())
            environment.insert("QT_QPA_PLATFORM", platform);
        for (const QString& one : variables)
            environment.insert(one.section('=', 0, 0), one.section('=', 1));
        const QTemporaryDir folder;
        const QString picture = folder.filePath("rope.png");
        const Finished done = run(
            EDITOR_PROGRAM, {samples + "rope.ripstop.json", "--screenshot", picture}, environment);
        QCOMPARE(done.exitCode, 8);
        QVERIFY2(done.error.contains(reason), qPrintable(done.error));
        QVERIFY2(done.error.contains("xvfb-run"), qPrintable(done.error));
        QCOMPARE(done.error.count('\n'), 1);
        QVERIFY(!QFile::exists(picture));
    }

    void refusesWhatItCannotDo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("exitCode");
        QTest::addColumn<QString>("message");
        QTest::newRow("no such file")
            << QStringList{"nowhere.ripstop.json"} << 1 << QString("nowhere.ripstop.json");
        QTest::newRow("not a scene")
            << QStringList{SOURCE_DIR "/LICENSE"} << 1 << QString("LICENSE");
        QTest::newRow("no such recording")
            << QStringList{"nowhere.ripstop-run"} << 1 << QString("nowhere.ripstop-run");
        QTest::newRow("bad time") << QStringList{"--after", "soon"} << 2 << QString("--after");
        QTest::newRow("bad size") << QStringList{"--size", "big"} << 2 << QString("--size");
        QTest::newRow("bad width")
            << QStringList{"--picture-width", "8"} << 2 << QString("--picture-width");
        QTest::newRow("bad backdrop")
            << QStringList{"--backdrop", "sea"} << 2 << QString("--backdrop");
        QTest::newRow("two scenes") << QStringList{"a", "b"} << 2 << QString("one scene");
        QTest::newRow("bad theme") << QStringList{"--theme", "pink"} << 2 << QString("--theme");
        QTest::newRow("no such dock") << QStringList{"--dock", "attic"} << 1 << QString("attic");
        QTest::newRow("picture nowhere")
            << QStringList{"--screenshot", "/nowhere/a.png"} << 1 << QString("/nowhere/a.png");
    }

    void refusesWhatItCannotDo()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, exitCode);
        QFETCH(QString, message);
        const Finished done = run(EDITOR_PROGRAM, arguments);
        QCOMPARE(done.exitCode, exitCode);
        QVERIFY2(done.error.contains(message), qPrintable(done.error));
    }

    // Help > Verification runs the cases of the command line while the window goes on.
    void verification()
    {
        VerificationDialog dialog(nullptr);
        ResultPage& cases = dialog.cases();
        cases.setFilter("T-K5");
        cases.start();
        QVERIFY(cases.isRunning());
        QTRY_VERIFY(!cases.isRunning());
        QCOMPARE(cases.done(), int(casesWith("T-K5").size()));
        QCOMPARE(cases.failed(), 0);
        const QStringList lines = cases.text(',').split('\n');
        QCOMPARE(lines[0], "Section,Result,Id,Case,Expected,Got,Unit,Tolerance,Source");
        QCOMPARE(lines.filter("Rods,holds,T-K5,").size(), cases.done());

        cases.setFilter({});
        cases.start();
        QTRY_VERIFY(cases.done() > 0);
        cases.cancel();
        QTRY_VERIFY(!cases.isRunning());
        QVERIFY(cases.done() < int(allCases().size()));
        cases.start(); // and what runs is let go of when the dialog goes

        ResultPage& references = dialog.references();
        references.setFilter("head on");
        references.start();
        QTRY_VERIFY(!references.isRunning());
        QCOMPARE(references.done(), int(referencesWith("head on").size()));
    }

    // A failure that comes while only failures are shown is shown; the table is made once for the
    // first start.
    void failuresThatComeLaterAreSeen()
    {
        int made = 0;
        ResultPage page([&made] {
            ++made;
            ResultTable table;
            table.columns = {{"Result", 80}, {"Case", 80}};
            table.rows = {{"Section", {"", "good"}}, {"Section", {"", "bad"}}};
            table.compute = [](int row) -> ResultTable::Outcome {
                QThread::msleep(50);
                return {{}, row == 0};
            };
            return table;
        });
        page.start();
        QCOMPARE(made, 1);
        page.findChild<QCheckBox*>()->setChecked(true);
        QTRY_VERIFY(!page.isRunning());
        const QTreeWidgetItem* section = page.findChild<QTreeWidget*>()->topLevelItem(0);
        QVERIFY(!section->isHidden());
        QVERIFY(section->child(0)->isHidden());
        QVERIFY(!section->child(1)->isHidden());
        page.start();
        QCOMPARE(made, 2);
    }

    // The window does not wait for the case that is under way.
    void closesWhileCasesRun()
    {
        QPointer<VerificationDialog> dialog = new VerificationDialog(nullptr);
        dialog->show();
        dialog->references().start(); // seconds each
        dialog->close();
        QVERIFY(dialog && !dialog->isVisible());
        QVERIFY(dialog->references().isRunning()); // so that it was not waited for
        QTRY_VERIFY_WITH_TIMEOUT(!dialog, 60000);
    }

    void verificationIsInTheMenu()
    {
        Editor editor("pendulum");
        QVERIFY(QTest::qWaitForWindowExposed(&editor.window));
        editor.window.actions()["verification"]->trigger();
        const auto dialogs = QApplication::topLevelWidgets();
        QVERIFY(std::any_of(dialogs.begin(), dialogs.end(), [](QWidget* widget) {
            return qobject_cast<VerificationDialog*>(widget) && widget->isVisible();
        }));
    }
};

const RegisteredTest registered("test_editor", runWithView<TestEditor>);

} // namespace ripstop::test_editor
#include "test_editor.moc"
