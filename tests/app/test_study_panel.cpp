// The study panel in the window: a study made by pointing at properties, flown in the background,
// and what is done with a flight of its map.
#include "app/window_shop.h"
#include "model/files.h"

#include "document/recordings.h"
#include "inspector/inspector.h"
#include "study/goal_chart.h"
#include "study/goal_form.h"
#include "study/study_chart.h"
#include "study/study_form.h"
#include "study/study_panel.h"
#include "study/study_view.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <qcustomplot.h>

namespace ripstop::test_study_panel {

namespace {

constexpr int patience = 60'000; // ms; other work may be on the machine

// A window with a copy of a sample in a folder of its own.
struct StudyShop : WindowShop
{
    QTemporaryDir folder;
    StudyPanel& panel = window.docks().panel<StudyPanel>();
    QSignalSpy said{&panel, &StudyPanel::said};

    explicit StudyShop(const char* sample = "pendulum")
    {
        const QString file = folder.filePath("a.ripstop.json");
        QFile::copy(QString(SCENES_DIR "/%1.ripstop.json").arg(sample), file);
        if (document.open(file))
            qFatal("the sample cannot be opened");
        window.resize(1280, 900);
        window.show();
    }

    SliderShelf& shelf() { return window.docks().panel<Inspector>().sliders(); }
    const Property& property(Kind kind, const char* key) { return *findProperty(kind, key); }
    QPushButton& button(const QString& words)
    {
        for (QPushButton* one : panel.findChildren<QPushButton*>())
            if (one->text().remove('&') == words)
                return *one;
        qFatal("there is no such button");
    }
    void setSeconds(double seconds)
    {
        Study study = panel.form().study();
        study.seconds = seconds;
        show(study);
    }
    // In the form, as a person would have made it.
    void show(const Study& study)
    {
        QStringList probes;
        for (const Entry& entry : document.scene().items)
            if (const auto* probe = std::get_if<Probe>(&entry.item))
                probes << QString::fromStdString(probe->name);
        panel.form().setStudy(
            study, [](const StudyVariable&) { return QString(); }, probes);
        emit panel.form().edited();
    }
    bool chooseIn(const QString& name, int place)
    {
        for (QComboBox* box : panel.findChildren<QComboBox*>())
            if (box->accessibleName() == name && place >= 0 && place < box->count()) {
                box->setCurrentIndex(place);
                emit box->activated(place);
                return true;
            }
        return false;
    }
    void choosePlan(StudyPlan::Kind kind)
    {
        for (QComboBox* box : panel.findChildren<QComboBox*>())
            if (box->accessibleName() == "Points" && !chooseIn("Points", box->findData(int(kind))))
                qFatal("there is no such plan");
    }
    bool choosePicture(const QString& words)
    {
        for (QComboBox* box : panel.findChildren<QComboBox*>())
            if (box->accessibleName() == "Picture")
                return box->isVisible() && chooseIn("Picture", box->findText(words));
        return false;
    }
    bool isDone() const { return panel.runner().task() == StudyRunner::Task::None; }
    QString lastSaid() const { return said.isEmpty() ? QString() : said.last().first().toString(); }
};

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
        QVERIFY(shop.button("Open a study…").isVisible());
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
        const std::size_t wanted = shop.panel.runner().study()->wanted.front();
        const double first = shop.panel.runner().flights()[0]->measured[wanted];
        const double x = chart.plot().xAxis->coordToPixel(1.0);
        const double y = chart.plot().yAxis->coordToPixel(first);
        QTest::mouseClick(&chart.plot(), Qt::LeftButton, {}, QPointF(x, y).toPoint());
        QVERIFY(shop.panel.view().chosen() == std::size_t(0));
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
