// The panels of the plots dock that a scene keeps, the marks of what happened, and curves that are
// longer than the screen is wide.
//
// Stages: plots and their ways of looking as edits, undone and saved; runs that plots must not
// disturb; marks of events; then the range of values, peaks among many samples, and sixty curves
// of ten minutes.
#include "plots/chart_style.h"
#include "thread_time.h"
#include "views/inspector_form.h"
#include "views/plot_desk.h"
#include "views/run_with_widgets.h"
#include "views/small_scenes.h"

#include <QMenu>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>
#include <qcustomplot.h>

#include <cmath>

namespace ripstop::test_plots {

namespace {

// The falling pair over a ground 1 m below it, with its height (8), its speed (9), ground is 10.
Scene measured()
{
    Scene scene = measuredPair();
    Collider ground;
    ground.name = "ground";
    ground.position = Vec3(0.0, 9.0, 0.0);
    scene.items.push_back({Id{10}, ground});
    scene.nextId = Id{11};
    return scene;
}

struct Desk : PlotDesk
{
    Desk()
        : PlotDesk(measured())
    {}
    std::vector<const Plot*> kept() const
    {
        std::vector<const Plot*> found;
        for (const Entry& entry : document.scene().items)
            if (const auto* plot = std::get_if<Plot>(&entry.item))
                found.push_back(plot);
        return found;
    }
    QTreeWidget& list() { return *plots.findChild<QTreeWidget*>(); }
};

std::vector<std::uint32_t> probesIn(PlotView& view)
{
    std::vector<std::uint32_t> ids;
    for (const Curve& curve : view.curves())
        ids.push_back(curve.probe);
    return ids;
}

QStringList probesNamed(PlotView& view, const QString& name)
{
    QStringList names;
    for (const Curve& curve : view.curves())
        if (curve.name == name)
            names << curve.name;
    return names;
}

using Ids = std::vector<std::uint32_t>;

// The legend of a chart of one strip.
struct LegendSeen
{
    int named = 0;  // curves
    int others = 0; // places that name none
    int width = 0;  // px, that it needs

    explicit LegendSeen(Chart& chart)
    {
        const auto& grid = *chart.plot().plotLayout();
        auto& legend = *qobject_cast<QCPLegend*>(grid.element(0, 0));
        for (int i = 0; i < legend.itemCount(); ++i)
            if (legend.item(i)) // the last line need not be full
                ++(qobject_cast<QCPPlottableLegendItem*>(legend.item(i)) ? named : others);
        width = legend.minimumOuterSizeHint().width();
    }
};

} // namespace

class TestPlots : public QObject
{
    Q_OBJECT

private slots:
    // Nothing is stored until one wants more than the panel that is there anyway.
    void plotsAreEdits()
    {
        Desk desk;
        QCOMPARE(desk.plots.viewCount(), 1);
        QVERIFY(desk.kept().empty());
        desk.plots.addPlot();
        QCOMPARE(desk.kept().size(), std::size_t(2));
        QCOMPARE(desk.plots.viewCount(), 2);
        QVERIFY(desk.kept()[0]->name != desk.kept()[1]->name);
        desk.document.history().undo();
        QVERIFY(desk.kept().empty());
        QCOMPARE(desk.plots.viewCount(), 1);
        desk.document.history().redo();
        desk.plots.removePlot(0);
        QCOMPARE(desk.plots.viewCount(), 1);
        desk.document.history().undo();
        QCOMPARE(desk.plots.viewCount(), 2);
    }

    // A probe that comes after the flight has the curve that it would have had, from the frames of
    // the recording; what no recording has begins when it was added, and says so.
    void aNewProbeHasAPast()
    {
        Desk desk;
        desk.fly(0.4);
        Probe late;
        late.name = "late";
        late.target = Id{2};
        const auto add = [&](Id id, Quantity quantity) {
            late.quantity = quantity;
            desk.document.push({Message("Add %1", late.name),
                                {AddItem{desk.document.scene().items.size(), {id, late}}}});
        };
        const auto values = [&](std::uint32_t id) { return desk.plots.history().valuesOf(id); };
        add(Id{20}, Quantity::PositionY);
        QTRY_VERIFY(values(20).size() > 10 && std::isfinite(values(20).front()));
        const auto time = desk.plots.history().time();
        QCOMPARE(values(20).size(), time.size());
        constexpr double g = 9.80665, h = 0.01; // as it falls, to what the integrator is off by
        for (std::size_t i = 0; i < time.size(); ++i)
            QVERIFY2(std::abs(values(20)[i] - (10.0 - 0.5 * g * time[i] * time[i]))
                         <= g * h * (time[i] + h),
                     qPrintable(QString::number(time[i])));
        QTRY_VERIFY(probesNamed(desk.plots.view(), "late").size() == 1);

        late.name = "clock";
        late.target = noId;
        add(Id{21}, Quantity::StepsPerSecond);
        desk.fly(0.6);
        QTRY_COMPARE(probesNamed(desk.plots.view(), "clock, known from 0.4\u00a0s on").size(), 1);
    }

    // A way to look stays with the desk while no plot is kept, and is an edit of the one that is.
    void waysOfAPlot()
    {
        Desk desk;
        Plot plot = desk.plots.view().plot();
        plot.axis = PlotAxis::Frequency;
        desk.plots.change(plot);
        QCOMPARE(desk.plots.view().plot().axis, PlotAxis::Frequency);
        QCOMPARE(desk.document.history().count(), 0);
        desk.plots.keepPlot();
        QCOMPARE(desk.kept().at(0)->axis, PlotAxis::Frequency);
        plot = desk.plots.view().plot();
        plot.axis = PlotAxis::Probe;
        plot.against = Id{9};
        plot.logarithmic = true;
        desk.plots.change(plot);
        QCOMPARE(desk.kept().at(0)->against, Id{9});
        desk.document.history().undo(); // both in one step
        QCOMPARE(desk.kept().at(0)->axis, PlotAxis::Frequency);
        QVERIFY(!desk.kept().at(0)->logarithmic);
    }

    // Ticks of a plot with curves of its own are its own.
    void ticksOfOnePlot()
    {
        Desk desk;
        desk.plots.addPlot(); // the second is chosen, with both curves
        desk.list().topLevelItem(0)->setCheckState(0, Qt::Unchecked);
        QTRY_COMPARE(probesIn(desk.plots.view(1)), Ids{9});
        QCOMPARE(probesIn(desk.plots.view(0)), (Ids{8, 9}));
        QVERIFY(findItem<Probe>(desk.document.scene(), Id{8})->plotted);
        desk.list().topLevelItem(1)->setCheckState(0, Qt::Unchecked); // the last one stays
        QTRY_COMPARE(desk.list().topLevelItem(1)->checkState(0), Qt::Checked);
        QCOMPARE(probesIn(desk.plots.view(1)), Ids{9});
        desk.plots.choose(0);
        QCOMPARE(desk.list().topLevelItem(0)->checkState(0), Qt::Checked);
    }

    // A probe that goes takes its curve along, and undo brings both back.
    void removedProbes()
    {
        Desk desk;
        desk.plots.addPlot();
        desk.document.push(removal(desk.document.scene(), {Id{8}}));
        QCOMPARE(desk.kept().at(1)->probes, std::vector{Id{9}});
        QCOMPARE(probesIn(desk.plots.view(1)), Ids{9});
        desk.document.history().undo();
        QCOMPARE(probesIn(desk.plots.view(1)), (Ids{8, 9}));
    }

    void comesBackWithTheFile()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("a.ripstop.json");
        Desk desk;
        desk.plots.addPlot();
        Plot plot = desk.plots.view().plot();
        plot.name = "fall";
        plot.axis = PlotAxis::Probe;
        plot.against = Id{8};
        plot.probes = {Id{9}};
        plot.low = 0.0;
        plot.high = 5.0;
        desk.plots.change(plot);
        QVERIFY(!desk.document.save(file));
        Desk other;
        QVERIFY(!other.document.open(file));
        QCOMPARE(other.plots.viewCount(), 2);
        QVERIFY(other.plots.view(1).plot() == plot);
    }

    // Plots do not concern the simulation: the run goes on with the same system.
    void plotsDoNotDisturbTheRun()
    {
        Desk desk;
        desk.fly(0.1);
        const auto before = desk.player.frame();
        const double began = desk.plots.history().time().front();
        desk.plots.addPlot();
        desk.fly(0.2);
        QCOMPARE(desk.plots.history().time().front(), began); // the curves go on
        QCOMPARE(desk.player.frame()->run, before->run);
        QVERIFY(*desk.player.frame()->layout == *before->layout);
    }

    // It falls by 1 m in sqrt(2 / g) = 0.45 s, and the touch is marked, with its names.
    void marksWhatHappens()
    {
        Desk desk;
        desk.fly(0.4);
        QCOMPARE(desk.plots.chart().markCount(RunEvent::Kind::Contact), 0);
        desk.fly(0.6);
        QTRY_COMPARE(desk.plots.chart().markCount(RunEvent::Kind::Contact), 1);
        QVERIFY(desk.recordings.toEvent(Recordings::Way::Back));
        QTRY_VERIFY(desk.player.isLookingBack());
        QVERIFY(std::abs(desk.player.frame()->time - std::sqrt(2.0 / 9.80665)) < 0.02);
    }

    // What lies on the ground does so to some nanometres: its axis is that of zeros, and not one of
    // ten decimals. Of a pull as small there is something to be seen.
    void restIsNothingOnAnAxis()
    {
        const QCPRange rest(-7.6e-9, -7.5e-9);
        QCOMPARE(withAir(rest, 1.0, "m"), withAir({0.0, 0.0}, 1.0, "m"));
        QCOMPARE(fittedRange(rest, {0.0, 30.0}, false, 1.0, "m"), withAir({0.0, 0.0}));
        QVERIFY(withAir(rest, 1.0, "N").size() < 1e-9);
    }

    void rangeOfValues()
    {
        Desk desk;
        Plot plot = desk.plots.view().plot();
        plot.probes = {Id{8}};
        plot.low = -2.0;
        plot.high = 20.0;
        desk.plots.change(plot);
        desk.fly(0.3);
        QTRY_VERIFY(desk.plots.chart().pointCount() > 0);
        QCOMPARE(*desk.plots.view().valueRange(), std::pair(-2.0, 20.0));
    }

    // After a reset there is one sample, of 10 m; what is drawn of the run before, which fell by
    // g t^2 / 2, is in sight with it.
    void earlierRunsAreInTheRange()
    {
        Desk desk;
        Plot plot = desk.plots.view().plot();
        plot.probes = {Id{8}};
        desk.plots.keepPlot();
        desk.plots.change(plot);
        desk.fly(0.4);
        desk.player.reset();
        QTRY_COMPARE(desk.plots.history().time().size(), std::size_t(1));
        QCOMPARE(desk.plots.earlier().size(), std::size_t(1));
        const double lowest = desk.plots.earlier()[0].history->valuesOf(8).back();
        QVERIFY(lowest < 9.3);
        const auto range = [&] { return *desk.plots.view().valueRange(); };
        desk.plots.catchUp();
        QVERIFY2(range().first < lowest && range().second > 10.0,
                 qPrintable(QString("%1 to %2").arg(range().first).arg(range().second)));
        desk.plots.forgetEarlier();
        QTRY_VERIFY(range().first > 9.9); // it is of the one sample again
    }

    void namesInTheLegend_data()
    {
        QTest::addColumn<QStringList>("names");
        QTest::addColumn<int>("width"); // px
        QTest::addColumn<int>("named");
        const QString longName(120, 'x');
        QStringList ten;
        for (int i = 0; i < 10; ++i)
            ten << QString("energy of the part that has number %1").arg(i);
        QTest::newRow("all have room") << QStringList{"height", "speed"} << 600 << 2;
        QTest::newRow("one that is long") << QStringList{longName} << 300 << 1;
        QTest::newRow("one is long") << QStringList{"height", longName, "speed"} << 600 << 3;
        QTest::newRow("all are long") << QStringList{longName, longName, longName} << 400 << 3;
        QTest::newRow("ten in a wide panel") << ten << 900 << 10;
        QTest::newRow("two in a narrow one") << QStringList{longName, "speed"} << 200 << 2;
    }

    // Each curve that has room for a swatch and some letters keeps its place in the legend, which
    // is no wider than the chart; a name that is short is not shortened for one that is long.
    void namesInTheLegend()
    {
        QFETCH(QStringList, names);
        QFETCH(int, width);
        QFETCH(int, named);
        Chart chart;
        chart.resize(width, 240);
        std::vector<Curve> curves;
        for (int i = 0; i < names.size(); ++i)
            curves.push_back({std::uint32_t(i + 1), names[i], "m", Qt::blue});
        chart.setCurves(curves);
        chart.show();
        QCoreApplication::processEvents();
        const LegendSeen seen(chart);
        QCOMPARE(seen.named, named);
        QCOMPARE(seen.others, 0);
        QVERIFY2(seen.width <= width, qPrintable(QString::number(seen.width)));
    }

    // Of sixty curves those that have room are named, and the last place says how many are not.
    void namesWithoutRoom()
    {
        std::vector<Curve> curves;
        for (int i = 0; i < 60; ++i)
            curves.push_back(
                {std::uint32_t(i + 1), QString("tension of line %1").arg(i), "N", Qt::blue});
        Chart chart;
        chart.setCurves(curves);
        chart.show();
        int before = 60;
        for (const int width : {800, 400, 200}) {
            chart.resize(width, 240);
            QCoreApplication::processEvents();
            QCOMPARE(chart.width(), width); // the names do not hold it
            const LegendSeen seen(chart);
            QVERIFY(seen.named > 0 && seen.named < before);
            QCOMPARE(seen.others, 1);
            QVERIFY2(seen.width <= width, qPrintable(QString::number(seen.width)));
            before = seen.named;
        }
    }

    // A spike of one sample among a million is drawn, with few points; gaps stay gaps.
    void peaksAreDrawn()
    {
        std::vector<double> time;
        std::vector<double> value;
        for (int i = 0; i < 1'000'000; ++i) {
            time.push_back(0.001 * i);
            value.push_back(std::sin(0.01 * i));
        }
        value[777'777] = 50.0;
        value[123'456] = -40.0;
        const DrawnCurve drawn = drawnCurve(time, value, {0.0, 1000.0, 800, false});
        QVERIFY(drawn.time.size() <= 2 * 801);
        QVERIFY(drawn.value.contains(50.0) && drawn.value.contains(-40.0));
        QCOMPARE(drawn.high, 50.0);
        QCOMPARE(drawn.low, -40.0);
        QVERIFY(std::is_sorted(drawn.time.begin(), drawn.time.end()));

        // the curve goes as far as one looks, and one sample beyond either end
        const DrawnCurve part = drawnCurve(time, value, {10.0, 10.1, 800, false});
        QCOMPARE(part.time.size(), 102);
        QVERIFY(part.high <= 1.0);

        for (std::size_t i = 400'000; i < 500'000; ++i)
            value[i] = std::nan("");
        const DrawnCurve torn = drawnCurve(time, value, {0.0, 1000.0, 800, false});
        QVERIFY(std::ranges::any_of(torn.value, [](double v) { return std::isnan(v); }));
        const DrawnCurve logarithmic = drawnCurve(time, value, {0.0, 1000.0, 800, true});
        QVERIFY(logarithmic.low > 0.0);
        QVERIFY(!drawnCurve({}, {}, {0.0, 1.0, 800, false}).any);
    }

    // What was higher within a step is drawn in place of what it ended with, also where a frame
    // says it once more.
    void peaksWithinAStepAreDrawn()
    {
        const auto layout = std::make_shared<Layout>();
        layout->probes = {{7, "pull", "N", true}};
        History history;
        history.add(ProbeSample{1, layout, 0.1, {2.0}});
        history.add(ProbeSample{1, layout, 0.2, {3.0}, {9.0}});
        Frame frame;
        frame.run = 1;
        frame.layout = layout;
        frame.time = 0.3;
        frame.probe = {4.0};
        history.add(frame);
        frame.time = 0.4;
        frame.highest = {8.0};
        history.add(frame);
        QVERIFY(std::ranges::equal(history.valuesOf(7), std::array{2.0, 9.0, 4.0, 8.0}));
    }

    // 60 curves over ten minutes, 60 samples a second: all samples are kept, and a picture is made
    // of no more points than it has columns. The figures go into the log.
    void sixtyCurvesOfTenMinutes()
    {
        constexpr int curves = 60;
        constexpr int samples = 36'000;
        auto layout = std::make_shared<Layout>();
        std::vector<Curve> drawn;
        for (int c = 0; c < curves; ++c) {
            layout->probes.push_back({std::uint32_t(c + 1), "p", "m", true});
            drawn.push_back({std::uint32_t(c + 1), QString("probe %1").arg(c), c % 2 ? "m" : "N",
                             QColor::fromHsv(6 * c, 200, 200)});
        }
        History history;
        Frame frame;
        frame.run = 1;
        frame.layout = layout;
        frame.probe.resize(curves);
        for (int i = 0; i < samples; ++i) {
            frame.time = i / 60.0;
            for (int c = 0; c < curves; ++c)
                frame.probe[std::size_t(c)] = std::sin(0.03 * i + c) + 0.1 * std::sin(1.7 * i * c);
            history.add(frame);
        }
        QCOMPARE(history.time().size(), std::size_t(samples));
        qInfo("%.1f MB of samples", (curves + 1.0) * samples * sizeof(double) / 1e6);

        Chart chart;
        chart.resize(1000, 400);
        chart.show();
        chart.setCurves(drawn);
        for (const double seconds : {30.0, 0.0}) {
            Plot plot;
            plot.seconds = seconds;
            chart.setPlot(plot);
            chart.draw(history);
            QCoreApplication::processEvents();
            constexpr int pictures = 10;
            const double start = threadTime();
            for (int i = 0; i < pictures; ++i) {
                chart.draw(history);
                QCoreApplication::processEvents();
            }
            qInfo("%s: %.1f ms a picture, %d points", seconds > 0.0 ? "half a minute" : "all of it",
                  (threadTime() - start) / pictures, chart.pointCount());
            QVERIFY(chart.pointCount() <= curves * 2 * (chart.width() + 2));
        }
    }

    // The probes of a plot stand in the inspector by their names, and its menu takes in and lets
    // go; without any, the plot has all that are plotted.
    void theInspectorNamesTheProbes()
    {
        InspectorForm form;
        Scene scene = measured();
        Plot plot;
        plot.probes = {Id{9}};
        scene.items.push_back({Id{11}, plot});
        scene.nextId = Id{12};
        form.document.replace(scene);
        form.selection.set({Id{11}});
        QCOMPARE(form.line("probes")->text(), QString("speed"));
        const auto click = [&form](const QString& name) {
            auto* menu = form.line("probes")->parentWidget()->findChild<QMenu*>();
            emit menu->aboutToShow();
            for (QAction* action : menu->actions())
                if (action->text() == name)
                    return action->trigger();
            QFAIL(qPrintable(name));
        };
        click("height");
        QCOMPARE(form.line("probes")->text(), QString("speed, height"));
        click("speed");
        QCOMPARE(form.value(Id{11}, "probes"), Value(std::vector{Id{8}}));
        form.type(form.line("probes"), "speed, height");
        QCOMPARE(form.value(Id{11}, "probes"), Value(std::vector{Id{9}, Id{8}}));
        click("None");
        QCOMPARE(form.line("probes")->placeholderText(), QString("all that are plotted"));
    }
};

const RegisteredTest registered("test_plots", runWithWidgets<TestPlots>);

} // namespace ripstop::test_plots
#include "test_plots.moc"
