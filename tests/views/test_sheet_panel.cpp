// The table of a design, used with keys and mouse.
//
// Stages: sorting, cells and switches by keys and mouse; copying and pasting; filters and marked
// rows against the selection; then a design that changes, and a large one.
#include "builders/builder.h"
#include "document/document.h"
#include "document/measurement.h"
#include "document/player.h"
#include "document/selection.h"
#include "small_scenes.h"
#include "table/sheet_panel.h"
#include "views/run_with_widgets.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QtTest>

namespace ripstop::test_sheet_panel {

namespace {

struct Desk
{
    Document document;
    Selection selection{document};
    SheetPanel panel{document, selection, [] { return measurementOf({}); }};

    explicit Desk(Scene scene = oneOfEverything())
    {
        document.replace(std::move(scene));
        panel.resize(900, 400);
        static_cast<QWidget&>(panel).show();
        QApplication::setActiveWindow(&panel); // Xvfb has no window manager to do it
        panel.table().setFocus();
    }

    int column(std::string_view key, int axis = 0)
    {
        const auto& columns = panel.model().columns();
        for (std::size_t k = 0; k < columns.size(); ++k)
            if (columns[k].property && columns[k].property->key == key && columns[k].axis == axis)
                return int(k);
        return -1;
    }
    QModelIndex cell(int row, std::string_view key, int axis = 0)
    {
        return panel.model().index(row, column(key, axis));
    }
    void sortBy(std::string_view key, Qt::SortOrder order)
    {
        QSignalSpy sorted(&panel.model(), &SheetModel::sorted);
        panel.table().sortByColumn(column(key), order);
        if (sorted.isEmpty())
            QVERIFY(sorted.wait());
    }
    Value value(Id id, std::string_view key) const
    {
        const ConstRef thing = *find(document.scene(), id);
        return findProperty(kindOf(thing), key)->get(thing);
    }
    bool says(const QString& words) const
    {
        const auto labels = panel.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }
};

} // namespace

class TestSheetPanel : public QObject
{
    Q_OBJECT

private slots:
    void rowsAreSorted()
    {
        Desk desk;
        desk.document.push(setValue(desk.document.scene(), Id{3}, "mass", 0.5));
        desk.sortBy("mass", Qt::DescendingOrder);
        QCOMPARE(desk.panel.model().ids().front(), Id{3});
        desk.sortBy("mass", Qt::AscendingOrder);
        QCOMPARE(desk.panel.model().ids().back(), Id{3});
    }

    // The numbers of the table stay those of the design, which it says while a run is shown.
    void whoSeesARunIsToldOfTheDesign()
    {
        Desk desk(fallingPair());
        Player player{desk.document};
        desk.panel.follow(player);
        const char* told = "not the run";
        QTRY_VERIFY(player.frame());
        QVERIFY(!desk.says(told));
        player.step();
        QTRY_VERIFY(desk.says(told));
        player.reset();
        QTRY_VERIFY(!desk.says(told));
        player.play();
        QTRY_VERIFY(desk.says(told));
        player.pause();
    }

    void aCellIsEdited()
    {
        Desk desk;
        QTableView& table = desk.panel.table();
        table.setCurrentIndex(desk.cell(1, "mass"));
        table.edit(desk.cell(1, "mass"));
        auto* line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        QVERIFY(line);
        line->selectAll();
        QTest::keyClicks(line, "25 g");
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_COMPARE(desk.value(Id{3}, "mass"), Value(0.025)); // editors commit a moment later
        QCOMPARE(desk.document.history().count(), 1);
        const QString told = desk.document.history().undoText();
        QVERIFY2(told.startsWith("Set mass of ") && told.endsWith(QStringLiteral("to 25\u00a0g")),
                 qPrintable(told));
        desk.document.history().undo();
        QVERIFY(desk.value(Id{3}, "mass") != Value(0.025));

        const Scene before = desk.document.scene();
        QVERIFY(!desk.panel.model().setData(desk.cell(1, "mass"), "25 m", Qt::EditRole));
        QVERIFY(desk.says("must be in kg"));
        QVERIFY(desk.document.scene() == before);
    }

    void aSwitchIsTurned()
    {
        Desk desk;
        QVERIFY(
            desk.panel.model().setData(desk.cell(1, "pinned"), Qt::Checked, Qt::CheckStateRole));
        QCOMPARE(desk.value(Id{3}, "pinned"), Value(true));
    }

    // Copied out and pasted back, changed in between as a spreadsheet would.
    void cellsAreCopiedAndPasted()
    {
        Desk desk;
        QTableView& table = desk.panel.table();
        table.selectionModel()->select(
            QItemSelection(desk.cell(0, "position", 0), desk.cell(1, "position", 2)),
            QItemSelectionModel::ClearAndSelect);
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), QString("0\t1\t0\n1\t1\t0\n"));
        QApplication::clipboard()->setText("0\t2\t0\r\n1\t30 cm\t0\r\n");
        QTest::keyClick(&table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(desk.value(Id{2}, "position"), Value(Vec3(0, 2, 0)));
        QCOMPARE(desk.value(Id{3}, "position"), Value(Vec3(1, 0.3, 0)));
        QCOMPARE(desk.document.history().count(), 1); // one step for all

        QApplication::clipboard()->setText("1\t2\n3\theavy\n");
        QTest::keyClick(&table, Qt::Key_V, Qt::ControlModifier);
        QVERIFY(desk.says("Line 2, Position y"));
        QCOMPARE(desk.document.history().count(), 1);
    }

    void aFilterIsACondition()
    {
        Desk desk;
        desk.document.push(setValue(desk.document.scene(), Id{3}, "mass", 0.5));
        QTest::keyClicks(&desk.panel.filterLine(), "mass > 100 g");
        QTRY_COMPARE(desk.panel.model().ids(), std::vector{Id{3}});
        QVERIFY(desk.says("1 of 3 rows"));
        desk.panel.filterLine().setText("mass > heavy");
        QTRY_VERIFY(desk.says("At character"));
        desk.panel.filterLine().clear();
        QTRY_COMPARE(desk.panel.model().ids().size(), std::size_t(3));
    }

    void markedRowsAreSelectedInTheDesign()
    {
        Desk desk;
        desk.panel.table().selectRow(1);
        QCOMPARE(desk.selection.ids(), std::vector{Id{3}});
        desk.selection.set({Id{4}});
        desk.panel.findChild<QCheckBox*>()->setChecked(true);
        QCOMPARE(desk.panel.model().ids(), std::vector{Id{4}});
    }

    void rowsFollowTheDesign()
    {
        Desk desk;
        desk.document.push(removal(desk.document.scene(), {Id{4}}));
        QCOMPARE(desk.panel.model().ids(), (std::vector{Id{2}, Id{3}}));
        desk.document.history().undo();
        QCOMPARE(desk.panel.model().ids().size(), std::size_t(3));
        desk.panel.showSheet(SheetOf::Links);
        QCOMPARE(desk.panel.model().ids().size(), std::size_t(3));
        desk.panel.showSheet(SheetOf::Materials);
        QCOMPARE(desk.panel.model().ids(), (std::vector{Id{9}, Id{10}}));
        desk.document.replace(Scene());
        QCOMPARE(desk.panel.model().rowCount(), 0);
        QVERIFY(desk.says("0 rows"));
    }

    // A sheet of 100 000 particles with its 600 000 links.
    void aLargeDesign()
    {
        Desk desk(*build(*findBuilder("cloth"), {{"columns", 316}, {"rows", 316}}));
        QVERIFY(desk.panel.model().rowCount() > 99000);
        desk.sortBy("position", Qt::DescendingOrder);
        const auto x = [&](std::size_t row) {
            return std::get<Vec3>(desk.value(desk.panel.model().ids()[row], "position")).x();
        };
        QVERIFY(x(0) > x(50000) && x(50000) > x(99000));
        desk.panel.showSheet(SheetOf::Links);
        QVERIFY(desk.panel.model().rowCount() > 200000);
    }
};

const RegisteredTest registered("test_sheet_panel", runWithWidgets<TestSheetPanel>);

} // namespace ripstop::test_sheet_panel
#include "test_sheet_panel.moc"
