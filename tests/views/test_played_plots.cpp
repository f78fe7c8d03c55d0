// The curves of recordings that are looked back at: those of files, those of runs that are over,
// and what the plots say where there is nothing to draw.
#include "io/recording_file.h"
#include "views/plot_desk.h"
#include "views/run_with_widgets.h"
#include "views/small_scenes.h"

#include <QAction>
#include <QBuffer>
#include <QLabel>
#include <QMenu>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_played_plots {

namespace {

constexpr double g = 9.80665; // m/s^2
constexpr double h = 0.01;    // s
constexpr double top = 10.0;  // m

QStringList tableOf(const PlotPanel& plots)
{
    QBuffer table;
    table.open(QIODevice::ReadWrite);
    plots.writeCsv(table);
    QStringList lines = QString::fromUtf8(table.data()).split('\n');
    lines.removeLast(); // after the last line break
    return lines;
}

bool mayBeSaved(PlotPanel& plots)
{
    const auto menu = plots.contextMenu();
    const QList<QAction*> actions = menu->actions();
    const auto save = std::ranges::find(actions, "Save as CSV\u2026", &QAction::text);
    return (*save)->isEnabled();
}

bool says(PlotView& view, const QString& hint)
{
    return std::ranges::any_of(view.findChildren<QLabel*>(), [&](const QLabel* label) {
        return label->isVisible() && label->text() == hint;
    });
}

// Flies the scene for that long, s, saves the recording and opens it.
std::shared_ptr<Recording> reopened(const Scene& scene, double time)
{
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("fall.ripstop-run").toStdString();
    PlotDesk desk(scene);
    desk.fly(time);
    const auto flown = desk.recordings.current();
    if (saveRecording(*flown, file))
        return nullptr;
    const auto opened = openRecording(file);
    return opened ? opened->recording : nullptr;
}

} // namespace

class TestPlayedPlots : public QObject
{
    Q_OBJECT

private slots:
    // The fall of the pair by g t^2 / 2, to what the integrator is off by, a row for each frame of
    // the recording, as an export of it has them; and the run that goes on comes back.
    void aReopenedRecordingHasItsCurves()
    {
        const auto recording = reopened(measuredPair(), 0.4);
        QVERIFY(recording);
        QVERIFY(recording->frameCount() > 10);
        PlotDesk desk(measuredPair());
        desk.recordings.add(recording);
        QTRY_COMPARE(tableOf(desk.plots).size(), qsizetype(recording->frameCount() + 1));
        const QStringList table = tableOf(desk.plots);
        QCOMPARE(table[0], QString("time (s),height (m),speed (m/s)"));
        for (std::size_t i = 0; i < recording->frameCount(); ++i) {
            const QStringList row = table[qsizetype(i) + 1].split(',');
            const auto frame = *recording->frame(i);
            QCOMPARE(row[0].toDouble(), frame->time);
            QCOMPARE(row[1].toDouble(), frame->probe[0]);
            QCOMPARE(row[2].toDouble(), frame->probe[1]);
            const double t = frame->time;
            QVERIFY(std::abs(row[1].toDouble() - (top - 0.5 * g * t * t)) <= g * h * (t + h));
        }
        QVERIFY(mayBeSaved(desk.plots));
        QTRY_VERIFY(desk.plots.chart().pointCount() > 20);
        desk.recordings.backToLive();
        QTRY_COMPARE(desk.plots.chart().pointCount(), 2); // of one sample each
    }

    // One opened after the other, with the curves of a run between them.
    void eachHasItsOwn()
    {
        const auto a = reopened(measuredPair(), 0.2);
        const auto b = reopened(measuredPair(), 0.4);
        QVERIFY(a && b);
        PlotDesk desk(measuredPair());
        desk.fly(0.3);
        for (const auto& recording : {a, b, a}) {
            desk.recordings.add(recording);
            QTRY_COMPARE(tableOf(desk.plots).size(), qsizetype(recording->frameCount() + 1));
        }
        QVERIFY(desk.plots.earlier().empty()); // the run goes on
        desk.recordings.backToLive();
        QTRY_COMPARE(tableOf(desk.plots).size(), 32);
    }

    // The run before a reset is looked back at with the samples that were drawn of it.
    void anEarlierRun()
    {
        PlotDesk desk(measuredPair());
        desk.fly(0.3);
        const auto first = desk.recordings.current();
        desk.player.reset();
        QTRY_COMPARE(tableOf(desk.plots).size(), 2);
        QCOMPARE(desk.recordings.current(), first); // until the next run begins
        desk.recordings.seek(2);
        QTRY_COMPARE(tableOf(desk.plots).size(), 32);
        desk.recordings.backToLive();
        QTRY_COMPARE(tableOf(desk.plots).size(), 2);
    }

    // A probe that is added while one looks back has its curve as well; one that a recording
    // cannot have has none, which is said in its place, and no table without a value is written.
    void whatIsNotThereIsSaid()
    {
        const auto recording = reopened(measuredPair(), 0.4);
        PlotDesk desk(measuredPair());
        desk.recordings.add(recording);
        QTRY_COMPARE(tableOf(desk.plots).size(), qsizetype(recording->frameCount() + 1));
        const auto add = [&](Id id, const char* name, Quantity quantity, Id target) {
            Probe probe;
            probe.name = name;
            probe.quantity = quantity;
            probe.target = target;
            desk.document.push({Message("Add %1", name),
                                {AddItem{desk.document.scene().items.size(), {id, probe}}}});
        };
        add(Id{20}, "depth", Quantity::PositionY, Id{2});
        QTRY_VERIFY(tableOf(desk.plots).last().split(',').size() == 4);
        QTRY_VERIFY(!tableOf(desk.plots).last().split(',').last().isEmpty());
        add(Id{21}, "clock", Quantity::StepsPerSecond, noId);
        Plot plot = desk.plots.view().plot();
        plot.probes = {Id{21}};
        desk.plots.keepPlot();
        desk.plots.change(plot);
        QTRY_VERIFY(says(desk.plots.view(), "What these probes read is not in the recording."));
        QVERIFY(!mayBeSaved(desk.plots));
    }
};

const RegisteredTest registered("test_played_plots", runWithWidgets<TestPlayedPlots>);

} // namespace ripstop::test_played_plots
#include "test_played_plots.moc"
