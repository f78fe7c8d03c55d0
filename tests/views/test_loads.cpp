// The panel of loads: what it says without strengths and before the run, that it lists what hangs
// on a line, and that a click leads there.
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "loads/load_list.h"
#include "loads/load_panel.h"
#include "model/real_craft.h"
#include "small_scenes.h"
#include "views/run_with_widgets.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

namespace ripstop::test_loads {

namespace {

// The pair of fallingPair(), one of which holds the other below it: 0.5 kg on the link 4.
Scene hangingPair(std::optional<double> strength)
{
    Scene scene = fallingPair();
    auto& part = std::get<Part>(*findItem(scene, Id{1}));
    part.particles[0].pinned = true;
    part.particles[1].position = Vec3(0, 9, 0);
    std::get<Material>(*findItem(scene, Id{5})).lineStrength = strength;
    return scene;
}

// That with a line of 3 N, which cannot hold the 4.9 N of its weight and breaks at once, and beside
// it another, of 10 N, that breaks when its weight has fallen 0.3 m and jerks it. Ids: link 4 of
// the first, link 12 of the second.
Scene breakingPairs()
{
    Scene scene = hangingPair(3.0);
    auto& material = std::get<Material>(*findItem(scene, Id{5}));
    material.tearRule = TearRule::Strength;
    Material other = material;
    other.name = "cord";
    other.lineStrength = 10.0; // N
    auto& part = std::get<Part>(*findItem(scene, Id{1}));
    part.particles.push_back({.id = Id{10}, .position = Vec3(2, 10, 0), .pinned = true});
    part.particles.push_back({.id = Id{11}, .position = Vec3(2, 9.3, 0), .mass = 0.5});
    part.links.push_back(rod(Id{12}, Id{10}, Id{11}, Id{13}));
    part.links.back().resists = Resists::Tension;
    scene.items.push_back({Id{13}, other});
    scene.nextId = Id{14};
    return scene;
}

struct Bench
{
    Document document;
    Selection selection{document};
    Player player{document};
    LoadPanel panel{document, selection, player};

    explicit Bench(Scene scene)
    {
        document.replace(std::move(scene));
        panel.resize(900, 250);
        panel.show();
    }
};

} // namespace

class TestLoads : public QObject
{
    Q_OBJECT

private slots:
    void saysWhatIsMissing()
    {
        Bench bench(hangingPair({}));
        QTRY_VERIFY(bench.panel.said().contains("No material here has a strength"));
        auto* button = bench.panel.findChild<QPushButton*>();
        QVERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(bench.selection.ids(), std::vector{Id{5}});
        bench.document.push(setValue(bench.document.scene(), Id{5}, "lineStrength", 40.0));
        QTRY_VERIFY(bench.panel.said().contains("Nothing bears a load yet"));
        QVERIFY(!button->isVisible());
    }

    // What would hold beyond its strength is named, and a click lets it tear, as one step back.
    void letsItTear()
    {
        Bench bench(hangingPair(40.0));
        QTRY_VERIFY(bench.player.frame());
        bench.player.playUntil(0.1);
        auto* note = bench.panel.findChild<QLabel*>("untearable");
        QTRY_VERIFY(note->isVisible());
        QVERIFY2(note->text().startsWith("Never tears: dacron."), qPrintable(note->text()));
        emit note->linkActivated(QStringLiteral("#"));
        const auto rule = [&] {
            return std::get<Material>(*findItem(bench.document.scene(), Id{5})).tearRule;
        };
        QCOMPARE(rule(), TearRule::Strength);
        QTRY_VERIFY(!note->isVisible());
        bench.document.history().undo();
        QCOMPARE(rule(), TearRule::Never);
        QTRY_VERIFY(note->isVisible());
    }

    void listsAndLeadsThere()
    {
        Bench bench(hangingPair(40.0));
        QTRY_VERIFY(bench.player.frame());
        bench.player.playUntil(0.1);
        QTRY_VERIFY(bench.panel.said().isEmpty());
        QTRY_COMPARE(bench.panel.now().topLevelItemCount(), 1);
        QTRY_COMPARE(bench.panel.ofRun().topLevelItemCount(), 1);
        const QTreeWidgetItem& row = *bench.panel.now().topLevelItem(0);
        // 0.5 kg x 9.80665 m/s^2 / 40 N = 0.123
        QTRY_COMPARE(row.text(LoadList::Margin), QString("0.123"));
        QCOMPARE(row.text(LoadList::Load), QString("4.9\u00a0N"));
        QCOMPARE(row.text(LoadList::Strength), QString("40\u00a0N"));
        QCOMPARE(row.text(LoadList::Place), QString("dacron, link 4"));

        // An instant that is looked back at knows the worst now, and of the run what the run knows.
        auto past = std::make_shared<Frame>(*bench.player.frame());
        past->worstOfRun = {};
        bench.player.lookAt(past);
        QTRY_VERIFY(bench.player.isLookingBack());
        QTest::qWait(300); // longer than the panel waits
        QCOMPARE(bench.panel.ofRun().topLevelItemCount(), 1);

        QSignalSpy chosen(&bench.panel, &LoadPanel::chosen);
        QTest::mouseClick(bench.panel.now().viewport(), Qt::LeftButton, {},
                          bench.panel.now().visualItemRect(&row).center());
        QCOMPARE(bench.selection.ids(), std::vector{Id{4}});
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].toUInt(), 4U);
    }

    // Of a run that it has not seen it knows the moment alone, and says so.
    void recordingsKeepNoListOfTheWorst()
    {
        Bench bench(hangingPair(40.0));
        QTRY_VERIFY(bench.player.frame());
        bench.player.playUntil(0.1);
        QTRY_COMPARE(bench.panel.ofRun().topLevelItemCount(), 1);
        const auto saysWhy = [&] {
            return std::ranges::any_of(bench.panel.findChildren<QLabel*>(), [](QLabel* label) {
                return label->isVisible() && label->text().contains("keeps no list of the worst");
            });
        };
        QVERIFY(!saysWhy());
        auto past = std::make_shared<Frame>(*bench.player.frame());
        past->worstOfRun = {};
        past->run += 100;
        bench.player.lookAt(past);
        QTRY_VERIFY(saysWhy());
        QCOMPARE(bench.panel.ofRun().topLevelItemCount(), 0);
        QCOMPARE(bench.panel.now().topLevelItemCount(), 1);
    }

    // After a reset one still reads what the run came to, until the next one has begun.
    void theWorstStaysAfterAReset()
    {
        Bench bench(hangingPair(40.0));
        QTRY_VERIFY(bench.player.frame());
        bench.player.playUntil(0.1);
        const QTreeWidget& list = bench.panel.ofRun();
        const auto title = [&] { return list.headerItem()->text(LoadList::Place); };
        QTRY_COMPARE(list.topLevelItemCount(), 1);
        QCOMPARE(title(), QString("Worst of the run"));
        bench.player.reset();
        QTRY_COMPARE(title(), QString("Of the last run"));
        QTRY_COMPARE(list.topLevelItemCount(), 1);
        QCOMPARE(list.topLevelItem(0)->text(LoadList::Margin), QString("0.123")); // as above

        // a run of half the mass begins: 0.25 kg x 9.80665 m/s^2 / 40 N = 0.0613
        bench.document.push(setValue(bench.document.scene(), Id{3}, "mass", 0.25));
        QCOMPARE(title(), QString("Of the last run"));
        bench.player.playUntil(0.1);
        QTRY_COMPARE(title(), QString("Worst of the run"));
        QTRY_COMPARE(list.topLevelItem(0)->text(LoadList::Margin), QString("0.0613"));

        bench.document.replace(hangingPair(40.0));
        QTRY_VERIFY(bench.panel.said().contains("Nothing bears a load yet"));
    }

    // What broke first stands first, though what broke later was loaded by more, and a click asks
    // for its moment and place. The fall of 0.3 m takes sqrt(2 x 0.3 / 9.80665) s = 0.247 s.
    void whatBrokeStandsInItsOrder()
    {
        Bench bench(breakingPairs());
        QTRY_VERIFY(bench.player.frame());
        bench.player.playUntil(0.4);
        const LoadList& list = bench.panel.ofRun();
        QTRY_COMPARE(list.topLevelItemCount(), 2);
        QCOMPARE(list.topLevelItem(0)->text(LoadList::Place), QString("1. dacron, link 4: torn"));
        QCOMPARE(list.topLevelItem(1)->text(LoadList::Place), QString("2. cord, link 12: torn"));
        const auto worst = bench.player.frame()->worstOfRun.all();
        QCOMPARE(worst[0].element, 12U);

        double time = -1.0;
        Vec3 place = Vec3::Zero();
        connect(&bench.panel, &LoadPanel::breakChosen, this,
                [&](quint64 run, double when, const Vec3& where) {
                    QCOMPARE(run, bench.player.run());
                    time = when;
                    place = where;
                });
        const QSignalSpy chosen(&bench.panel, &LoadPanel::chosen);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                          list.visualItemRect(list.topLevelItem(1)).center());
        QCOMPARE(bench.selection.ids(), std::vector{Id{12}});
        QVERIFY(chosen.isEmpty()); // it is no longer where it broke
        QVERIFY2(std::abs(time - 0.247) < 0.02, qPrintable(QString::number(time))); // two steps
        QVERIFY((place - Vec3(2.0, 9.5, 0.0)).norm() < 0.05);
    }

    // A line that tears by its length, long before its strength is used, has no green tick.
    void whatHasTornIsNeverWell()
    {
        Scene scene = hangingPair(1000.0);
        auto& material = std::get<Material>(*findItem(scene, Id{5}));
        material.tearRule = TearRule::Length;
        material.tearLimit = 0.9;
        Bench bench(std::move(scene));
        QTRY_VERIFY(bench.player.frame());
        bench.player.playUntil(0.1);
        QTRY_COMPARE(bench.panel.ofRun().topLevelItemCount(), 1);
        const QTreeWidgetItem& row = *bench.panel.ofRun().topLevelItem(0);
        QVERIFY(row.text(LoadList::Place).endsWith("torn"));
        const QColor sign = row.icon(LoadList::Margin).pixmap(16, 16).toImage().pixelColor(8, 2);
        QVERIFY2(sign.red() > sign.green(), qPrintable(sign.name()));
    }

    // What comes into the design during a run, as by an import, leaves the worst of the run: here
    // another material with a strength.
    void theWorstStaysWithWhatComes()
    {
        Bench bench(hangingPair(40.0));
        QTRY_VERIFY(bench.player.frame());
        bench.player.playUntil(0.1);
        QTRY_COMPARE(bench.panel.ofRun().topLevelItemCount(), 1);
        Material cloth;
        cloth.name = "cloth";
        cloth.warpStrength = cloth.weftStrength = 600.0; // N/m
        Scene next = bench.document.scene();
        const Id id = takeId(next);
        bench.document.push({Message("Import"), {AddItem{next.items.size(), {id, cloth}}}});
        bench.player.playUntil(0.2);
        QTRY_VERIFY(bench.player.isCurrent() && bench.player.frame()->time > 0.19);
        QTest::qWait(300); // longer than the panel waits
        QCOMPARE(bench.panel.ofRun().topLevelItemCount(), 1);
        QVERIFY(bench.player.frame()->worstOfRun.all()[0].time < 0.1);
    }

    // In the lists of a window of 1280 pixels, names stand whole, and what a place can bear gives
    // way to them; a wide list has both.
    void namesHaveTheirRoom()
    {
        Scene scene = hangingPair(40.0);
        std::get<Material>(*findItem(scene, Id{5})).name = "suspension line";
        LoadedPlace place;
        place.element = place.whole = 4;
        place.kind = LoadKind::Cloth;
        place.load = 173.0;      // N/m
        place.strength = 6400.0; // N/m
        LoadList list("Places", "Places");
        list.hideColumn(LoadList::Time);
        list.show();
        for (const int width : {320, 900, 320}) {
            list.resize(width, 150);
            list.showPlaces(scene, std::vector{place});
            QCoreApplication::processEvents();
            QTRY_COMPARE(list.isColumnHidden(LoadList::Strength), width < 900);
            const QTreeWidgetItem& row = *list.topLevelItem(0);
            const int words =
                list.fontMetrics().horizontalAdvance(row.text(LoadList::Place)); // "suspen... 4"
            QVERIFY(list.columnWidth(LoadList::Place) > words);
            QVERIFY(row.toolTip(LoadList::Place).contains("suspension line, link 4"));
            QVERIFY(row.toolTip(LoadList::Load).contains("6400\u00a0N/m"));
            list.showPlaces(scene, {});
            QCOMPARE(list.isColumnHidden(LoadList::Strength), width < 900); // as before
        }
    }

    // Places change their ranks while one looks at them; those that tore say so.
    void markGoesWithThePlace()
    {
        const Scene scene = hangingPair(40.0);
        LoadList list("Places", "Places");
        const auto placeOf = [](std::uint32_t link, double load, bool torn) {
            LoadedPlace place;
            place.element = place.whole = link;
            place.load = load;
            place.strength = 10.0;
            place.torn = torn;
            return place;
        };
        const LoadedPlace one = placeOf(4, 12.0, true), other = placeOf(5, 1.0, false);
        list.showPlaces(scene, std::vector{one, other});
        QVERIFY(list.topLevelItem(0)->text(LoadList::Place).endsWith("torn"));
        QVERIFY(!list.topLevelItem(1)->text(LoadList::Place).contains("torn"));
        list.topLevelItem(0)->setSelected(true);
        list.showPlaces(scene, std::vector{other, one});
        QVERIFY(!list.topLevelItem(0)->isSelected() && list.topLevelItem(1)->isSelected());
        list.showPlaces(scene, std::vector{other});
        QVERIFY(list.selectedItems().isEmpty());
    }

    // A bob that is let go half a metre above the end of its line jerks it, and hangs there then:
    // the list says that its worst is the launch. One that hangs from the start says nothing.
    void tellsOfTheLaunch()
    {
        const auto launchOf = [](double above) {
            Scene scene = hangingPair(400.0);
            auto& part = std::get<Part>(*findItem(scene, Id{1}));
            part.particles.back().position.y() += above;
            scene.settings.viscosity = 2.0;
            Bench bench(std::move(scene));
            bench.player.playUntil(4.0);
            const auto isTold = [&] {
                for (QLabel* label : bench.panel.findChildren<QLabel*>())
                    if (label->isVisible() && label->text().contains("launch"))
                        return true;
                return false;
            };
            return QTest::qWaitFor(
                       [&] { return bench.player.frame() && bench.player.frame()->time > 3.9; })
                   && QTest::qWaitFor(isTold, 1000);
        };
        QVERIFY(launchOf(0.3));
        QVERIFY(!launchOf(0.0));
    }

    // Margins of canopies are too good when they open, and the list says so, with a remedy.
    void saysThatOpeningLoadsAreLow()
    {
        Bench bench(craft("parachute", nylon({{"pressure", 1.68}})));
        bench.player.playUntil(0.1);
        auto* note = bench.panel.findChild<QLabel*>("opening");
        QTRY_VERIFY(note->isVisible());
        emit note->linkActivated("#");
        QCOMPARE(bench.document.scene().settings.safetyFactor, 1.7);
        QTRY_VERIFY(!note->isVisible());
    }

    // A list that is silent of some elements says so.
    void namesWhatIsNotJudged()
    {
        Scene scene = hangingPair(40.0);
        Material tail;
        tail.name = "tail";
        scene.items.push_back({takeId(scene), tail});
        const Id material = scene.items.back().id;
        auto& part = std::get<Part>(*findItem(scene, Id{1}));
        part.particles.push_back({.id = takeId(scene), .position = Vec3(0, 8, 0), .mass = 0.1});
        part.links.push_back(rod(takeId(scene), Id{3}, part.particles.back().id, material));
        Bench bench(std::move(scene));
        bench.player.playUntil(0.1);
        const auto notJudged = [&]() -> QLabel* {
            for (QLabel* label : bench.panel.findChildren<QLabel*>())
                if (label->isVisible() && label->text().contains("Not judged"))
                    return label;
            return nullptr;
        };
        QTRY_VERIFY(notJudged());
        QVERIFY(notJudged()->text().contains("tail") && !notJudged()->text().contains("dacron"));
        emit notJudged()->linkActivated("#");
        QCOMPARE(bench.selection.ids(), std::vector{material});
        bench.document.push(setValue(bench.document.scene(), material, "lineStrength", 20.0));
        QTRY_VERIFY(!notJudged());
    }
};

const RegisteredTest registered("test_loads", runWithWidgets<TestLoads>);

} // namespace ripstop::test_loads
#include "test_loads.moc"
