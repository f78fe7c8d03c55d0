// A designer's day in one go, by real events: a kite from nothing, flown, torn and tuned, all of it
// taken back and done again.
//
// Stages: the tests go on from each other on one window, in the order in which they stand: insert,
// import, weld, tune, lasso, draw, fly; then all is undone and done again, and saved and opened.
#include "app/window_shop.h"
#include "builders/builder.h"
#include "dialogs/builder_dialog.h"
#include "dialogs/operation_dialog.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "files/arrivals.h"
#include "import/import_dialog.h"
#include "inspector/inspector.h"
#include "io/scene_file.h"
#include "model/meshes.h"
#include "select/elements.h"
#include "simulation/torn_system.h"
#include "tools/pointing.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace ripstop::test_workshop {

namespace {

constexpr int patience = 20000; // ms

struct Shop : WindowShop
{
    Shop()
    {
        window.resize(1280, 800);
        window.show();
        QApplication::setActiveWindow(&window); // Xvfb has no window manager to do it
    }

    const Scene& scene() const { return document.scene(); }
    void pressKey(Qt::Key key)
    {
        QApplication::setActiveWindow(&window); // which a dialog has been
        viewport.setFocus();
        QTest::keyClick(&viewport, key);
    }

    // An operation on what is selected, with its numbers typed.
    void operate(const char* id, const std::map<QString, QString>& numbers = {})
    {
        during<OperationDialog>([&] { run(id); },
                                [&](OperationDialog& dialog) {
                                    for (const auto& [key, words] : numbers)
                                        type(dialog, key, words);
                                    auto* ok = okOf(dialog);
                                    QTRY_VERIFY(ok->isEnabled());
                                    ok->click();
                                });
    }

    static QPushButton* okOf(QDialog& dialog)
    {
        return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    }

    static void type(QWidget& dialog, const QString& key, const QString& words)
    {
        auto* field = dialog.findChild<QWidget*>(key)->findChild<QLineEdit*>();
        field->selectAll();
        QTest::keyClicks(field, words);
    }

    void typeInInspector(const char* key, const QString& words)
    {
        auto& inspector = window.docks().panel<Inspector>();
        QTRY_VERIFY(inspector.field(key)); // shows what is selected soon
        auto* field = qobject_cast<QLineEdit*>(inspector.field(key));
        QVERIFY(field);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, words);
        QTest::keyClick(field, Qt::Key_Return);
    }

    Id partCalled(const char* name) const
    {
        Id found = noId;
        forEachPart(scene(), [&](Id id, const Part& part) {
            if (part.name == name)
                found = id;
        });
        return found;
    }
    Id sail() const // the part that came last
    {
        Id found = noId;
        forEachPart(scene(), [&](Id id, const Part&) { found = id; });
        return found;
    }
    const Part& part(Id id) const { return *findItem<Part>(scene(), id); }
    Id itemCalled(const char* name) const
    {
        for (const Entry& entry : scene().items)
            if (nameOf(entry.item) == name)
                return entry.id;
        return noId;
    }

    void click(QPointF place) { drag(place, place); }
    void drawAround(const std::vector<QPointF>& corners)
    {
        press(corners.front());
        for (std::size_t i = 1; i < corners.size(); ++i)
            move(corners[i - 1], corners[i]);
        release(corners.back());
    }
};

} // namespace

class TestWorkshop : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    std::unique_ptr<Shop> m_shop;
    std::string m_begin;

    // Each step of the day is one step of the history.
    void expectSteps(int steps) { QCOMPARE(m_shop->document.history().count(), steps); }

private slots:
    void initTestCase() { m_shop = std::make_unique<Shop>(); }
    void cleanupTestCase() { m_shop.reset(); }

    void beginsWithNothing()
    {
        m_shop->run("new");
        QVERIFY(m_shop->scene().items.empty());
        m_begin = sceneText(m_shop->scene());
    }

    void insertsAKiteOfAnotherSpan()
    {
        Shop& shop = *m_shop;
        shop.during<BuilderDialog>([&] { shop.run("insert delta_kite"); },
                                   [&](BuilderDialog& dialog) {
                                       shop.type(dialog, "span", "220 cm");
                                       QTRY_VERIFY(shop.okOf(dialog)->isEnabled());
                                       shop.okOf(dialog)->click();
                                   });
        const Id kite = shop.partCalled("kite");
        QVERIFY(kite != noId);
        QCOMPARE(shop.part(kite).parameters.at("span"), 2.2);
        expectSteps(1);
    }

    void importsASail()
    {
        Shop& shop = *m_shop;
        const QString file = writeFile(m_folder.filePath("sail.obj"),
                                       QByteArray::fromStdString(sheet(4, 1.0, true)));
        QTimer watch;
        connect(&watch, &QTimer::timeout, this, [&] {
            auto* dialog = qobject_cast<ImportDialog*>(QApplication::activeModalWidget());
            if (!dialog || !dialog->isSettled())
                return;
            watch.stop();
            QTest::mouseClick(shop.okOf(*dialog), Qt::LeftButton);
        });
        watch.start(10);
        shop.window.arrivals().importMesh(file);
        QCOMPARE(shop.part(shop.sail()).particles.size(), 25U);
        expectSteps(2);
    }

    void weldsPinsAndWeighs()
    {
        Shop& shop = *m_shop;
        const Id sail = shop.sail();
        const auto& rows = shop.part(sail).particles;
        shop.selection.set({rows[0].id, rows[1].id});
        shop.during<OperationDialog>([&] { shop.run("weld"); },
                                     [&](OperationDialog& dialog) {
                                         auto* which = dialog.findChild<QWidget*>("which");
                                         auto* choice = qobject_cast<QComboBox*>(which);
                                         if (!choice)
                                             choice = which->findChild<QComboBox*>();
                                         choice->setCurrentIndex(1); // all into one
                                         QTRY_VERIFY(shop.okOf(dialog)->isEnabled());
                                         shop.okOf(dialog)->click();
                                     });
        QCOMPARE(shop.part(sail).particles.size(), 24U);
        expectSteps(3);

        shop.selection.set({shop.part(sail).particles.back().id});
        shop.pressKey(Qt::Key_P);
        QVERIFY(shop.part(sail).particles.back().pinned);
        expectSteps(4);

        shop.selection.set({sail});
        shop.operate("mass", {{"amount", "0.24"}}); // in all
        double mass = 0.0;
        for (const Particle& particle : shop.part(sail).particles)
            mass += particle.mass;
        QVERIFY(std::abs(mass - 0.24) < 1e-12);
        expectSteps(5);
    }

    void givesTheSailAnotherFabric()
    {
        Shop& shop = *m_shop;
        std::vector<Id> panels;
        for (const Panel& panel : shop.part(shop.sail()).panels)
            panels.push_back(panel.id);
        shop.selection.set(panels);
        const Id fabric = shop.itemCalled("keel cloth");
        QVERIFY(fabric != noId);
        shop.typeInInspector("material", "keel cloth");
        for (const Panel& panel : shop.part(shop.sail()).panels)
            QCOMPARE(panel.material, fabric);
        expectSteps(6);
    }

    void takesTheLeadingEdgeByLasso()
    {
        Shop& shop = *m_shop;
        QTRY_VERIFY_WITH_TIMEOUT(shop.player.frame(), patience);
        shop.viewport.setOrthographic(true);
        shop.viewport.setFollow(false);
        shop.viewport.view(PresetView::Top);
        shop.viewport.fit({shop.partCalled("kite")});
        shop.run("takeLinks"); // particles only
        shop.run("takePanels");
        shop.run("through");
        shop.run("toolLasso");
        // around the group that the builder has made of the leading edge
        const auto& edge = findItem<Group>(shop.scene(), shop.itemCalled("leading edge"))->members;
        QVERIFY(edge.size() > 10);
        QPointF least(1e9, 1e9), most(-1e9, -1e9);
        for (const Id id : edge) {
            const QPointF place = shop.at(shop.now(id));
            least = {std::min(least.x(), place.x()), std::min(least.y(), place.y())};
            most = {std::max(most.x(), place.x()), std::max(most.y(), place.y())};
        }
        least -= QPointF(12, 12);
        most += QPointF(12, 12);
        shop.drawAround({least, {most.x(), least.y()}, most, {least.x(), most.y()}, least});
        const auto& taken = shop.selection.ids();
        QVERIFY(std::ranges::includes(taken, edge));
        shop.run("takeLinks");
        shop.run("takePanels");
        shop.run("toolPointer");
        expectSteps(6); // a selection is no edit
    }

    void makesRigidityParticles()
    {
        Shop& shop = *m_shop;
        shop.selection.set(findItem<Group>(shop.scene(), shop.itemCalled("leading edge"))->members);
        const std::size_t before = shop.part(shop.partCalled("kite")).particles.size();
        shop.operate("rigidity", {{"distance", "25 cm"}});
        QCOMPARE(shop.part(shop.partCalled("kite")).particles.size(), before + 2);
        expectSteps(7);
    }

    void linksALineByClicks()
    {
        Shop& shop = *m_shop;
        const Part& sail = shop.part(shop.sail());
        shop.viewport.view(PresetView::Front);
        shop.viewport.fit({shop.sail()});
        const Id corner = sail.particles.front().id;
        QTRY_VERIFY(std::ranges::count(shop.frame().layout->particleId, std::uint32_t(corner)));
        const std::size_t links = sail.links.size();
        shop.run("drawLinks");
        shop.click(shop.at(shop.now(corner)));
        shop.click(shop.at(shop.now(corner)) + QPointF(-60.0, 40.0));
        shop.pressKey(Qt::Key_Escape);
        shop.pressKey(Qt::Key_Escape);
        QCOMPARE(shop.part(shop.sail()).links.size(), links + 1);
        expectSteps(8);
    }

    void fliesGrabsTearsAndTunes()
    {
        Shop& shop = *m_shop;
        shop.pressKey(Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(shop.frame().step > 10, patience);

        const Part& sail = shop.part(shop.sail());
        const Id held = sail.particles.back().id;
        shop.run("toolGrab");
        const QPointF from = shop.at(shop.now(sail.particles[12].id));
        shop.press(from);
        shop.move(from, from + QPointF(30.0, -30.0));
        QTRY_VERIFY_WITH_TIMEOUT(shop.frame().held, patience);
        shop.release(from + QPointF(30.0, -30.0));

        shop.run("toolCut");
        const QPointF pin = shop.at(shop.now(held));
        shop.drag(pin + QPointF(-80.0, -80.0), pin + QPointF(80.0, 80.0));
        shop.drag(pin + QPointF(-80.0, 80.0), pin + QPointF(80.0, -80.0));
        QTRY_VERIFY_WITH_TIMEOUT(std::ranges::count(shop.frame().torn, std::uint8_t(1)) > 0
                                     || shop.frame().layout->torn,
                                 patience);
        shop.run("toolPointer");

        // a value of a material, while it flies
        shop.selection.set({shop.itemCalled("line")});
        const auto generation = shop.frame().generation;
        shop.typeInInspector("compliance", "2e-5");
        QCOMPARE(findItem<Material>(shop.scene(), shop.itemCalled("line"))->compliance, 2e-5);
        QTRY_VERIFY_WITH_TIMEOUT(shop.frame().generation > generation, patience);
        QVERIFY(shop.frame().step > 10); // it did not start over
        expectSteps(9);
        shop.pressKey(Qt::Key_Space);
    }

    void undoesEverythingAndDoesItAgain()
    {
        Shop& shop = *m_shop;
        const std::string end = sceneText(shop.scene());
        QUndoStack& history = shop.document.history();
        while (history.canUndo())
            shop.run("undo");
        Scene begin = shop.scene();
        begin.nextId = Scene{}.nextId; // a number that was used once is not used again
        QCOMPARE(sceneText(begin), m_begin);
        while (history.canRedo())
            shop.run("redo");
        QCOMPARE(sceneText(shop.scene()), end);
    }

    void savesAndOpensAgain()
    {
        Shop& shop = *m_shop;
        const QString file = m_folder.filePath("day.ripstop.json");
        QVERIFY(!shop.document.save(file));
        QVERIFY(!shop.window.isWindowModified());
        Document again;
        QVERIFY(!again.open(file));
        QVERIFY(again.scene() == shop.scene());
    }
};

const RegisteredTest registered("test_workshop", runWithView<TestWorkshop>);

} // namespace ripstop::test_workshop
#include "test_workshop.moc"
