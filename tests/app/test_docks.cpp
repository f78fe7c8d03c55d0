// The docks of the window: each row of their table is all that a dock needs, and what follows from
// it is there.
//
// Stages: rows against docks, toggles, tabs and ids; then docks that the user closed, and those
// that come forward when a scene is opened; the stops of the tour; and panels that catch up with
// the run for a picture.
#include "app/window_shop.h"
#include "docks/dock_table.h"
#include "document/spoken.h"
#include "editor/tour.h"
#include "language/language.h"
#include "plots/plot_panel.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTreeWidget>
#include <QtTest>

namespace ripstop::test_docks {

namespace {

const QTabBar& tabsOf(const QMainWindow& window, const QDockWidget& dock)
{
    for (const QTabBar* tabs : window.findChildren<QTabBar*>())
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->tabText(i) == dock.windowTitle())
                return *tabs;
    qFatal("%s has no tabs", qPrintable(dock.objectName()));
}

struct OpenWindow : WindowShop
{
    OpenWindow()
    {
        window.show();
        window.files().open(SCENES_DIR "/delta_kite.ripstop.json");
        QTest::qWait(50); // until docks have their sizes
    }

    QDockWidget& dock(const QString& id)
    {
        for (const auto& [row, widget] : window.docks().all())
            if (row.id == id)
                return *widget;
        qFatal("there is no dock %s", qPrintable(id));
    }
};

// Whether it is the one in front of docks that lie behind each other.
bool isInFront(const QDockWidget& dock) { return !dock.visibleRegion().isEmpty(); }

// Numbers of the list of probes, as it shows them.
QStringList shownBy(const PlotPanel& panel)
{
    const QTreeWidget& list = *panel.findChild<QTreeWidget*>();
    QStringList numbers;
    for (int i = 0; i < list.topLevelItemCount(); ++i)
        numbers << list.topLevelItem(i)->text(1);
    return numbers;
}

// And as a frame has them.
QStringList readIn(const Frame& frame, const Scene& scene)
{
    QStringList numbers;
    for (std::size_t i = 0; i < frame.probe.size(); ++i) {
        const Layout::Probe& probe = frame.layout->probes[i];
        const auto* item = findItem<Probe>(scene, Id{probe.id});
        numbers << readingText(item->quantity, frame.probe[i], probe.unit);
    }
    return numbers;
}

bool has(const QMenu& menu, const QAction* wanted)
{
    const QList<QAction*> entries = menu.actions();
    return std::ranges::any_of(entries, [&](const QAction* entry) {
        return entry == wanted || (entry->menu() && has(*entry->menu(), wanted));
    });
}

} // namespace

class TestDocks : public QObject
{
    Q_OBJECT

private slots:
    void rowsAreDocks()
    {
        OpenWindow shop;
        const std::vector<DockRow> rows = dockTable();
        QCOMPARE(shop.window.docks().all().size(), rows.size());
        QSet<QString> ids;
        for (const DockRow& row : rows) {
            QVERIFY2(!ids.contains(row.id), row.id);
            ids << row.id;
            QDockWidget& dock = shop.dock(row.id);
            QCOMPARE(dock.objectName(), QString(row.id));
            QVERIFY(!row.title.isEmpty());
            QVERIFY(dock.windowTitle().startsWith(row.title)); // it may count something
            QCOMPARE(shop.window.dockWidgetArea(&dock), row.area);
            QVERIFY(dock.widget());
        }
    }

    void togglesStandInTheMenus()
    {
        OpenWindow shop;
        const QList<QAction*> toggles = shop.window.docks().toggles();
        QCOMPARE(toggles.size(), qsizetype(dockTable().size()));
        for (const DockRow& row : dockTable()) {
            const QAction* toggle = shop.dock(row.id).toggleViewAction();
            QVERIFY(toggles.contains(toggle));
            const QList<QAction*> titles = shop.window.menuBar()->actions();
            QVERIFY(std::ranges::any_of(
                titles, [&](const QAction* title) { return has(*title->menu(), toggle); }));
        }
    }

    void rowsOfAnAreaAreTabsWithTheFirstInFront()
    {
        OpenWindow shop;
        std::map<Qt::DockWidgetArea, QDockWidget*> front;
        for (const DockRow& row : dockTable()) {
            QDockWidget& dock = shop.dock(row.id);
            const auto [first, isFirst] = front.try_emplace(row.area, &dock);
            QVERIFY2(isInFront(dock) == isFirst, row.id);
            if (!isFirst)
                QVERIFY(shop.window.tabifiedDockWidgets(first->second).contains(&dock));
            if (row.size == 0)
                continue;
            if (row.area == Qt::BottomDockWidgetArea) // its tabs share the height
                QCOMPARE(dock.height() + tabsOf(shop.window, dock).height(), row.size);
            else
                QCOMPARE(dock.width(), row.size);
        }
    }

    void areShownByTheirIds()
    {
        OpenWindow shop;
        for (const DockRow& row : dockTable()) {
            shop.dock(row.id).close();
            QVERIFY(shop.window.docks().show(row.id));
            QTRY_VERIFY2(isInFront(shop.dock(row.id)), row.id);
        }
        QVERIFY(!shop.window.docks().show("nothing"));
    }

    // The start page has the window to itself.
    void closedOnesStayClosedAfterTheStartPage()
    {
        OpenWindow shop;
        shop.dock("tuning").close();
        shop.window.showStartPage();
        for (const auto& [row, dock] : shop.window.docks().all())
            QVERIFY2(dock->isHidden(), row.id);
        shop.window.showScene();
        for (const auto& [row, dock] : shop.window.docks().all())
            QVERIFY2(dock->isHidden() == (QLatin1String(row.id) == "tuning"), row.id);
    }

    void someComeForwardWhenASceneIsOpened()
    {
        OpenWindow shop;
        for (const DockRow& row : dockTable()) // the last of each area stays in front
            shop.window.docks().show(row.id);
        QTest::qWait(20);
        QVERIFY(shop.window.files().open(SCENES_DIR "/cloth.ripstop.json"));
        QTest::qWait(20);
        for (const DockRow& row : dockTable())
            if (row.onOpening == OnOpening::ComesForward)
                QVERIFY2(isInFront(shop.dock(row.id)), row.id);
        QVERIFY(isInFront(shop.dock("tuning")));
    }

    // Also in the language with the longer words.
    void tourHasRoomForItsButtons()
    {
        const Translation translation(Language::French);
        WindowShop shop;
        shop.window.resize(1280, 800);
        shop.window.show();
        shop.run("tour");
        auto* tour = shop.window.findChild<Tour*>();
        QVERIFY(tour);
        QTest::qWait(20); // it is laid out
        const auto buttons = tour->findChildren<QPushButton*>();
        QCOMPARE(buttons.size(), 3);
        for (const QPushButton* button : buttons)
            QVERIFY2(button->width() >= button->minimumSizeHint().width(),
                     qPrintable(button->text()));
    }

    // Between the view and the bar that flies it, and from there to the menus.
    void tourStopsAtThoseThatSayWhatTheyAreFor()
    {
        OpenWindow shop;
        const auto rows = dockTable();
        const auto told = std::ranges::count_if(
            rows, [](const DockRow& row) { return !row.tourTitle.isEmpty(); });
        QVERIFY(told > 0);
        shop.run("tour");
        QPointer<Tour> tour = shop.window.findChild<Tour*>();
        QVERIFY(tour);
        int stops = 0;
        for (; tour && stops < 100; ++stops) {
            tour->goTo(tour->stop() + 1);
            QTest::qWait(1); // it deletes itself
        }
        QCOMPARE(stops, 3 + int(told));
    }

    // Plots are drawn a moment after a frame, so that drawing leaves time for the rest; a picture
    // of the window would have shown numbers of an instant before the one that is printed with it.
    void numbersOfAPictureAreOfItsMoment()
    {
        OpenWindow shop;
        const Docks& docks = shop.window.docks();
        const PlotPanel& plots = docks.panel<PlotPanel>();
        QTRY_VERIFY(shop.player.frame());
        QTRY_COMPARE(shownBy(plots), readIn(*shop.player.frame(), shop.document.scene()));
        QStringList late, atOnce, meant;
        connect(&shop.player, &Player::frameReady, &shop.window, [&](const auto& frame) {
            if (shop.player.isPlaying()) // has not arrived
                return;
            late = shownBy(plots);
            docks.catchUp();
            atOnce = shownBy(plots);
            meant = readIn(*frame, shop.document.scene());
        });
        shop.player.playUntil(0.5);
        QTRY_VERIFY(!meant.isEmpty());
        QCOMPARE(atOnce, meant);
        QVERIFY(late != meant); // or nothing has been shown
    }
};

const RegisteredTest registered("test_docks", runWithView<TestDocks>);

} // namespace ripstop::test_docks
#include "test_docks.moc"
