// The study panel in the window: a study made by pointing at properties, flown in the background,
// and what is done with a flight of its map.
#include "app/study_shop.h"
#include "model/files.h"

#include "document/recordings.h"
#include "inspector/value_edit.h"
#include "scene/path.h"
#include "study/design_gallery.h"
#include "study/flight_curves.h"
#include "study/goal_chart.h"
#include "study/goal_form.h"
#include "study/kept_runs.h"
#include "study/study_chart.h"
#include "study/study_form.h"

#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QLabel>
#include <QProgressBar>
#include <QSpinBox>
#include <QToolTip>
#include <qcustomplot.h>

#include <set>

namespace ripstop::test_study_panel {

namespace {

constexpr Id weight{4}; // of the pendulum

} // namespace

class TestStudyPanel : public QObject
{
    Q_OBJECT

private slots:
    void saysWhatItIsFor()
    {
        StudyShop shop;
        QVERIFY(shop.window.docks().show("study"));
        QVERIFY(!shop.panel.view().isVisible());
        QPushButton& open = shop.button("Open a study…");
        QVERIFY(open.isVisible());
        // in a low panel it is scrolled to, not cut
        shop.panel.parentWidget()->resize(shop.panel.width(), 90);
        auto* area =
            qobject_cast<QScrollArea*>(open.parentWidget()->parentWidget()->parentWidget());
        QVERIFY(area);
        const QWidget* page = area->widget();
        QVERIFY(page->height() >= page->heightForWidth(page->width()));
    }

    // The menu of a property's name in the inspector has it; it brings the panel forward.
    void pointingAtAPropertyMakesAStudy()
    {
        StudyShop shop;
        shop.selection.set({weight});
        QAction* study = nullptr;
        for (QAction* action : shop.window.docks().panel<Inspector>().findChildren<QAction*>())
            if (action->text() == "Study this…"
                && qobject_cast<QLabel*>(action->parent())->text().startsWith("Mass"))
                study = action;
        QVERIFY(study);
        study->trigger();
        QTest::qWait(50);
        QVERIFY(shop.panel.isVisible());
        const Study& made = shop.panel.form().study();
        QCOMPARE(made.variables.size(), std::size_t(1));
        QCOMPARE(made.variables[0].paths, (std::vector<std::string>{"#4.mass"}));
        // from half of the kilogram to twice of it, by even factors
        QCOMPARE(made.variables[0].values,
                 (std::vector<std::string>{"0.5", "0.707106781187", "1", "1.41421356237", "2"}));
    }

    void fliesWatchesAndApplies()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Particle, "mass"), {weight});
        shop.shelf().study(shop.property(Kind::Settings, "gravity"), {settingsId});
        shop.setSeconds(0.1);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 25,
                                 patience);
        QVERIFY(QFile::exists(shop.folder.filePath("a.ripstop-study.json")));
        QVERIFY(QFile::exists(shop.folder.filePath("a.ripstop-runs/shard-1-of-1.jsonl")));
        QCOMPARE(shop.panel.runner().tally().stopped, std::size_t(0));

        // a click on a cell chooses it: the third mass at the first gravity, half of the usual one
        StudyChart& chart = shop.panel.view().chart();
        QTest::qWait(50);
        QTest::mouseClick(&chart.plot(), Qt::LeftButton, {}, chart.placeOf(10).toPoint());
        QVERIFY(shop.panel.view().chosen() == std::size_t(10));
        QTest::mouseClick(&shop.button("Watch"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone(), patience);
        QVERIFY2(shop.lastSaid().contains("the same to the bit"),
                 qPrintable(shop.lastSaid() + shop.panel.state()));
        const auto& runs = shop.window.recordings().list();
        QCOMPARE(runs.size(), std::size_t(1));
        QVERIFY(runs[0]->name().find("mass 1") != std::string::npos);
        QVERIFY(std::abs(runs[0]->timeOf(runs[0]->frameCount() - 1) - 0.1) < 0.01);

        const Scene before = shop.document.scene();
        QTest::mouseClick(&shop.button("Apply"), Qt::LeftButton);
        QCOMPARE(shop.document.scene().settings.gravity, Vec3(0.5 * before.settings.gravity));
        QCOMPARE(shop.document.history().count(), 1);
        shop.document.history().undo();
        QVERIFY(shop.document.scene() == before);
    }

    // Ctrl takes a cell to the selection, Shift the rectangle up to it, and a rubber band what is
    // in it; then their curves and ghosts.
    void comparesSeveralCells()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Particle, "mass"), {weight});
        shop.shelf().study(shop.property(Kind::Settings, "gravity"), {settingsId});
        shop.setSeconds(0.5);
        shop.panel.run();
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 25,
                                 patience);
        StudyView& view = shop.panel.view();
        QTest::qWait(50);
        QWidget& plot = view.chart().plot();
        const auto placeOf = [&](std::size_t point) {
            return view.chart().placeOf(point).toPoint();
        };
        const auto click = [&](std::size_t point, Qt::KeyboardModifiers keys) {
            QTest::mouseClick(&plot, Qt::LeftButton, keys, placeOf(point));
        };
        using Points = std::vector<std::size_t>;
        click(0, {});
        QVERIFY(!shop.button("Compare").isEnabled());
        click(6, Qt::ControlModifier);
        QCOMPARE(view.selected(), (Points{0, 6}));
        click(6, Qt::ControlModifier);
        QCOMPARE(view.selected(), (Points{0}));
        click(0, {});
        click(6, Qt::ShiftModifier); // masses 0 and 1 with gravities 0 and 1
        QCOMPARE(std::set(view.selected().begin(), view.selected().end()),
                 (std::set<std::size_t>{0, 1, 5, 6}));
        StudyShop::drag(plot, placeOf(18) + QPoint(-4, 4), placeOf(24) + QPoint(4, -4));
        QCOMPARE(std::set(view.selected().begin(), view.selected().end()),
                 (std::set<std::size_t>{18, 19, 23, 24}));

        QTest::mouseClick(&shop.button("Compare 4"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && view.curves().isVisible(), patience);
        QCOMPARE(view.curves().curves().size(), std::size_t(4));
        QCOMPARE(view.curves().plot().plottableCount(), 4);
        for (const FlightCurve& one : view.curves().curves()) {
            const auto kept = shop.panel.runner().kept(one.point);
            QVERIFY(kept && kept->isSame);
            // a sample at the start and after each of its steps
            QCOMPARE(std::int64_t(one.flight->curves.time.size()), one.flight->flight.steps + 1);
        }
        // one is looked at, and the others are its ghosts, over it or beside it
        const Recordings& recordings = shop.window.recordings();
        QCOMPARE(recordings.list().size(), std::size_t(1));
        QCOMPARE(recordings.ghosts().size(), std::size_t(3));
        QVERIFY(recordings.ghosts()[0].shift == Vec3(0.0, 0.0, 0.0));
        QVERIFY(shop.chooseIn("How the flights are shown in the view", 1));
        QVERIFY(recordings.ghosts()[0].shift == Vec3(3.0 * recordings.ghosts()[2].shift));
        QVERIFY(recordings.ghosts()[2].shift.norm() > 0.0);

        // a click on a curve chooses its flight, of those that are selected
        QCustomPlot& curves = view.curves().plot();
        curves.replot();
        const ProbeCurves& second = view.curves().curves()[1].flight->curves;
        const std::size_t middle = second.time.size() / 2;
        QTest::mouseClick(&curves, Qt::LeftButton, {},
                          QPointF(curves.xAxis->coordToPixel(second.time[middle]),
                                  curves.yAxis->coordToPixel(second.value[0][middle]))
                              .toPoint());
        // or one that lies on it, as masses fall alike
        const auto clicked = std::ranges::find(view.curves().curves(), view.chosen().value_or(99),
                                               &FlightCurve::point);
        QVERIFY(clicked != view.curves().curves().end());
        const auto height = [&](const ProbeCurves& read) {
            return curves.yAxis->coordToPixel(read.value[0][middle]);
        };
        QVERIFY(std::abs(height(clicked->flight->curves) - height(second)) < 2.0); // px
        QCOMPARE(view.selected().size(), std::size_t(4));
        // and what was flown again is kept
        QTest::mouseClick(&shop.button("Watch"), Qt::LeftButton);
        QVERIFY(shop.isDone());
        QCOMPARE(recordings.list().size(), std::size_t(2));
    }

    void comparingCanBeStopped()
    {
        StudyShop shop("delta_kite");
        shop.shelf().study(shop.property(Kind::Settings, "airDensity"), {settingsId});
        shop.setSeconds(0.05);
        shop.panel.run();
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 5, patience);
        shop.panel.view().select({0, 1, 2, 3, 4});
        QTest::mouseClick(&shop.button("Compare 5"), Qt::LeftButton);
        QCOMPARE(shop.panel.runner().task(), StudyRunner::Task::Comparing);
        QTest::mouseClick(&shop.button("Stop"), Qt::LeftButton);
        QVERIFY(shop.isDone());
        QVERIFY(!shop.panel.view().curves().isVisible());
    }

    // What is typed stays in its field, also what does not come back from elsewhere.
    void fieldsShowWhatWillBeFlown()
    {
        StudyForm form;
        Study study;
        study.seconds = 10.0;
        study.variables = {rangeVariable(0.005, 0.01, 3, false)};
        study.variables[0].paths = {"settings.timeStep"};
        form.setStudy(study, [](const StudyVariable&) { return QString(); });
        const auto type = [&](const QString& name, const QString& text) {
            for (ValueEdit* edit : form.findChildren<ValueEdit*>())
                if (edit->accessibleName() == name) {
                    edit->selectAll();
                    QTest::keyClicks(edit, text);
                    QTest::keyClick(edit, Qt::Key_Return);
                    return edit->text();
                }
            return QString();
        };
        QCOMPARE(type("Each flight", "2"), QString("2"));
        QCOMPARE(form.study().seconds, 2.0);
        QCOMPARE(type("From", "0.004"), QString("0.004"));
        QCOMPARE(form.study().variables[0].spread->a, 0.004);
        QCOMPARE(type("To", "0.02"), QString("0.02"));
        QCOMPARE(form.study().variables[0].spread->b, 0.02);
    }

    // A parameter of a builder builds the part again; one step takes it back.
    void appliesWhatBuildersTake()
    {
        StudyShop shop("delta_kite");
        Study study;
        study.seconds = 0.02;
        const Id kite = *findNamed(shop.document.scene(), Kind::Part, "kite");
        const auto spanNow = [&] {
            return std::get<const Part*>(*find(shop.document.scene(), kite))->parameters.at("span");
        };
        StudyVariable span = rangeVariable(2.0, 2.2, 2, false);
        span.name = "span";
        span.paths = {"kite.built.span"};
        study.variables = {span};
        shop.shelf().study(shop.property(Kind::Settings, "airDensity"), {settingsId});
        shop.show(study);
        shop.panel.run();
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 2, patience);
        const Scene before = shop.document.scene();
        const int steps = shop.document.history().count();
        shop.panel.view().choose(1);
        QTest::mouseClick(&shop.button("Apply"), Qt::LeftButton);
        QVERIFY2(shop.lastSaid().contains("has the values"), qPrintable(shop.panel.state()));
        QCOMPARE(spanNow(), 2.2);
        QCOMPARE(shop.document.history().count(), steps + 1);
        shop.document.history().undo();
        QVERIFY(shop.document.scene() == before);
    }

    void stopsAndGoesOn()
    {
        StudyShop shop("delta_kite");
        shop.shelf().study(shop.property(Kind::Settings, "airDensity"), {settingsId});
        shop.setSeconds(5.0);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.panel.runner().task() == StudyRunner::Task::Flying, patience);
        QTest::mouseClick(&shop.button("Stop"), Qt::LeftButton);
        QVERIFY(shop.isDone());
        const std::size_t flown = shop.panel.runner().tally().flown;
        QVERIFY(flown < 5);
        shop.setSeconds(5.0); // the study as it is
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 5, patience);
        // the rows of what had been flown are still there, and none was flown twice
        QFile ledger(shop.folder.filePath("a.ripstop-runs/shard-1-of-1.jsonl"));
        QVERIFY(ledger.open(QIODevice::ReadOnly));
        QCOMPARE(ledger.readAll().count("{\"key\""), 5);
    }

    void aRedFieldSaysWhyInItsTip()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Particle, "mass"), {weight});
        auto* seconds = shop.panel.form().findChild<ValueEdit*>();
        seconds->selectAll();
        QTest::keyClicks(seconds, "long");
        const QPoint inside(5, 5);
        QHelpEvent asks(QEvent::ToolTip, inside, seconds->mapToGlobal(inside));
        QApplication::sendEvent(seconds, &asks);
        const QString tip = QToolTip::text();
        QVERIFY2(tip.contains("The time must be a number in s"), qPrintable(tip));
        QToolTip::hideText();
    }

    // The bar goes on within a flight, which may be ended in the middle: no row is kept of it.
    void progressGoesOnWithinAFlight()
    {
        StudyShop shop("delta_kite");
        shop.shelf().study(shop.property(Kind::Settings, "airDensity"), {settingsId});
        shop.setSeconds(1e4);
        const auto* bar = shop.panel.findChild<QProgressBar*>();
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.panel.runner().flown() > 0.002, patience);
        const double before = shop.panel.runner().flown();
        QTRY_VERIFY_WITH_TIMEOUT(shop.panel.runner().flown() > before, patience);
        QVERIFY(shop.panel.runner().flown() < 1.0);
        QVERIFY(bar->value() >= 0 && bar->maximum() >= 1000);
        QCOMPARE(shop.panel.runner().planned(), std::size_t(5));
        QTest::mouseClick(&shop.button("Stop"), Qt::LeftButton);
        QVERIFY(shop.isDone());
        QCOMPARE(shop.panel.runner().tally().flown, std::size_t(0));
        QCOMPARE(bar->value(), 0);
    }

    // A search by the form alone: what is wanted, how it is looked for, and the pictures of it.
    void looksForTheBest()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Particle, "mass"), {weight});
        shop.setSeconds(0.1);
        shop.choosePlan(StudyPlan::Kind::Optimise);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QVERIFY2(shop.panel.state().contains("objectives"), qPrintable(shop.panel.state()));
        QVERIFY(shop.panel.form().goals().isVisible());
        QTest::mouseClick(&shop.button("Want something…"), Qt::LeftButton);
        Study study = shop.panel.form().study();
        QCOMPARE(study.objectives.size(), std::size_t(1));
        QVERIFY(!study.objectives[0].measure.probe.empty());
        study.plan.population = 4;
        study.plan.generations = 3;
        shop.show(study);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().flights().size() == 12,
                                 patience);
        QVERIFY(shop.panel.runner().tally().flown == 12);
        QVERIFY(shop.choosePicture("Best so far"));
        GoalChart& chart = shop.panel.view().goals();
        QVERIFY(chart.isVisible());
        QCOMPARE(chart.pointCount(), 12);
        chart.plot().replot();
        QVERIFY(chart.plot().axisRect()->width() > 0.5 * chart.plot().width());
        const std::size_t wanted = shop.panel.runner().study()->wanted.front();
        const double first = shop.panel.runner().flights()[0]->measured[wanted];
        const double x = chart.plot().xAxis->coordToPixel(1.0);
        const double y = chart.plot().yAxis->coordToPixel(first);
        QTest::mouseClick(&chart.plot(), Qt::LeftButton, {}, QPointF(x, y).toPoint());
        QVERIFY(shop.panel.view().chosen() == std::size_t(0));
    }

    // The best stand first, as pictures of what their builder makes of their values, and a click
    // chooses the flight.
    void showsTheBestDesigns()
    {
        StudyShop shop("delta_kite");
        Study study;
        study.seconds = 0.02;
        study.variables = {{"span", {"kite.built.span"}, {"1.6", "2.4", "3.2"}, {}}};
        Objective high;
        high.measure.probe = shop.firstProbe();
        study.objectives = {high};
        shop.shelf().study(shop.property(Kind::Settings, "airDensity"), {settingsId});
        shop.show(study);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 3, patience);
        QVERIFY(shop.choosePicture("Best designs"));
        DesignGallery& gallery = shop.panel.view().designs();
        QVERIFY(gallery.isVisible());
        QCOMPARE(gallery.count(), 3);
        const StudyFlights& flights = shop.panel.runner().flights();
        const std::size_t wanted = shop.panel.runner().study()->wanted.front();
        for (std::size_t i = 1; i < 3; ++i)
            QVERIFY(flights[gallery.designs()[i - 1]]->measured[wanted]
                    <= flights[gallery.designs()[i]]->measured[wanted]);
        const auto picture = [&](int place) {
            return gallery.item(place)->icon().pixmap(gallery.iconSize()).toImage();
        };
        const QImage empty = [&] {
            QImage none = picture(0);
            none.fill(Qt::transparent);
            return none;
        }();
        for (const int place : {0, 1, 2})
            QTRY_VERIFY_WITH_TIMEOUT(picture(place) != empty, patience);
        QVERIFY(picture(0) != picture(1)); // another span is another shape
        QVERIFY(gallery.item(2)->text().contains("span "));
        QTest::mouseClick(gallery.viewport(), Qt::LeftButton, {},
                          gallery.visualItemRect(gallery.item(2)).center());
        QVERIFY(shop.panel.view().chosen() == gallery.designs()[2]);
        shop.panel.view().choose(gallery.designs()[1]);
        QCOMPARE(gallery.currentRow(), 1);
    }

    void showsTheFrontOfTwo()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Particle, "mass"), {weight});
        shop.setSeconds(0.1);
        shop.choosePlan(StudyPlan::Kind::Optimise);
        for (int i = 0; i < 2; ++i)
            QTest::mouseClick(&shop.button("Want something…"), Qt::LeftButton);
        Study study = shop.panel.form().study();
        QVERIFY(study.plan.method == StudyPlan::Method::Nsga2);
        study.objectives[1].goal = Goal::Minimise;
        study.plan.population = 4;
        study.plan.generations = 2;
        shop.show(study);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().flights().size() == 8,
                                 patience);
        QVERIFY(shop.choosePicture("Front"));
        QCOMPARE(shop.panel.view().goals().pointCount(), 8);
    }

    // Limits on measures and what is kept are edited in the form, and the file has them.
    void limitsAndWhatIsKept()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Particle, "mass"), {weight});
        shop.setSeconds(0.1);
        QTest::mouseClick(&shop.button("Limit something…"), Qt::LeftButton);
        QCOMPARE(shop.panel.form().study().constraints.size(), std::size_t(1));
        QDoubleSpinBox* limit = nullptr;
        for (QDoubleSpinBox* box : shop.panel.findChildren<QDoubleSpinBox*>())
            if (box->accessibleName() == "The limit")
                limit = box;
        QVERIFY(limit);
        limit->setValue(12.5);
        QVERIFY(shop.chooseIn("Which side is limited", 1));
        QVERIFY(shop.chooseIn("Which flights are kept with all of their frames", 3));
        shop.panel.run();
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 5, patience);
        const auto written = readStudy(shop.panel.file().toStdString());
        QVERIFY(written);
        QCOMPARE(written->constraints.size(), std::size_t(1));
        QVERIFY(written->constraints[0].kind == Constraint::Kind::AtLeast);
        QCOMPARE(written->constraints[0].limit, 12.5);
        QVERIFY(written->constraints[0].measure.reduction == Reduction::Largest);
        QVERIFY(written->keep == KeptRuns::All);
        const QDir runs(shop.folder.filePath("a.ripstop-runs"));
        QCOMPARE(runs.entryList({"*.ripstop-run"}).size(), 5);
        // what was kept is read and not flown again
        FlightResult row = *shop.panel.runner().flights()[2];
        const auto kept = readKeptRun(*shop.panel.runner().study(), 2, row);
        QVERIFY(kept && kept->recording);
        QVERIFY(!kept->curves.time.empty());
        row.hash = "0"; // a row that came to another state
        QVERIFY(!readKeptRun(*shop.panel.runner().study(), 2, row));
    }

    void showsWhatMatters()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Particle, "mass"), {weight});
        shop.shelf().study(shop.property(Kind::Settings, "airDensity"), {settingsId});
        shop.setSeconds(0.1);
        Study study = shop.panel.form().study();
        study.plan.kind = StudyPlan::Kind::Sensitivity;
        study.plan.count = 4;
        shop.show(study);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 16,
                                 patience);
        QVERIFY(shop.choosePicture("What matters"));
        QVERIFY(shop.panel.view().goals().isVisible());
    }

    void badFilesLeaveTheStudyThatIsOpen()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Particle, "mass"), {weight});
        shop.setSeconds(0.05);
        shop.panel.run();
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 5, patience);
        const QString broken = shop.folder.filePath("broken.ripstop-study.json");
        write(broken, R"({"format": "ripstop-study", "version": 1, "scene": "none.ripstop.json",
            "seconds": 1, "variables": [{"paths": ["a.b"], "values": [1]}]})");
        shop.panel.open(broken);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone(), patience);
        QVERIFY2(shop.panel.state().contains("none.ripstop.json"), qPrintable(shop.panel.state()));
        QCOMPARE(shop.panel.runner().tally().flown, std::size_t(5));
        QCOMPARE(shop.panel.file(), shop.folder.filePath("a.ripstop-study.json"));
    }

    // A text has no range to go over; that is said and nothing else happens.
    void whatCannotVaryIsSaid()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Settings, "title"), {settingsId});
        QVERIFY2(shop.lastSaid().contains("cannot be varied"), qPrintable(shop.lastSaid()));
    }
};

const RegisteredTest registered("test_study_panel", runWithView<TestStudyPanel>);

} // namespace ripstop::test_study_panel
#include "test_study_panel.moc"
