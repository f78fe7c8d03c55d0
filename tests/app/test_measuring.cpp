// Measuring what is selected, from the menu and by a right click in the view.
//
// Stages: probes from the menu, of one element, of several, of two particles, and of what cannot
// be measured; then the menu of a right click, and the peak in the legend.
#include "app/sheet_shop.h"

#include "builders/builder.h"
#include "document/spoken.h"
#include "overlays/legend.h"
#include "overlays/probe_labels.h"
#include "scene/path.h"
#include "select/measure.h"

#include <QRegularExpression>
#include <QStatusBar>

namespace ripstop::test_measuring {

class TestMeasuring : public QObject
{
    Q_OBJECT

private slots:
    // The new probe is selected, is one step of the history, and its value stands in the view.
    void fromTheMenu()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        const Id corner = Sheet::at(8, 4);
        shop.selection.set({corner});
        shop.run("measure_position_y");
        QCOMPARE(shop.document.history().count(), 1);
        QCOMPARE(shop.selection.ids().size(), std::size_t(1));
        const Id probe = shop.selection.ids().front();
        const Probe* added = findItem<Probe>(shop.document.scene(), probe);
        QVERIFY(added);
        QCOMPARE(added->target, corner);
        QVERIFY(shop.window.actions()["probeValues"]->isChecked());
        auto* labels = shop.viewport.findChild<ProbeLabels*>();
        const auto* row = std::get<const Particle*>(*find(shop.document.scene(), corner));
        QTRY_COMPARE(labels->linesOf(corner).join(""),
                     QString("position y  %1%2m")
                         .arg(QLocale().toString(row->position.y(), 'g', 4))
                         .arg(QChar(0x00a0)));
        shop.document.push(setValue(shop.document.scene(), probe, "name", std::string("tip")));
        QVERIFY(labels->linesOf(corner).join("").startsWith("tip  ")); // at once
        shop.document.history().undo();
        shop.document.history().undo();
        QVERIFY(!findItem<Probe>(shop.document.scene(), probe));
    }

    // However many there are, cards are low and leave most of the picture; what is not shown is
    // counted, so that all of it is told.
    void manyProbesLeaveThePicture()
    {
        Scene scene = Sheet().scene;
        int wanted = 0;
        const auto add = [&](Quantity quantity, Id target) {
            scene.items.push_back(
                {takeId(scene), Probe{"probe " + std::to_string(++wanted), quantity, target}});
        };
        for (int i = 0; i < 11; ++i)
            add(Quantity::MaxStrain, noId);
        for (int i = 0; i < 7; ++i)
            add(Quantity::PositionY, Sheet::at(4, 4));
        for (int column = 0; column < 8; ++column)
            for (int row = 3; row < 6; ++row)
                add(Quantity::PositionX, Sheet::at(row, column));
        Shop shop(scene);
        QTRY_VERIFY(shop.player.frame());
        shop.run("probeValues");
        auto* labels = shop.viewport.findChild<ProbeLabels*>();
        QTRY_VERIFY(!labels->shown().empty());
        const QRegularExpression more("and (\\d+) more in Plots");
        int told = 0;
        double covered = 0.0;
        for (const ProbeLabels::Shown& card : labels->shown()) {
            if (card.box.isEmpty())
                continue;
            covered += double(card.box.width()) * card.box.height();
            for (const QString& column : card.columns) {
                const QStringList lines = column.split('\n');
                QVERIFY(lines.size() <= 4);
                for (const QString& line : lines) {
                    const auto counted = more.match(line);
                    told += counted.hasMatch() ? counted.captured(1).toInt() : 1;
                }
            }
        }
        QCOMPARE(told, wanted);
        QVERIFY2(covered < 0.35 * labels->width() * labels->height(),
                 qPrintable(QString::number(covered / labels->width() / labels->height())));
    }

    // Several elements become a group that the probe looks at.
    void ofSeveral()
    {
        Shop shop(Sheet().scene);
        shop.selection.set({Sheet::at(0, 0), Sheet::at(1, 0), Sheet::at(2, 0)});
        shop.run("measure_speed");
        const Probe* added = findItem<Probe>(shop.document.scene(), shop.selection.ids().front());
        QVERIFY(added);
        const Group* group = findItem<Group>(shop.document.scene(), added->target);
        QVERIFY(group);
        QCOMPARE(group->members.size(), std::size_t(3));
        QCOMPARE(shop.document.history().count(), 1);
    }

    void betweenTwo()
    {
        Shop shop(Sheet().scene);
        shop.selection.set({Sheet::at(0, 0), Sheet::at(8, 4)});
        shop.run("measure_distance");
        const Probe* added = findItem<Probe>(shop.document.scene(), shop.selection.ids().front());
        QVERIFY(added);
        QCOMPARE(added->from, Sheet::at(0, 0));
        QCOMPARE(added->target, Sheet::at(8, 4));
    }

    // Cloth that one can buy has panels and no links.
    void strainOfElasticCloth()
    {
        const Builder& builder = *findBuilder("cloth");
        const Result<Scene> cloth = build(builder, newDesign(builder, {{"sphere", 0.0}}));
        QVERIFY(cloth);
        Shop shop(*cloth);
        const Id sheet = *findNamed(shop.document.scene(), Kind::Part, "sheet");
        for (const char* measure : {"measure_max_strain", "measure_margin", "measure_torn_links"}) {
            shop.selection.set({sheet});
            shop.run(measure);
            const Probe* added =
                findItem<Probe>(shop.document.scene(), shop.selection.ids().front());
            QVERIFY2(added && added->target == sheet, measure);
        }
    }

    // What cannot be measured there is said, and nothing changes.
    void ofTheWrongThing()
    {
        Shop shop(Sheet().scene);
        shop.selection.set({Sheet::at(0, 0)});
        shop.run("measure_tension");
        QCOMPARE(shop.document.history().count(), 0);
        QVERIFY(shop.window.statusBar()->currentMessage().contains("links"));
    }

    // A right click selects what is under it, but leaves a selection that it is part of.
    void rightClick()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        disconnect(&shop.viewport, &Viewport::menuWanted, nullptr, nullptr); // no menu in a test
        int asked = 0;
        connect(&shop.viewport, &Viewport::menuWanted, this, [&] { ++asked; });
        const QPointF place = shop.at(shop.now(Sheet::at(8, 4)));
        const Id under = shop.viewport.pick(place);
        QVERIFY(under != noId);
        const auto click = [&] {
            QTest::mouseClick(&shop.viewport, Qt::RightButton, {}, place.toPoint());
        };
        click();
        QCOMPARE(asked, 1);
        const std::vector<Id> one = shop.selection.ids();
        QCOMPARE(one.size(), std::size_t(1));
        std::vector<Id> two = {Sheet::at(0, 0), one.front()};
        std::ranges::sort(two);
        shop.selection.set(two);
        click();
        QCOMPARE(shop.selection.ids(), two);
    }

    // A click on the last line of the legend selects what has the largest value.
    void goesToThePeak()
    {
        Shop shop(Sheet().scene);
        shop.viewport.setColorBy(ColorBy::Speed);
        QVERIFY(shop.window.actions()["bySpeed"]->isChecked()); // whoever chose it
        shop.player.playUntil(0.05);
        QTRY_VERIFY(shop.player.frame() && shop.frame().time > 0.04 && !shop.player.isPlaying());
        auto* legend = shop.viewport.findChild<Legend*>();
        double fastest = 0.0;
        for (const Vec3& velocity : shop.frame().velocity)
            fastest = std::max(fastest, velocity.norm());
        QTRY_VERIFY(legend->isVisible());           // and of this frame
        const Spoken said = spoken(fastest, "m/s"); // hardly anything, in micrometres
        QTRY_COMPARE(legend->peakText(), "peak " + said.number);
        QCOMPARE(legend->unit(), said.unit);
        const QPoint peak(legend->width() / 2, legend->height() - legend->fontMetrics().height());
        QCOMPARE(shop.viewport.childAt(legend->mapToParent(peak)), legend);
        QTest::mouseClick(legend, Qt::LeftButton, {}, peak);
        QCOMPARE(shop.selection.ids().size(), std::size_t(1));
        const auto& ids = shop.frame().layout->particleId;
        const auto at = std::ranges::find(ids, std::uint32_t(shop.selection.ids().front()));
        QCOMPARE(shop.frame().velocity[std::size_t(at - ids.begin())].norm(), fastest);
    }
};

const RegisteredTest registered("test_measuring", runWithView<TestMeasuring>);

} // namespace ripstop::test_measuring
#include "test_measuring.moc"
