// What a person does to select, in the whole window: menu, keys, strip, dialog, status bar.
//
// Stages: menu and keys choose tools and selections; switches say what the mouse takes; groups and
// the dialog of conditions; the status bar; and the time for selections on 100 000 particles.
#include "builders/builder.h"
#include "dialogs/condition_dialog.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "select/elements.h"
#include "tools/pointing.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"

#include <QAction>
#include <QComboBox>
#include <QElapsedTimer>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QStatusBar>
#include <QtTest>

namespace ripstop::test_select_menu {

namespace {

// A sheet of 8 x 8 cells in the window of a person, without their remembered layout.
struct Editor
{
    Document document;
    Selection selection{document};
    Player player{document};
    MainWindow window{document, selection, player, MainWindow::Memory::Ignore};

    explicit Editor(double cells = 8.0)
    {
        window.show();
        QApplication::setActiveWindow(&window); // Xvfb has no window manager to do it
        document.replace(
            *build(*findBuilder("cloth"), {{"columns", cells}, {"rows", cells}, {"sphere", 0.0}}),
            "sheet");
        window.showScene();
    }
    void trigger(const char* id) { window.actions()[id]->trigger(); }
    bool isChecked(const char* id) { return window.actions()[id]->isChecked(); }
    std::size_t count() const { return selection.ids().size(); }

    // As it stands on the screen.
    static QString seen(QString text)
    {
        return text.replace("&&", "\n").remove('&').replace('\n', '&');
    }
    // The entry of a menu of the Select menu that is filled when it opens.
    QAction* entry(const QString& title, const QString& name)
    {
        QList<QMenu*> menus;
        for (QAction* action : window.menuBar()->actions())
            if (action->menu())
                for (QAction* inner : action->menu()->actions())
                    if (inner->menu() && inner->text().remove('&') == title)
                        menus << inner->menu();
        if (menus.size() != 1)
            return nullptr;
        emit menus.first()->aboutToShow();
        for (QAction* action : menus.first()->actions())
            if (seen(action->text()) == name)
                return action;
        return nullptr;
    }
    QString status()
    {
        QString text;
        for (QLabel* label : window.statusBar()->findChildren<QLabel*>())
            text += label->text() + '\n';
        return text;
    }
    bool statusSays(const QString& text) { return status().contains(text); }
};

// Types into the next question and answers it.
void answerNextQuestion(const QString& text)
{
    QTimer::singleShot(0, qApp, [text] {
        auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        dialog->setTextValue(text);
        dialog->accept();
    });
}

} // namespace

class TestSelectMenu : public QObject
{
    Q_OBJECT

private slots:
    void theMenuSelects()
    {
        Editor editor;
        QVERIFY(!editor.window.actions()["grow"]->isEnabled()); // nothing to grow from
        editor.trigger("allParticles");
        QCOMPARE(editor.count(), std::size_t(9 * 9));
        QVERIFY(editor.window.actions()["grow"]->isEnabled());
        editor.trigger("boundary");
        editor.trigger("toParticles");
        QCOMPARE(editor.count(), std::size_t(4 * 8));
        editor.trigger("invert");
        QCOMPARE(editor.count(), std::size_t(7 * 7));
        editor.trigger("shrink");
        QCOMPARE(editor.count(), std::size_t(5 * 5));
        editor.trigger("grow");
        editor.trigger("toPanels");
        QVERIFY(editor.count() > 2 * 4 * 4 && editor.count() <= 2 * 6 * 6);
        editor.trigger("likeMaterial");
        QCOMPARE(editor.count(), std::size_t(2 * 8 * 8));
        editor.trigger("connected");
        QCOMPARE(editor.selection.ids(), everyElement(editor.document.scene()).ids());
        editor.trigger("allPinned");
        QCOMPARE(editor.count(), std::size_t(2)); // two corners
        editor.trigger("allRods");                // there are none: the selection stays
        QCOMPARE(editor.count(), std::size_t(2));
        editor.trigger("shrink"); // shrinking leaves nothing
        QCOMPARE(editor.count(), std::size_t(0));
        editor.trigger("selectAll");
        editor.trigger("deselect");
        QCOMPARE(editor.count(), std::size_t(0));
        QVERIFY(!editor.document.history().canUndo()); // selecting is no edit
    }

    void keysChooseToolsAndEscapeLeavesThem()
    {
        Editor editor;
        editor.window.viewport().setFocus();
        QTest::keyClick(&editor.window.viewport(), Qt::Key_B);
        QVERIFY(editor.isChecked("toolBox") && editor.window.viewport().pointing().hasTool());
        QTest::keyClick(&editor.window.viewport(), Qt::Key_L);
        QVERIFY(editor.isChecked("toolLasso") && !editor.isChecked("toolBox"));
        editor.trigger("selectAll");
        QTest::keyClick(&editor.window.viewport(), Qt::Key_Escape);
        QVERIFY(editor.isChecked("toolPointer"));
        QVERIFY(editor.count() > 0); // that was the tool's
        QTest::keyClick(&editor.window.viewport(), Qt::Key_Escape);
        QCOMPARE(editor.count(), std::size_t(0));
    }

    void switchesSayWhatTheMouseTakes()
    {
        Editor editor;
        const ElementKinds& wanted = editor.window.viewport().pointing().pickable.wanted;
        editor.trigger("takeLinks");
        QVERIFY(wanted.particles && !wanted.links && wanted.panels);
        editor.trigger("takeLinks");
        QVERIFY(wanted.links);
    }

    void escapeInAnOpenListKeepsTheSelection()
    {
        Editor editor;
        editor.trigger("allPanels");
        const std::size_t selected = editor.count();
        QVERIFY(selected > 0);
        editor.selection.set({editor.selection.ids().front()});
        QComboBox* list = nullptr;
        for (QComboBox* any : editor.window.findChildren<QComboBox*>())
            if (any->isVisible() && any->count() > 1 && any->window() == &editor.window)
                list = any;
        QVERIFY(list);
        list->showPopup();
        QTRY_VERIFY(QApplication::activePopupWidget());
        QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
        QTRY_VERIFY(!QApplication::activePopupWidget());
        QCOMPARE(editor.count(), std::size_t(1));
        QTest::keyClick(&editor.window, Qt::Key_Escape);
        QCOMPARE(editor.count(), std::size_t(0));
    }

    void groupsAreNamedFilledAndEmptied()
    {
        Editor editor;
        const std::size_t before = editor.document.scene().items.size();
        editor.trigger("boundary");
        const std::vector<Id> edge = editor.selection.ids();
        answerNextQuestion("edge & seam");
        editor.trigger("group");
        QCOMPARE(editor.document.scene().items.size(), before + 1);
        const Id id = editor.document.scene().items.back().id;
        const auto members = [&] { return findItem<Group>(editor.document.scene(), id)->members; };
        QCOMPARE(members(), edge);
        QCOMPARE(editor.document.history().count(), 1);

        editor.trigger("allPanels");
        const std::vector<Id> panels = editor.selection.ids();
        QAction* add = editor.entry("Add to group", "edge & seam");
        QVERIFY(add);
        add->trigger();
        QCOMPARE(members().size(), edge.size() + panels.size());
        editor.entry("Add to group", "edge & seam")->trigger(); // they are in it: no step
        QCOMPARE(editor.document.history().count(), 2);
        editor.entry("Remove from group", "edge & seam")->trigger();
        QCOMPARE(members(), edge);
        editor.entry("By group", "edge & seam")->trigger();
        QCOMPARE(editor.selection.ids(), edge);

        for (int i = 0; i < 3; ++i)
            editor.document.history().undo();
        QCOMPARE(editor.document.scene().items.size(), before);
        QVERIFY(!editor.entry("By group", "edge & seam"));
    }

    void conditionsCountAndExplain()
    {
        Editor editor;
        QTRY_VERIFY(editor.player.frame());
        ConditionDialog dialog(
            editor.document, editor.selection, [&] { return editor.window.viewport().frame(); },
            &editor.window);
        dialog.show();
        dialog.setCondition("pinned");
        QVERIFY2(dialog.verdict().startsWith("2 particles"), qPrintable(dialog.verdict()));
        dialog.setCondition("strain > 5 %");
        QCOMPARE(dialog.verdict(), QString("Nothing matches now."));
        dialog.setCondition("mas < 1 g");
        QVERIFY2(dialog.verdict().contains("At character 1") && dialog.verdict().contains("mass"),
                 qPrintable(dialog.verdict()));
        // the flat sheet lies at one height, 1.6 m
        dialog.setCondition("particle.y > 150 cm");
        QVERIFY2(dialog.verdict().startsWith("81 particles"), qPrintable(dialog.verdict()));
        dialog.setCondition("particle.y > 1.7 m");
        QCOMPARE(dialog.verdict(), QString("Nothing matches now."));

        QTest::keyClicks(dialog.findChild<QLineEdit*>(), " and pinned");
        dialog.setCondition("pinned");
        QTest::keyClick(dialog.findChild<QLineEdit*>(), Qt::Key_Return);
        QCOMPARE(editor.count(), std::size_t(2));
    }

    void theStatusBarAddsUp()
    {
        Editor editor;
        editor.trigger("allPanels");
        QTRY_VERIFY(editor.statusSays("Selected: 128 panels"));
        QVERIFY2(editor.statusSays(QString("1%1m\u00b2").arg(QChar(0xa0))), // 1 m x 1 m
                 qPrintable(editor.status()));
        editor.trigger("allParticles");
        QTRY_VERIFY(editor.statusSays(QString("250%1g").arg(QChar(0xa0)))); // 0.25 kg/m^2
        editor.trigger("deselect");
        QTRY_VERIFY(!editor.statusSays("Selected"));
    }

    // How long the window takes for a selection on 100 000 particles, pictures aside.
    void largeSelectionsInTheWindow()
    {
        Editor editor(315.0);
        QElapsedTimer clock;
        const auto time = [&](const char* what, const auto& run) {
            qint64 best = std::numeric_limits<qint64>::max();
            for (int i = 0; i < 3; ++i) {
                editor.selection.clear();
                clock.start();
                run();
                best = std::min(best, clock.nsecsElapsed());
            }
            qInfo("%-20s %6.1f ms", what, 1e-6 * double(best));
        };
        const std::vector<Id> all = everyElement(editor.document.scene()).ids();
        const std::vector<Id> one{all[all.size() / 2]};
        time("one link", [&] { editor.selection.set(one); });
        time("all particles", [&] { editor.trigger("allParticles"); });
        time("everything", [&] { editor.trigger("selectAll"); });
        QCOMPARE(editor.count(), all.size());

        // what a rubber band costs each time it moves: the picture below it stays as it is
        QTRY_VERIFY_WITH_TIMEOUT(editor.player.frame(), 20000);
        QTest::qWait(300);
        editor.trigger("toolBox");
        Viewport& view = editor.window.viewport();
        const auto send = [&](QEvent::Type type, QPointF place) {
            QMouseEvent event(type, place, view.mapToGlobal(place), Qt::LeftButton, Qt::LeftButton,
                              {});
            QApplication::sendEvent(&view, &event);
            QApplication::processEvents();
        };
        send(QEvent::MouseButtonPress, {20, 20});
        send(QEvent::MouseMove, {60, 60});
        clock.start();
        for (int i = 0; i < 10; ++i)
            send(QEvent::MouseMove, {100.0 + 10.0 * i, 120.0});
        qInfo("%-20s %6.1f ms", "rubber band", 1e-7 * double(clock.nsecsElapsed()));
    }
};

const RegisteredTest registered("test_select_menu", runWithView<TestSelectMenu>);

} // namespace ripstop::test_select_menu
#include "test_select_menu.moc"
