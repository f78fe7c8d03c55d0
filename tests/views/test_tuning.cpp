// Sliders that act while the design runs, and the panel that holds them.
//
// Stages: sliders over selections, drags as one step of undo, ranges; what acts on the next step
// of a run and how soon on a large design; then sets of values, resets, removed elements,
// refusals, and what is remembered for a file.
#include "builders/builder.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "inspector/inspector.h"
#include "inspector/mark_strip.h"
#include "inspector/tuning_panel.h"
#include "inspector/tuning_row.h"
#include "inspector/value_edit.h"
#include "materials/presets.h"
#include "small_scenes.h"
#include "thread_time.h"
#include "views/run_with_widgets.h"
#include "views/tuning_desk.h"

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

namespace ripstop::test_tuning {

using Desk = TuningDesk;

namespace {

const Property& stiffness = *findProperty(Kind::Material, "stiffness");
const Property& compliance = *findProperty(Kind::Material, "compliance");
const Property& mass = *findProperty(Kind::Particle, "mass");
const Property& limit = *findProperty(Kind::Control, "limit");
constexpr Id threadId{9}, control{14};

void type(QLineEdit* edit, const QString& text)
{
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
}

// A woven sheet of kite cloth; answers its threads.
Id showKiteCloth(Desk& desk)
{
    Scene scene = *build(*findBuilder("cloth"),
                         {{"columns", 4}, {"rows", 4}, {"membrane", 1000}, {"density", 0.2}});
    Id threads{};
    for (Entry& entry : scene.items)
        if (auto* material = std::get_if<Material>(&entry.item)) {
            give(*material, **findPreset("ripstop_075"));
            if (material->name == "structural")
                threads = entry.id;
        }
    desk.document.replace(scene);
    return threads;
}

ValueEdit* endOf(TuningRow* row, const char* name)
{
    for (ValueEdit* edit : row->findChildren<ValueEdit*>())
        if (edit->accessibleName() == name)
            return edit;
    return nullptr;
}

} // namespace

class TestTuning : public QObject
{
    Q_OBJECT

private slots:
    // A name of many words breaks; a number with its unit, and the button behind it, need their
    // room.
    void longNamesLeaveNumbersTheirRoom()
    {
        Desk desk;
        const Id threads = showKiteCloth(desk);
        desk.set(threads, "name", std::string("kite cloth of the left wing, sewn twice"));
        TuningRow* row = desk.add(*findProperty(Kind::Material, "membraneStiffness"), {threads});
        QVERIFY(row);
        QTest::qWait(50); // it is laid out
        const auto* edit = row->findChild<ValueEdit*>();
        const QString number = edit->text();
        QVERIFY(number.size() >= 4);
        const QMargins unit = edit->textMargins();
        QVERIFY(unit.right() > 0);
        QVERIFY2(edit->width() - unit.right() > edit->fontMetrics().horizontalAdvance(number) + 6,
                 qPrintable(QString::number(edit->width())));
        QVERIFY(row->width() <= desk.panel.width());
        for (const auto* button : row->findChildren<QToolButton*>())
            QVERIFY(button->mapTo(row, button->rect().bottomRight()).x() < row->width());
    }

    // Dacron of 350 kN/m has a slider up to four times as much.
    void endsOfARangeHaveTheirRoom()
    {
        Desk desk;
        const Id threads = showKiteCloth(desk);
        desk.set(threads, "membraneStiffness", 350e3);
        TuningRow* row = desk.add(*findProperty(Kind::Material, "membraneStiffness"), {threads});
        QVERIFY(row);
        QTest::qWait(50); // it is laid out
        for (const char* name : {"Left end", "Right end"}) {
            const ValueEdit* end = endOf(row, name);
            QVERIFY(end);
            QVERIFY2(end->width() > end->fontMetrics().horizontalAdvance(end->text()) + 4,
                     qPrintable(end->text()));
        }
        QVERIFY(endOf(row, "Right end")->text().size() >= 7);
        QVERIFY(row->width() <= desk.panel.width());
    }

    void aSliderStaysWhateverIsSelected()
    {
        Desk desk;
        QVERIFY(desk.says("No sliders yet"));
        TuningRow* row = desk.add(compliance, {threadId});
        QVERIFY(row && !desk.says("No sliders yet"));
        desk.selection.set({Id{3}});
        desk.selection.set({});
        QCOMPARE(desk.panel.findChildren<TuningRow*>().size(), 1);
        QVERIFY(row->isVisible());
    }

    // From press to release is one step of undo, with everything between acting at once.
    void aDragIsOneStep()
    {
        Desk desk;
        auto* bar = desk.add(mass, {Id{3}, Id{4}})->findChild<QSlider*>();
        const Value before = desk.value(Id{3}, mass);
        bar->setSliderDown(true);
        for (const int place : {100, 200, 300}) {
            bar->setSliderPosition(place);
            QVERIFY(desk.value(Id{3}, mass) != before);
            QCOMPARE(desk.value(Id{4}, mass), desk.value(Id{3}, mass));
        }
        bar->setSliderDown(false);
        QCOMPARE(desk.document.history().count(), 1);
        desk.document.history().undo();
        QCOMPARE(desk.value(Id{3}, mass), before);
    }

    // Half way on a logarithmic range from 1 to 10 000 is 100, typed ends and all.
    void theRangeIsEdited()
    {
        Desk desk;
        desk.set(Id{5}, "kind", std::string("spring"));
        TuningRow* row = desk.add(stiffness, {threadId});
        type(endOf(row, "Left end"), "1");
        type(endOf(row, "Right end"), "10 kN/m");
        auto* bar = row->findChild<QSlider*>();
        bar->setValue((bar->minimum() + bar->maximum()) / 2);
        QCOMPARE(desk.value(threadId, stiffness), Value(100.0));

        QTest::keyClicks(endOf(row, "Right end"), "x"); // no number: the range stays
        QVERIFY(desk.says("range"));
        QTest::keyClick(endOf(row, "Right end"), Qt::Key_Escape);
        QCOMPARE(row->slider().range.high, 1e4);
        type(endOf(row, "Right end"), "0.5"); // left of the left end
        QCOMPARE(row->slider().range.high, 1e4);
    }

    void whatDoesNothingSaysSo()
    {
        Desk desk;
        desk.add(stiffness, {threadId}); // its links are rods
        QVERIFY(desk.says("Does nothing now: its links are all rods"));
        for (const Id link : {Id{5}, Id{6}, Id{7}})
            desk.set(link, "kind", std::string("spring"));
        QVERIFY(!desk.says("Does nothing now"));
        QVERIFY(desk.says("3 links"));
    }

    // Speed falls to exp(-viscosity h) of itself in each step: the one after the slider moved has
    // the new viscosity, and the run goes on from where it was.
    void aSliderActsOnTheNextStep()
    {
        Desk desk;
        Scene scene = fallingPair();
        scene.settings.gravity = Vec3::Zero();
        scene.settings.viscosity = 1.0;
        for (Particle& row : std::get<Part>(scene.items.front().item).particles)
            row.velocity = Vec3(0.0, 0.0, 3.0);
        desk.document.replace(scene);
        Player player(desk.document);
        const Property& viscosity = *findProperty(Kind::Settings, "viscosity");
        auto* bar = desk.add(viscosity, {settingsId})->findChild<QSlider*>();
        const auto speed = [&] { return player.frame()->velocity[0].norm(); };
        player.step();
        player.step();
        QTRY_VERIFY(player.frame() && player.frame()->step == 2);
        double before = speed();
        QVERIFY(std::abs(before - 3.0 * std::exp(-0.02)) < 1e-12);
        std::int64_t steps = 2;
        bar->setSliderDown(true);
        for (const int share : {3, 4, 8}) { // while it is held, too
            bar->setSliderPosition(bar->minimum() + (bar->maximum() - bar->minimum()) * share / 10);
            const double now = std::get<double>(desk.value(settingsId, viscosity));
            QVERIFY(now != 1.0);
            player.step();
            ++steps;
            QTRY_COMPARE(player.frame()->step, steps);
            QVERIFY(std::abs(speed() - before * std::exp(-0.01 * now)) < 1e-12);
            before = speed();
        }
        bar->setSliderDown(false);
    }

    // Opening a slider on a design of 100 000 particles, and each move of it, leaves the window
    // time for 30 pictures a second. Compiling goes on in another thread.
    void aSliderOnALargeDesignBlocksNothing()
    {
        constexpr double most = 33.0 * slowdown; // ms of this thread
        Desk desk;
        auto cloth = build(*findBuilder("cloth"), {{"columns", 316}, {"rows", 316}});
        QVERIFY(cloth);
        desk.document.replace(std::move(*cloth));
        Player player(desk.document);
        QTRY_VERIFY_WITH_TIMEOUT(player.frame(), 60000);
        QVERIFY(player.frame()->position.size() > 100000);
        Id structural{};
        for (const Entry& entry : desk.document.scene().items)
            if (const auto* material = std::get_if<Material>(&entry.item);
                material && material->name == "structural")
                structural = entry.id;
        double begun = threadTime();
        TuningRow* row = desk.add(stiffness, {structural});
        QVERIFY(row);
        QVERIFY2(threadTime() - begun < most, "opening it");
        auto* bar = row->findChild<QSlider*>();
        bar->setSliderDown(true);
        for (int place = bar->minimum() + 100; place < bar->minimum() + 200; place += 10) {
            begun = threadTime();
            bar->setSliderPosition(place);
            QVERIFY2(threadTime() - begun < most, "a move");
        }
        bar->setSliderDown(false);
    }

    // Two sets: going there and back restores each; B begins as A.
    void setsAreCompared()
    {
        Desk desk;
        desk.add(mass, {Id{3}});
        desk.set(Id{3}, "mass", 0.1);
        desk.panel.switchSets();
        QCOMPARE(desk.value(Id{3}, mass), Value(0.1));
        const int wide = desk.panel.minimumSizeHint().width();
        desk.set(Id{3}, "mass", 0.7);
        QVERIFY(desk.says("from A"));
        // or the dock would grow while the slider is dragged, and its handle go from the mouse
        QCOMPARE(desk.panel.minimumSizeHint().width(), wide);
        desk.panel.switchSets();
        QCOMPARE(desk.value(Id{3}, mass), Value(0.1));
        desk.panel.switchSets();
        QCOMPARE(desk.value(Id{3}, mass), Value(0.7));
        desk.document.history().undo(); // a switch is an edit like any other
        QCOMPARE(desk.value(Id{3}, mass), Value(0.1));
        desk.panel.switchSets(); // it was undone, so that A is tuned, and B has kept its values
        QCOMPARE(desk.value(Id{3}, mass), Value(0.7));
        desk.document.history().undo();
        desk.document.history().redo();
        desk.panel.switchSets();
        QCOMPARE(desk.value(Id{3}, mass), Value(0.1));
    }

    void resetGoesBackToWhatWasKept()
    {
        Desk desk;
        desk.set(Id{3}, "mass", 0.1);
        desk.add(mass, {Id{3}});
        desk.add(limit, {control});
        const Value way = desk.value(control, limit);
        desk.set(Id{3}, "mass", 0.2);
        desk.set(control, "limit", 3.0);
        desk.panel.reset();
        QCOMPARE(desk.value(Id{3}, mass), Value(0.1));
        QCOMPARE(desk.value(control, limit), way);
        desk.document.history().undo(); // both in one step
        QCOMPARE(desk.value(Id{3}, mass), Value(0.2));
        QCOMPARE(desk.value(control, limit), Value(3.0));
        desk.panel.keep();
        desk.set(Id{3}, "mass", 0.3);
        desk.panel.reset();
        QCOMPARE(desk.value(Id{3}, mass), Value(0.2));
    }

    // Of two things that a slider moves one may go; with the last one the slider does, and undo
    // brings both back.
    void slidersOfWhatIsRemoved()
    {
        Desk desk;
        desk.add(limit, {control});
        const auto rows = [&] {
            QApplication::processEvents();
            const auto all = desk.panel.findChildren<TuningRow*>();
            return std::count_if(all.begin(), all.end(),
                                 [](const TuningRow* row) { return row->isVisible(); });
        };
        QCOMPARE(rows(), 1);
        desk.document.push({Message("Remove"), {RemoveItem{control}}});
        QCOMPARE(rows(), 0);
        QVERIFY(desk.says("No sliders yet"));
        desk.document.history().undo();
        QCOMPARE(rows(), 1);
    }

    void theUsualOnesActHere()
    {
        Desk desk;
        auto buttons = desk.panel.findChildren<QPushButton*>();
        const auto usual = std::find_if(buttons.begin(), buttons.end(), [](QPushButton* button) {
            return button->text().contains("usual") && button->isVisible();
        });
        QVERIFY(usual != buttons.end());
        (*usual)->click();
        const std::vector<Slider> sliders = desk.inspector.sliders().sliders();
        QVERIFY(sliders.size() >= 3);
        QVERIFY(!desk.says("Does nothing now"));
    }

    // Named cloths lie along E t: a drag near one takes its number exactly, a click on its name
    // too.
    void slidersHaveMarksOfTheLibrary()
    {
        Desk desk;
        const Property& stretch = *findProperty(Kind::Material, "membraneStiffness");
        const Id threads = showKiteCloth(desk);
        TuningRow* row = desk.add(stretch, {threads});
        QVERIFY(row);
        auto* strip = row->findChild<MarkStrip*>();
        QVERIFY(strip && strip->isVisible());
        QCOMPARE(row->slider().range, (SliderRange{10000.0, 160000.0, true}));
        const auto markOf = [&](double value) {
            const auto found = std::ranges::find(strip->marks(), value, &SliderMark::value);
            return found == strip->marks().end() ? nullptr : &*found;
        };
        QVERIFY(markOf(40000.0) && markOf(90000.0) && !markOf(350000.0)); // outside
        QCOMPARE(markOf(90000.0)->name, QString("Icarex"));
        QCOMPARE(markOf(40000.0)->name, QString("0.75 oz")); // the present one names a shared mark
        QVERIFY(markOf(40000.0)->tip.contains("Nylite"));

        auto* bar = row->findChild<QSlider*>();
        const int icarex = int(std::lround(placeOf(row->slider().range, 90000.0) * bar->maximum()));
        bar->setSliderDown(true);
        bar->setSliderPosition(icarex + 3);
        QCOMPARE(desk.value(threads, stretch), Value(90000.0));
        bar->setSliderPosition(icarex + 40); // far from any
        QVERIFY(desk.value(threads, stretch) != Value(90000.0));
        bar->setSliderDown(false);
        QCOMPARE(desk.document.history().count(), 1);

        const SliderMark& half = *markOf(26700.0);
        QTest::mouseClick(strip, Qt::LeftButton, {}, QPoint(strip->xOf(half), 1));
        QCOMPARE(desk.value(threads, stretch), Value(26700.0));
        desk.document.history().undo();
        desk.document.history().undo();
        QCOMPARE(desk.value(threads, stretch), Value(40000.0));
    }

    // An arrow key is a small step, also on a mark.
    void keysGoPastMarks()
    {
        Desk desk;
        const Property& stretch = *findProperty(Kind::Material, "membraneStiffness");
        const Id threads = showKiteCloth(desk);
        auto* bar = desk.add(stretch, {threads})->findChild<QSlider*>();
        QTest::keyClick(bar, Qt::Key_Right);
        const Value once = desk.value(threads, stretch);
        QTest::keyClick(bar, Qt::Key_Right);
        QVERIFY(std::get<double>(once) > 40000.0);
        QVERIFY(std::get<double>(desk.value(threads, stretch)) > std::get<double>(once));
    }

    // Of real cloth the usual sliders are those of the trade, of what is selected only these.
    void theUsualOnesAreOfTheTrade()
    {
        Desk desk;
        const Id threads = showKiteCloth(desk);
        const auto has = [&](const char* key) {
            return desk.inspector.sliders().has(*findProperty(Kind::Material, key), {threads});
        };
        desk.selection.set({threads});
        desk.panel.addUsual();
        QVERIFY(has("membraneStiffness") && has("warpStrength"));
        QVERIFY(!has("stiffness")); // which does nothing beside E t
        for (const Slider& slider : desk.inspector.sliders().sliders())
            QCOMPARE(slider.ids, std::vector<Id>{threads});
    }

    // A note that something does nothing has a link that changes that.
    void aRemedyIsALinkAway()
    {
        Desk desk;
        desk.add(stiffness, {threadId}); // its links are rods
        QVERIFY(desk.says("Does nothing now: its links are all rods"));
        for (QLabel* label : desk.panel.findChildren<QLabel*>())
            if (label->text().contains("Make springs"))
                emit label->linkActivated("0");
        QVERIFY(!desk.says("Does nothing now"));
        desk.document.history().undo();
        QVERIFY(desk.says("Does nothing now"));
    }

    void tooManyThingsAreRefused()
    {
        Desk desk;
        std::vector<Id> ids;
        for (std::uint32_t i = 0; i <= mostOfASlider; ++i)
            ids.push_back(Id{i + 100});
        const auto failure = desk.inspector.sliders().toggle(mass, ids);
        QVERIFY(failure
                && failure->message.english().find("tune the material") != std::string::npos);
    }

    // What is tuned belongs to the desk: it is there when the file is opened again, and the scene
    // is not modified by it.
    void slidersAreRememberedByFile()
    {
        QCoreApplication::setOrganizationName("ripstop-test");
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QTemporaryDir folder;
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
        const QString file = folder.filePath("a.ripstop.json");
        {
            Document document;
            document.replace(oneOfEverything());
            QVERIFY(!document.save(file));
            SliderShelf shelf(document);
            QVERIFY(!shelf.toggle(mass, {Id{3}}));
            QVERIFY(!document.isModified());
        }
        Document document;
        SliderShelf shelf(document);
        QVERIFY(!document.open(file));
        QVERIFY(shelf.has(mass, {Id{3}}));
        document.replace(oneOfEverything());
        QVERIFY(shelf.sliders().empty());
    }
};

const RegisteredTest registered("test_tuning", runWithWidgets<TestTuning>);

} // namespace ripstop::test_tuning
#include "test_tuning.moc"
