// What helps to find one's way: palette, keys, tour, templates, and what the window remembers.
//
// Stages: the ranking of the palette and what it runs; keys that are changed, kept and reset; what
// the window remembers; the history; the tour; and templates. Settings are those of the test, and
// not of the user.
#include "actions/key_map.h"
#include "actions/keys_dialog.h"
#include "actions/palette.h"
#include "dialogs/rescue_dialog.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "editor/tour.h"
#include "files/templates.h"
#include "inspector/material_test_dialog.h"
#include "scene/path.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"

#include <QAction>
#include <QDockWidget>
#include <QHelpEvent>
#include <QInputDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolTip>
#include <QTreeWidget>
#include <QUndoView>
#include <QtTest>

namespace ripstop::test_finding {

namespace {

const QString samples = QStringLiteral(SCENES_DIR "/");

struct Editor
{
    Document document;
    Selection selection{document};
    Player player{document};
    MainWindow window;

    explicit Editor(MainWindow::Memory memory = MainWindow::Memory::Ignore)
        : window(document, selection, player, memory)
    {
        window.show();
        QApplication::setActiveWindow(&window); // Xvfb has no window manager to do it
    }
    QAction* action(const char* id) { return window.actions()[id]; }
};

// Types into the dialog that the action opens.
template <typename Dialog>
void inDialog(QAction* action, const std::function<void(Dialog&)>& work)
{
    bool seen = false;
    QTimer::singleShot(0, [&] {
        auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        seen = dialog != nullptr;
        if (dialog) {
            work(*dialog);
            dialog->close();
        }
    });
    action->trigger();
    QVERIFY(seen);
}

QTreeWidgetItem* rowOf(const QTreeWidget& table, const QString& name)
{
    const auto rows = table.findItems(name, Qt::MatchExactly | Qt::MatchRecursive, 1);
    return rows.isEmpty() ? nullptr : rows.first();
}

} // namespace

class TestFinding : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_home;

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("Ripstop"); // whose settings
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_home.path());
        qputenv("XDG_DATA_HOME", m_home.path().toUtf8());
    }
    void init() { QSettings().clear(); }

    void paletteWeighsWords_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("better");
        QTest::addColumn<QString>("worse");
        QTest::newRow("beginning before middle") << "sel"
                                                 << "Select all"
                                                 << "Fit selection";
        QTest::newRow("a word before a part of one") << "wind"
                                                     << "Show wind"
                                                     << "Unwinding";
        QTest::newRow("a whole word before a beginning") << "pin"
                                                         << "Pin or unpin"
                                                         << "Pinned particles";
        QTest::newRow("name before tip") << "mesh"
                                         << "Export mesh"
                                         << "Import";
        QTest::newRow("the name itself before one that begins so") << "reset"
                                                                   << "Reset"
                                                                   << "Reset layout";
        QTest::newRow("these words first before these words later") << "show wind"
                                                                    << "Show wind field"
                                                                    << "Show the wind";
        QTest::newRow("all words have to fit") << "show wind"
                                               << "Show wind field"
                                               << "Show panels";
    }
    void paletteWeighsWords()
    {
        QFETCH(QString, typed);
        QFETCH(QString, better);
        QFETCH(QString, worse);
        const QString tip = "What a mesh is for.";
        QVERIFY(Palette::fit(typed, better, "File", tip) > Palette::fit(typed, worse, "File", tip));
    }
    void paletteKnowsWhatDoesNotFit()
    {
        QCOMPARE(Palette::fit("zebra", "Show wind", "View", "Draw an arrow."), 0);
        QVERIFY(Palette::fit("", "Show wind", "View", "Draw an arrow.") > 0);
        QCOMPARE(Palette::fit("wind", "English", "Language", "The window in English."), 0);
        QVERIFY(Palette::fit("window", "English", "Language", "The window in English.") > 0);
        QVERIFY(Palette::fit("probe", "Table", "Tools", "What probes read.") > 0);
    }

    // Who types a name gets that action with Enter, and no other that begins so; words of other
    // programs lead to what these call so.
    void paletteTakesNamesAndWordsOfOthers_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("id");
        QTest::newRow("a name") << "reset"
                                << "reset";
        QTest::newRow("a name with an ellipsis") << "save picture"
                                                 << "picture";
        QTest::newRow("zoom") << "zoom"
                              << "fit";
        QTest::newRow("frame all") << "frame all"
                                   << "fit";
        QTest::newRow("frame selected") << "frame sel"
                                        << "fitSelected";
        QTest::newRow("screenshot") << "screenshot"
                                    << "picture";
        QTest::newRow("measure") << "measure"
                                 << "addProbe";
        QTest::newRow("stability") << "stability"
                                   << "dock.problems";
    }
    void paletteTakesNamesAndWordsOfOthers()
    {
        QFETCH(QString, typed);
        QFETCH(QString, id);
        Editor editor;
        QVERIFY(editor.window.files().open(samples + "cloth.ripstop.json"));
        editor.selection.set({editor.document.scene().items.back().id});
        inDialog<Palette>(editor.action("palette"), [&](Palette& palette) {
            QTest::keyClicks(palette.findChild<QLineEdit*>(), typed);
            QVERIFY(palette.chosen());
            QCOMPARE(palette.chosen()->objectName(), id);
        });
    }

    // The languages speak of the window, which is no wind.
    void paletteKeepsWordsWholeInTips()
    {
        Editor editor;
        inDialog<Palette>(editor.action("palette"), [&](Palette& palette) {
            QTest::keyClicks(palette.findChild<QLineEdit*>(), "wind");
            const auto* list = palette.findChild<QTreeWidget*>();
            QVERIFY(list->findItems("English", Qt::MatchStartsWith).isEmpty());
            QVERIFY(!list->findItems("Wind", Qt::MatchStartsWith).isEmpty());
        });
    }

    void paletteRunsWhatIsTyped()
    {
        Editor editor;
        QVERIFY(!editor.action("windField")->isChecked());
        inDialog<Palette>(editor.action("palette"), [](Palette& palette) {
            auto* typed = palette.findChild<QLineEdit*>();
            QTest::keyClicks(typed, "wind field");
            QTest::keyClick(typed, Qt::Key_Return);
        });
        QTRY_VERIFY(editor.action("windField")->isChecked());
    }

    void paletteHasEveryActionOfTheMenus()
    {
        Editor editor;
        inDialog<Palette>(editor.action("palette"), [&](Palette& palette) {
            const auto* list = palette.findChild<QTreeWidget*>();
            for (const QAction* action : editor.window.actions().all())
                QVERIFY2(
                    !list->findItems(action->text().remove('&'), Qt::MatchStartsWith).isEmpty(),
                    qPrintable(action->text()));
        });
    }

    // Dialogs that a button of a panel opens too are found by the words of their names; what is
    // not found is said.
    void paletteFindsOrSaysSo()
    {
        Editor editor;
        inDialog<Palette>(editor.action("palette"), [&](Palette& palette) {
            auto* typed = palette.findChild<QLineEdit*>();
            const auto* none = palette.findChild<QLabel*>();
            QTest::keyClicks(typed, "from a test");
            QVERIFY(palette.chosen() == editor.action("materialTest"));
            QVERIFY(!none->isVisible());
            typed->setText("zebra");
            QVERIFY(!palette.chosen());
            QVERIFY(none->isVisible() && none->text().contains("No action"));
        });
        editor.action("materialTest")->trigger();
        auto* dialog = editor.window.findChild<MaterialTestDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        dialog->close();
    }

    // What the menus of panels hold, and panels by their names: one that stands behind others, or
    // was closed, comes forward.
    void paletteFindsPanelsAndTheirMenus()
    {
        Editor editor;
        QVERIFY(editor.window.files().open(samples + "cloth.ripstop.json"));
        for (const auto& [words, id] : {std::pair{"loop from", "loopFrom"},
                                        {"loop up", "loopTo"},
                                        {"remove run", "removeRun"}})
            inDialog<Palette>(editor.action("palette"), [&](Palette& palette) {
                QTest::keyClicks(palette.findChild<QLineEdit*>(), words);
                QVERIFY2(palette.chosen() == editor.action(id), words);
            });
        auto* tuning = editor.window.findChild<QDockWidget*>("tuning");
        const auto isSeen = [tuning] { return !tuning->widget()->visibleRegion().isEmpty(); };
        editor.window.docks().show("tuning");
        for (const bool isClosed : {false, true}) {
            editor.window.docks().show("inspector"); // before it
            tuning->setVisible(!isClosed);
            QTRY_VERIFY(!isSeen());
            inDialog<Palette>(editor.action("palette"), [](Palette& palette) {
                auto* typed = palette.findChild<QLineEdit*>();
                QTest::keyClicks(typed, "tuning panels");
                QTest::keyClick(typed, Qt::Key_Return);
            });
            QTRY_VERIFY(isSeen());
        }
    }

    // Menus that only a right click or a button of a panel opens are found as well: those of plots,
    // and the presets while there is a material that they could be given to.
    void paletteFindsWhatPanelsOpen()
    {
        Editor editor;
        QVERIFY(editor.window.files().open(samples + "cloth.ripstop.json"));
        const auto enter = [&](const char* words) {
            inDialog<Palette>(editor.action("palette"), [&](Palette& palette) {
                auto* typed = palette.findChild<QLineEdit*>();
                QTest::keyClicks(typed, words);
                QTest::keyClick(typed, Qt::Key_Return);
            });
        };
        const auto plots = [&] {
            return std::ranges::count_if(editor.document.scene().items, [](const Entry& entry) {
                return std::holds_alternative<Plot>(entry.item);
            });
        };
        QCOMPARE(plots(), 0);
        editor.window.docks().show("loads"); // before the plots
        enter("add a plot");
        QTRY_COMPARE(plots(), 2); // the one that was shown, and the new one
        auto* dock = editor.window.findChild<QDockWidget*>("plots");
        QTRY_VERIFY(!dock->widget()->visibleRegion().isEmpty());

        inDialog<Palette>(editor.action("palette"), [&](Palette& palette) {
            palette.findChild<QLineEdit*>()->setText("skytex 27");
            QVERIFY(!palette.chosen());
        });
        const auto& items = editor.document.scene().items;
        const Id material = std::ranges::find_if(items, [](const Entry& entry) {
                                return std::holds_alternative<Material>(entry.item);
                            })->id;
        editor.selection.set({material});
        enter("skytex 27");
        const auto massNow = [&] {
            return findItem<Material>(editor.document.scene(), material)->arealDensity.value_or(0);
        };
        QTRY_COMPARE(massNow(), 0.027); // kg/m^2, as its name says
    }

    // What is grey says what it needs, in the menu where the mouse rests and in the palette.
    void greyActionsSayWhatTheyNeed()
    {
        Editor editor;
        QVERIFY(editor.window.files().open(samples + "cloth.ripstop.json"));
        QAction* mirror = editor.action("mirror");
        QVERIFY(!mirror->isEnabled());
        QMenu* design = nullptr;
        for (const QAction* title : editor.window.menuBar()->actions())
            if (title->menu() && title->menu()->actions().contains(mirror))
                design = title->menu();
        QVERIFY(design);
        const auto rest = [&] { // the mouse on it
            QToolTip::hideText();
            const QPoint place = design->actionGeometry(mirror).center();
            QHelpEvent event(QEvent::ToolTip, place, design->mapToGlobal(place));
            QApplication::sendEvent(design, &event);
            return QToolTip::isVisible() ? QToolTip::text() : QString();
        };
        design->popup({0, 0});
        QVERIFY2(rest().contains("Select something first"), qPrintable(rest()));
        design->close();
        inDialog<Palette>(editor.action("palette"), [](Palette& palette) {
            QTest::keyClicks(palette.findChild<QLineEdit*>(), "mirror");
            const auto* list = palette.findChild<QTreeWidget*>();
            QVERIFY(list->topLevelItem(0)->toolTip(0).contains("Select something first"));
        });
        editor.selection.set({editor.document.scene().items.back().id});
        QVERIFY(mirror->isEnabled());
        QVERIFY(mirror->whatsThis().isEmpty());
        for (const char* id : {"undo", "redo"})
            QVERIFY(editor.action(id)->isEnabled() || !editor.action(id)->whatsThis().isEmpty());
    }

    void keysAreChangedTakenAndKept()
    {
        {
            Editor editor(MainWindow::Memory::Keep);
            const QKeySequence fit = editor.action("fit")->shortcut();
            inDialog<KeysDialog>(editor.action("keys"), [&](KeysDialog& dialog) {
                auto* table = dialog.findChild<QTreeWidget*>();
                table->setCurrentItem(rowOf(*table, "Show wind field"));
                dialog.findChild<QKeySequenceEdit*>()->setKeySequence(fit);
                for (auto* button : dialog.findChildren<QPushButton*>())
                    if (button->text() == "&Set")
                        button->click();
            });
            QCOMPARE(editor.action("windField")->shortcut(), fit);
            QVERIFY(editor.action("fit")->shortcut().isEmpty());
            QVERIFY(editor.action("windField")
                        ->toolTip()
                        .contains(fit.toString(QKeySequence::NativeText)));
        }
        Editor again(MainWindow::Memory::Keep);
        QCOMPARE(again.action("windField")->shortcut(), QKeySequence("Home"));
        QVERIFY(again.action("fit")->shortcut().isEmpty());
    }

    void usualKeysComeBack()
    {
        QAction one;
        one.setObjectName("one");
        one.setShortcut(QKeySequence("Ctrl+1"));
        QAction two;
        two.setObjectName("two");
        KeyMap keys({&one, &two}, KeyMap::Memory::Keep, nullptr);
        keys.set(two, QKeySequence("Ctrl+1"));
        QVERIFY(one.shortcut().isEmpty());
        QCOMPARE(keys.holder(QKeySequence("Ctrl+1")), &two);
        keys.resetAll();
        QCOMPARE(one.shortcut(), QKeySequence("Ctrl+1"));
        QVERIFY(two.shortcut().isEmpty());
        QVERIFY(QSettings().allKeys().isEmpty());
    }

    void noTwoActionsHaveTheSameKeys()
    {
        Editor editor;
        std::map<QString, const QAction*> holders;
        for (const QAction* action : editor.window.actions().all())
            for (const QKeySequence& keys : action->shortcuts()) {
                const auto [place, isNew] = holders.emplace(keys.toString(), action);
                QVERIFY2(isNew || keys.isEmpty(), qPrintable(keys.toString() + action->text()));
            }
    }

    void viewIsRemembered()
    {
        {
            Editor editor(MainWindow::Memory::Keep);
            editor.action("windField")->trigger();
            editor.action("bySpeed")->trigger();
            editor.action("links")->trigger();
            editor.window.close();
        }
        Editor again(MainWindow::Memory::Keep);
        QVERIFY(again.action("windField")->isChecked());
        QVERIFY(again.action("bySpeed")->isChecked());
        QVERIFY(!again.action("byMaterial")->isChecked());
        QVERIFY(!again.action("links")->isChecked());
        QVERIFY(again.action("panels")->isChecked());
    }

    void historyGoesToAnyStep()
    {
        Editor editor;
        QVERIFY(editor.window.files().open(samples + "cloth.ripstop.json"));
        const Scene before = editor.document.scene();
        for (const double wind : {1.0, 2.0, 3.0})
            editor.document.push(
                *assignment(before, "settings.airDensity=" + std::to_string(wind)));
        auto* history = editor.window.findChild<QUndoView*>();
        QVERIFY(history);
        history->setCurrentIndex(history->model()->index(0, 0));
        QVERIFY(editor.document.scene() == before);
        history->setCurrentIndex(history->model()->index(3, 0));
        QCOMPARE(editor.document.scene().settings.airDensity, 3.0);
    }

    void tourGoesThroughTheWindow()
    {
        Editor editor;
        QVERIFY(QTest::qWaitForWindowExposed(&editor.window));
        editor.action("tour")->trigger();
        QPointer<Tour> tour = editor.window.findChild<Tour*>();
        QVERIFY(tour);
        QVERIFY(!editor.document.scene().items.empty()); // a sample, to have something to show
        QCOMPARE(tour->stop(), 0);
        QTest::keyClick(tour, Qt::Key_Right);
        QCOMPARE(tour->stop(), 1);
        QTest::keyClick(tour, Qt::Key_Left);
        QCOMPARE(tour->stop(), 0);
        for (int i = 0; i < 20 && tour; ++i) {
            QTest::keyClick(tour, Qt::Key_Return);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        }
        QVERIFY(!tour);
    }

    void templatesBeginNewDesigns()
    {
        Editor editor;
        QVERIFY(editor.window.files().open(samples + "cloth.ripstop.json"));
        const Scene scene = editor.document.scene();
        inDialog<QInputDialog>(editor.action("saveTemplate"), [](QInputDialog& dialog) {
            dialog.setTextValue("my: sheet");
            dialog.accept();
        });
        QCOMPARE(editor.window.files().templates().size(), 1);
        QCOMPARE(templateName(editor.window.files().templates().first()), QString("my- sheet"));
        editor.document.replace(Scene{});
        editor.window.files().startFromTemplate(editor.window.files().templates().first());
        QVERIFY(editor.document.scene() == scene);
        QVERIFY(editor.document.file().isEmpty());
        QVERIFY(editor.document.isModified());
    }
};

const RegisteredTest registered("test_finding", runWithView<TestFinding>);

} // namespace ripstop::test_finding
#include "test_finding.moc"
