// What a designer does with the menus that shape a design, by its actions and dialogs.
//
// Stages: actions, tools and typed numbers; copies, pins and alignment; dialogs with their
// previews; then a drag of a large design, and refusals.
#include "builders/builder.h"
#include "dialogs/operation_dialog.h"
#include "document/clipboard.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "icons/complaint.h"
#include "thread_time.h"
#include "tools/pointing.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"
#include "views/small_scenes.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>

namespace ripstop::test_shaping {

namespace {

struct Shop
{
    Document document;
    Selection selection{document};
    Player player{document};
    MainWindow window{document, selection, player, MainWindow::Memory::Ignore};

    explicit Shop(Scene scene = oneOfEverything())
    {
        document.replace(std::move(scene));
        window.show();
        window.showScene();
    }

    void run(const char* id) { window.actions()[id]->trigger(); }
    QAction* action(const char* id) { return window.actions()[id]; }
    const Scene& scene() const { return document.scene(); }
    const Part& part() const { return *findItem<Part>(scene(), Id{1}); }
    Vec3 place(Id id) const { return std::get<const Particle*>(*find(scene(), id))->position; }
};

const Operation& operation(const char* name) { return *findOperation(name); }

} // namespace

class TestShaping : public QObject
{
    Q_OBJECT

private slots:
    void actionsNeedASelection()
    {
        Shop shop;
        shop.selection.clear();
        for (const char* id : {"duplicate", "mirror", "weld", "mass", "pin", "copy", "alignLeastX"})
            QVERIFY2(!shop.action(id)->isEnabled(), id);
        shop.selection.set({Id{3}});
        for (const char* id : {"duplicate", "mirror", "weld", "mass", "pin", "copy", "alignLeastX"})
            QVERIFY2(shop.action(id)->isEnabled(), id);
        QVERIFY(shop.action("paste")->isEnabled());
    }

    // One tool at a time: the options of both would lie over each other.
    void shapingPutsDownThePen()
    {
        Shop shop;
        shop.selection.set({Id{3}});
        Viewport& view = shop.window.viewport();
        shop.run("drawLinks");
        QVERIFY(view.pointing().hasTool());
        shop.run("scale");
        QVERIFY(!view.pointing().hasTool());
        QCOMPARE(view.transformTool().shaping(), Shaping::Scale);
        QVERIFY(shop.action("toolPointer")->isChecked());
        shop.run("drawLinks"); // and the other way round
        QVERIFY(view.pointing().hasTool());
        QCOMPARE(view.transformTool().shaping(), Shaping::None);
    }

    void toolsAreToggles()
    {
        Shop shop;
        TransformTool& tool = shop.window.viewport().transformTool();
        shop.selection.set({Id{3}});
        shop.run("move");
        QCOMPARE(tool.shaping(), Shaping::Move);
        QVERIFY(shop.action("move")->isChecked());
        shop.run("rotate");
        QVERIFY(!shop.action("move")->isChecked() && shop.action("rotate")->isChecked());
        shop.run("rotate");
        QCOMPARE(tool.shaping(), Shaping::None);
    }

    // A key pressed by mistake ends no flight and puts no other tool down; without a selection
    // there is nothing to shape.
    void toolsRefuseARunAndAnEmptySelection()
    {
        Shop shop(fallingPair());
        QTRY_VERIFY(shop.player.frame());
        TransformTool& tool = shop.window.viewport().transformTool();
        QString said;
        connect(&tool, &TransformTool::said, this, [&](const QString& words) { said = words; });
        for (const char* id : {"move", "rotate", "scale"}) {
            shop.run(id);
            QVERIFY2(said.startsWith("Select something first"), qPrintable(said));
            QCOMPARE(tool.shaping(), Shaping::None);
            QVERIFY(!shop.action(id)->isChecked());
        }
        shop.selection.set({Id{2}});
        shop.player.step();
        QTRY_VERIFY(shop.player.frame()->step > 0);
        shop.run("toolGrab");
        for (const bool plays : {false, true}) {
            if (plays)
                shop.player.play();
            for (const char* id : {"move", "rotate", "scale"}) {
                said.clear();
                shop.run(id);
                QCOMPARE(said, TransformTool::wayToDesign());
                QCOMPARE(tool.shaping(), Shaping::None);
                QVERIFY(!shop.action(id)->isChecked());
                QVERIFY(shop.window.viewport().pointing().hasTool());
                QCOMPARE(shop.player.isPlaying(), plays);
                QVERIFY(shop.player.frame()->step > 0);
            }
        }
    }

    void numbersAreTypedIntoTheBar()
    {
        Shop shop;
        shop.selection.set({Id{3}});
        shop.run("move");
        auto* bar = shop.window.viewport().findChild<QWidget*>("transformBar");
        QVERIFY(bar && bar->isVisible());
        auto* x = bar->findChild<QLineEdit*>("x");
        x->setText("0.25 m");
        QTest::keyClick(x, Qt::Key_Return);
        QCOMPARE(shop.place(Id{3}), Vec3(1.25, 1, 0));
        QCOMPARE(x->text(), QString("0")); // ready for the next step
        const auto refused = [&](const QString& typed) {
            const Scene before = shop.scene();
            x->setText(typed);
            QTest::keyClick(x, Qt::Key_Return);
            const auto* complaint = bar->findChild<Complaint*>();
            return shop.scene() == before && x->text() == typed && complaint->isVisible();
        };
        QVERIFY(refused("abc"));
        QVERIFY(refused("1e300"));
        shop.run("scale");
        QVERIFY(!bar->findChild<Complaint*>()->isVisible());
        QVERIFY(refused("0"));
        QVERIFY(refused("-1"));
        shop.run("scale");
        QVERIFY(!bar->isVisible());
    }

    void duplicateThenPasteElsewhere()
    {
        Shop shop;
        shop.selection.set({Id{2}, Id{3}});
        shop.run("duplicate");
        QCOMPARE(shop.part().particles.size(), std::size_t(5));
        QCOMPARE(shop.selection.ids().size(), std::size_t(3)); // two and their link
        QCOMPARE(shop.window.viewport().transformTool().shaping(), Shaping::Move);
        shop.run("copy");
        Shop other(fallingPair());
        const auto items = other.scene().items.size();
        other.run("paste");
        QCOMPARE(other.scene().items.size(), items + 2); // a part and its material
        other.document.history().undo();
        QCOMPARE(other.scene().items.size(), items);
        QGuiApplication::clipboard()->setText("a shopping list");
        other.run("paste");
        QCOMPARE(other.scene().items.size(), items);
    }

    void cutAndPasteBringItBack()
    {
        Shop shop;
        shop.selection.set({Id{5}, Id{6}, Id{7}, Id{8}, Id{2}, Id{3}, Id{4}});
        shop.run("cut");
        QVERIFY(shop.part().particles.empty());
        shop.run("paste");
        const Part* pasted = findItem<Part>(shop.scene(), shop.selection.ids().front());
        QVERIFY(pasted && pasted->particles.size() == 3 && pasted->panels.size() == 1);
    }

    void pinningTogglesAll()
    {
        Shop shop;
        shop.selection.set({Id{2}, Id{3}}); // one of them is pinned
        shop.run("pin");
        QVERIFY(shop.part().particles[0].pinned && shop.part().particles[1].pinned);
        shop.run("pin");
        QVERIFY(!shop.part().particles[0].pinned && !shop.part().particles[1].pinned);
    }

    void aligningFollowsTheMenu()
    {
        Shop shop;
        shop.selection.set({Id{2}, Id{3}});
        shop.run("alignMostX");
        QCOMPARE(shop.place(Id{2}), Vec3(1, 1, 0));
    }

    // The dialog shows the outcome in the design; dismissed it leaves nothing behind, accepted one
    // step.
    void dialogsPreviewAndTakeBack()
    {
        Shop shop;
        shop.document.history().setClean();
        shop.selection.set({Id{1}});
        const std::vector<Id> before = shop.selection.ids();
        {
            OperationDialog dialog(operation("mirror"), shop.document, shop.selection,
                                   &shop.window);
            // particles 2 and 4 lie on x = 0: 1 comes, with 2 links and 1 panel
            QCOMPARE(shop.part().particles.size(), std::size_t(4));
            QVERIFY(dialog.findChild<QLabel*>("outcome")->text().contains("1 particle, 2 links"));
            dialog.findChild<QWidget*>("plane")->findChild<QComboBox*>()->setCurrentIndex(
                2); // all lie in z = 0
            QTRY_COMPARE(shop.part().particles.size(), std::size_t(3));
            QVERIFY(dialog.findChild<QLabel*>("outcome")->text().contains("another plane"));
            dialog.reject();
        }
        QCOMPARE(shop.document.history().count(), 0);
        QVERIFY(!shop.document.isModified());
        QCOMPARE(shop.selection.ids(), before);
        OperationDialog dialog(operation("mirror"), shop.document, shop.selection, &shop.window);
        dialog.accept();
        QCOMPARE(shop.document.history().count(), 1);
        QCOMPARE(shop.part().panels.size(), std::size_t(2));
        shop.document.history().undo();
        QCOMPARE(shop.part().particles.size(), std::size_t(3));
    }

    // What a preview removes leaves the selection, and comes back with it.
    void aPreviewOfAWeldKeepsTheSelection()
    {
        Shop shop;
        shop.selection.set({Id{2}, Id{3}, Id{4}});
        OperationDialog dialog(operation("weld"), shop.document, shop.selection, &shop.window);
        QVERIFY(!dialog.findChild<QLabel*>("outcome")->text().isEmpty());
        dialog.findChild<QWidget*>("which")->findChild<QComboBox*>()->setCurrentIndex(1);
        QTRY_COMPARE(shop.part().particles.size(), std::size_t(1));
        dialog.reject();
        QCOMPARE(shop.selection.ids().size(), std::size_t(3));
        QCOMPARE(shop.part().particles.size(), std::size_t(3));
    }

    // One step of the history; the dialog has nothing to ask and says what goes. A fabric that
    // would carry nothing is refused by name.
    void threadsBecomePanels()
    {
        const auto sheet = [](double membrane) {
            return *build(*findBuilder("cloth"),
                          {{"columns", 4}, {"rows", 4}, {"sphere", 0}, {"membrane", membrane}});
        };
        const auto partOf = [](const Shop& shop) {
            Id found = noId;
            forEachPart(shop.scene(), [&](Id id, const Part&) { found = id; });
            return found;
        };
        Shop shop(sheet(40e3));
        const Id part = partOf(shop);
        const auto links = [&] { return findItem<Part>(shop.scene(), part)->links.size(); };
        const std::size_t before = links();
        shop.selection.set({part});
        QVERIFY(shop.action("panels")->isEnabled());
        OperationDialog dialog(operation("panels"), shop.document, shop.selection, &shop.window);
        // 2 x 4 x 5 edges and two diagonals in each of 16 cells
        QVERIFY2(dialog.findChild<QLabel*>("outcome")->text().contains("72 links"),
                 qPrintable(dialog.findChild<QLabel*>("outcome")->text()));
        dialog.accept();
        QCOMPARE(shop.document.history().count(), 1);
        QCOMPARE(links(), before - 72);
        QVERIFY(findItem<Part>(shop.scene(), part)->carrier == FabricKind::Panels);
        shop.document.history().undo();
        QCOMPARE(links(), before);
        QVERIFY(findItem<Part>(shop.scene(), part)->carrier == FabricKind::Threads);

        Shop knit(sheet(0.0));
        knit.selection.set({partOf(knit)});
        OperationDialog refused(operation("panels"), knit.document, knit.selection, &knit.window);
        QVERIFY(refused.findChild<QLabel*>("outcome")->text().contains("material cloth has no"));
        refused.accept();
        QCOMPARE(knit.document.history().count(), 0);
    }

    // All docks look at what the hand moves: 100 489 particles, with the window free in between.
    void theWindowFollowsALargeDrag()
    {
        Shop shop(*build(*findBuilder("cloth"), {{"columns", 316}, {"rows", 316}}));
        QVERIFY(QTest::qWaitForWindowExposed(&shop.window));
        QTRY_VERIFY_WITH_TIMEOUT(shop.player.frame(), 20000);
        std::vector<Id> parts;
        forEachPart(shop.scene(), [&](Id id, const Part&) { parts.push_back(id); });
        shop.selection.set(parts);
        shop.run("move");
        QCoreApplication::processEvents();
        Viewport& view = shop.window.viewport();
        const QPoint from = view.transformTool().gizmo()->centre()->toPoint();
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        double worst = 0.0;
        for (int i = 1; i <= 5; ++i) {
            const QPointF at = from + QPoint(4 * i, 2 * i);
            QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton,
                             Qt::LeftButton, {});
            const double start = threadTime();
            QApplication::sendEvent(&view, &move);
            worst = std::max(worst, threadTime() - start);
            QTest::qWait(20);
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(20, 10));
        qInfo("each step of the drag took at most %.0f ms", worst);
        QCOMPARE(shop.document.history().count(), 1);
    }

    void badNumbersAreRefused()
    {
        Shop shop;
        shop.selection.set({Id{1}});
        OperationDialog dialog(operation("row"), shop.document, shop.selection, &shop.window);
        auto* count = dialog.findChild<QWidget*>("count")->findChild<QLineEdit*>();
        count->clear();
        QTest::keyClicks(count, "many");
        QTRY_VERIFY(dialog.findChild<QLabel*>("outcome")->text().contains("Count"));
        dialog.accept();
        QCOMPARE(shop.document.history().count(), 0);
    }
};

const RegisteredTest registered("test_shaping", runWithWidgets<TestShaping>);

} // namespace ripstop::test_shaping
#include "test_shaping.moc"
