// Pictures of a study over many variables, which share one selection, and how long it takes to
// open a hundred thousand flights.
#include "app/study_shop.h"
#include "registered_test.h"

#include "io/whole_file.h"
#include "study/columns_view.h"
#include "study/percentile_chart.h"
#include "study/point_table.h"
#include "study/scatter_matrix.h"
#include "study/study_chart.h"

#include <QElapsedTimer>
#include <QTimer>
#include <qcustomplot.h>

#include <cmath>
#include <ctime>
#include <numeric>
#include <set>

namespace ripstop::test_study_pictures {

namespace {

constexpr Id weight{4}; // of the pendulum

// Of the wall and of the processor, since the last lap.
class Clocks
{
public:
    Clocks() { m_wall.start(); }
    QString lap()
    {
        const std::clock_t now = std::clock();
        const double seconds = double(now - m_processor) / CLOCKS_PER_SEC;
        m_processor = now;
        return QString("%1 ms (%2 ms of the processor)")
            .arg(m_wall.restart())
            .arg(std::lround(1000.0 * seconds));
    }

private:
    QElapsedTimer m_wall;
    std::clock_t m_processor = std::clock();
};

// Of the pendulum, with points at random over three variables.
Study threeVariables(int count)
{
    Study study;
    study.scene = "a.ripstop.json";
    study.seconds = 0.02;
    study.plan.kind = StudyPlan::Kind::Sobol;
    study.plan.count = count;
    const auto vary = [&](const char* name, const char* path, double from, double to) {
        StudyVariable variable = rangeVariable(from, to, 2, false);
        variable.name = name;
        variable.paths = {path};
        study.variables.push_back(variable);
    };
    vary("mass", "#4.mass", 1.0, 2.0);
    vary("air", "settings.airDensity", 0.5, 1.5);
    vary("gravity", "settings.gravity.y", -12.0, -8.0);
    study.measures = {{"tension", Reduction::Largest}};
    return study;
}

// Selected rows are coloured.
std::size_t colouredRows(PointModel& model)
{
    std::size_t count = 0;
    for (int row = 0; row < model.rowCount(); ++row)
        count += model.data(model.index(row, 0), Qt::BackgroundRole).isValid();
    return count;
}

void open(StudyShop& shop, const Study& study)
{
    const QString file = shop.folder.filePath("b.ripstop-study.json");
    QVERIFY(!replaceFile(pathOf(file), studyText(study)));
    shop.panel.open(file);
    QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().study(), patience);
}

void fly(StudyShop& shop, std::size_t count)
{
    shop.panel.run();
    QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == count, patience);
    QTest::qWait(50);
}

} // namespace

class TestStudyPictures : public QObject
{
    Q_OBJECT

private slots:
    void aStrokeOnAnAxisSelectsEverywhere()
    {
        StudyShop shop;
        shop.window.docks().show("study");
        open(shop, threeVariables(32));
        fly(shop, 32);
        StudyView& view = shop.panel.view();
        QVERIFY(shop.choosePicture("Parallel axes"));
        ParallelChart& chart = view.columns().parallel();
        QVERIFY(chart.isVisible());
        chart.plot().replot();
        const auto stroke = [&](std::size_t column, double from, double to) {
            StudyShop::drag(chart.plot(), chart.placeOf(column, from).toPoint(),
                            chart.placeOf(column, to).toPoint());
        };
        stroke(0, 1.5, 2.0);
        const StudyPoints& points = shop.panel.runner().study()->points;
        const auto number = [&](std::size_t point, std::size_t variable) {
            return std::stod(points.value(point, variable));
        };
        // to a pixel or two, which are far less than a hundredth here
        for (std::size_t point = 0; point < 32; ++point)
            if (std::abs(number(point, 0) - 1.5) > 0.02 && std::abs(number(point, 0) - 2.0) > 0.02)
                QCOMPARE(std::ranges::count(view.selected(), point) == 1, number(point, 0) > 1.5);
        stroke(1, 0.5, 1.0);
        QCOMPARE(chart.strokeCount(), std::size_t(2));
        const std::vector<std::size_t> selected = view.selected();
        QVERIFY(selected.size() > 3 && selected.size() < 14); // about a quarter
        for (const std::size_t point : selected)
            QVERIFY(number(point, 0) > 1.48 && number(point, 1) < 1.02);

        QVERIFY(shop.choosePicture("Table"));
        PointModel& model = view.columns().table().points();
        QCOMPARE(model.rowCount(), 32);
        QCOMPARE(colouredRows(model), selected.size());
        // sorted by the mass downwards, the heaviest comes first, and a click picks it
        view.columns().table().sortByColumn(2, Qt::DescendingOrder);
        for (int row = 1; row < 32; ++row)
            QVERIFY(number(model.pointAt(row - 1), 0) >= number(model.pointAt(row), 0));
        const QRect cell = view.columns().table().visualRect(model.index(0, 0));
        QTest::mouseClick(view.columns().table().viewport(), Qt::LeftButton, {}, cell.center());
        QCOMPARE(view.selected(), std::vector<std::size_t>{model.pointAt(0)});

        // a click on an axis takes its stroke away; without any all are as before
        QVERIFY(shop.choosePicture("Parallel axes"));
        for (const std::size_t column : {0, 1})
            QTest::mouseClick(&chart.plot(), Qt::LeftButton, {},
                              chart.placeOf(column, column == 0 ? 1.5 : 1.0).toPoint());
        QCOMPARE(chart.strokeCount(), std::size_t(0));
        QVERIFY(view.selected().empty());
    }

    void aBandInTheMatrixSelects()
    {
        StudyShop shop;
        shop.window.docks().show("study");
        open(shop, threeVariables(16));
        fly(shop, 16);
        StudyView& view = shop.panel.view();
        QVERIFY(shop.choosePicture("Scatter matrix"));
        ScatterMatrix& matrix = view.columns().scatter();
        matrix.plot().replot();
        // round the point that lies nearest to the middle of the two
        const StudyPoints& points = shop.panel.runner().study()->points;
        const auto away = [&](std::size_t point) {
            return std::hypot(std::stod(points.value(point, 0)) - 1.5,
                              std::stod(points.value(point, 1)) - 1.0);
        };
        std::vector<std::size_t> all(16);
        std::iota(all.begin(), all.end(), std::size_t(0));
        const std::size_t middle = *std::ranges::min_element(all, {}, away);
        const QPoint place = matrix.placeOf(0, 1, middle).toPoint();
        StudyShop::drag(matrix.plot(), place - QPoint(4, 4), place + QPoint(4, 4));
        QVERIFY(std::ranges::count(view.selected(), middle) == 1);
        QVERIFY(view.selected().size() < 6);
        for (const char* name : {"a.svg", "a.pdf", "a.png", "b.svg"}) {
            const QString file = shop.folder.filePath(name);
            QVERIFY(view.writePicture(matrix.plot(), file));
            QVERIFY(QFileInfo(file).size() > 1000);
        }
    }

    // Four seeds of each of three masses: bands; the click on one picks the four.
    void percentilesOverRepeats()
    {
        StudyShop shop;
        shop.window.docks().show("study");
        Study study = threeVariables(0);
        study.plan = {};
        study.variables.pop_back();
        study.variables[0].values = {"1", "1.5", "2"};
        study.variables[1].values = {"0.8", "1", "1.2", "1.4"};
        open(shop, study);
        fly(shop, 12);
        QVERIFY(shop.choosePicture("Percentiles"));
        PercentileChart& chart = shop.panel.view().bands();
        QVERIFY(chart.isVisible() && chart.hasBands());
        QCOMPARE(chart.bands().size(), std::size_t(3));
        chart.plot().replot();
        const QPointF place(chart.plot().xAxis->coordToPixel(1.5), chart.plot().height() / 2);
        QTest::mouseClick(&chart.plot(), Qt::LeftButton, {}, place.toPoint());
        QCOMPARE(shop.panel.view().selected(), (std::vector<std::size_t>{4, 5, 6, 7}));
    }

    // The file of a study whose values cannot be set knows its design all the same.
    void fliesOnceItsValuesAreMended()
    {
        StudyShop shop;
        shop.shelf().study(shop.property(Kind::Settings, "gravity"), {settingsId});
        shop.setSeconds(0.1);
        Study study = shop.panel.form().study();
        study.variables[0].values = {"6"};
        shop.show(study);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY2_WITH_TIMEOUT(shop.panel.state().contains("three numbers"),
                                  qPrintable(shop.panel.state()), patience);
        study = shop.panel.form().study();
        study.variables[0].values = {"0,-9,0", "0,-8,0"};
        shop.show(study);
        QTest::mouseClick(&shop.button("Fly"), Qt::LeftButton);
        QTRY_VERIFY2_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().tally().flown == 2,
                                  qPrintable(shop.panel.state()), patience);
    }

    // Nothing is judged by the clock here, as other work may be on the machine; it is printed.
    void aHundredThousandRows()
    {
        constexpr int count = 100'000;
        StudyShop shop;
        shop.window.docks().show("study");
        const Study study = threeVariables(count);
        const QString file = shop.folder.filePath("b.ripstop-study.json");
        QVERIFY(!replaceFile(pathOf(file), studyText(study)));
        {
            const auto opened = openStudy(pathOf(file));
            QVERIFY(opened);
            auto ledger = Ledger::open(ledgerFolder(pathOf(file)), "shard-1-of-1", opened->headings,
                                       opened->keys.design());
            QVERIFY(ledger);
            FlightResult flight;
            flight.hash = "0123456789abcdef";
            for (int i = 0; i < count; ++i) {
                flight.measured = {std::sin(1e-3 * i)};
                QVERIFY(!ledger->add(opened->key(std::size_t(i)), flight));
            }
        }
        // of the processor too, as other work may be on the machine
        Clocks clocks;
        shop.panel.open(file);
        QTRY_VERIFY_WITH_TIMEOUT(shop.isDone() && shop.panel.runner().study(), patience);
        qInfo("%d rows: opened after %s", count, qPrintable(clocks.lap()));
        QCOMPARE(shop.panel.runner().tally().flown, std::size_t(count));
        StudyView& view = shop.panel.view();
        for (const char* picture :
             {"Map", "Percentiles", "Parallel axes", "Scatter matrix", "Table"}) {
            clocks.lap();
            QVERIFY(shop.choosePicture(picture));
            QTest::qWait(0);
            const QString shown = clocks.lap();
            std::vector<std::size_t> half;
            for (std::size_t i = 0; i < count; i += 2)
                half.push_back(i);
            view.select(half);
            QTest::qWait(0);
            qInfo("%s: shown after %s; half of it selected in %s", picture, qPrintable(shown),
                  qPrintable(clocks.lap()));
            view.select({});
        }
    }

    // A map of 41 by 41 flights of 8 s of a kite, of which some are flown here: how long the window
    // is busy with what comes in, as a timer sees it that is due sixty times a second.
    void theWindowGoesOnWhileItFlies()
    {
        StudyShop shop("kite_in_gusts");
        shop.window.docks().show("study");
        Study study;
        study.scene = "a.ripstop.json";
        study.seconds = 8.0;
        study.untilTear = true;
        study.variables = {rangeVariable(1500.0, 24000.0, 41, true),
                           rangeVariable(40.0, 160.0, 41, false)};
        study.variables[0].name = "EA";
        study.variables[0].paths = {"line.axialStiffness"};
        study.variables[1].name = "strength";
        study.variables[1].paths = {"line.lineStrength"};
        study.measures = {{"line tension", Reduction::Largest}};
        open(shop, study);
        shop.panel.run();
        QTRY_VERIFY_WITH_TIMEOUT(shop.panel.runner().task() == StudyRunner::Task::Flying, patience);
        QTimer timer;
        timer.setTimerType(Qt::PreciseTimer);
        QElapsedTimer clock, all;
        qint64 longest = 0;
        int ticks = 0;
        QObject::connect(&timer, &QTimer::timeout, [&] {
            longest = std::max(longest, clock.restart());
            ++ticks;
        });
        timer.start(16);
        clock.start();
        all.start();
        QTRY_VERIFY_WITH_TIMEOUT(shop.panel.runner().tally().flown >= 12, patience);
        timer.stop();
        const double seconds = 1e-3 * double(all.elapsed());
        const std::size_t flown = shop.panel.runner().tally().flown;
        shop.panel.stop();
        qInfo("41 x 41: %zu flights in %.1f s, %.0f turns of the window a second, the longest "
              "%lld ms",
              flown, seconds, ticks / seconds, longest);
    }

    void aMapOfTwoHundredByTwoHundred()
    {
        StudyShop shop;
        shop.window.docks().show("study");
        StudyMap map;
        constexpr int side = 200;
        map.isGrid = true;
        map.y.emplace();
        for (int i = 0; i < side; ++i) {
            map.x.labels.push_back(std::to_string(i));
            map.y->labels.push_back(std::to_string(i));
        }
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                map.points.push_back({map.points.size(), double(x), double(y),
                                      std::sin(0.05 * x) * std::cos(0.03 * y),
                                      x * y > 9000 ? FlightOutcome::Torn : FlightOutcome::Held});
        StudyChart chart;
        chart.resize(900, 600);
        chart.show();
        QVERIFY(QTest::qWaitForWindowExposed(&chart));
        QElapsedTimer clock;
        clock.start();
        chart.show(map, "a");
        chart.plot().replot();
        const qint64 first = clock.restart();
        constexpr int times = 20;
        for (int i = 0; i < times; ++i) {
            chart.mark({std::size_t(i), std::size_t(i + 1)}, std::size_t(i));
            chart.plot().replot();
        }
        qInfo("200 x 200 cells: %lld ms, and %.1f ms for each picture with another choice", first,
              double(clock.elapsed()) / times);
    }
};

const RegisteredTest registered("test_study_pictures", runWithView<TestStudyPictures>);

} // namespace ripstop::test_study_pictures
#include "test_study_pictures.moc"
