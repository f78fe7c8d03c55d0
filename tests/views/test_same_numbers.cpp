// Whoever asks for the value of a probe at a time gets the same number: the live frame, the plots
// and their table, the table of the command line, an export, a recording.
//
// Stages: one flight is read by each of these ways, the values are put side by side by their
// times, and all must agree to what single precision does to kept frames.
#include "document/document.h"
#include "document/player.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "model/cli_call.h"
#include "plots/plot_panel.h"
#include "views/run_with_widgets.h"

#include <QBuffer>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <map>

namespace ripstop::test_same_numbers {

namespace {

constexpr const char* seconds = "2";

// Values of the columns after the time, NaN for an empty cell, by the text of the time: the same
// text is the same bits.
using Values = std::map<double, std::vector<double>>;

Values valuesOf(const QByteArray& table)
{
    Values values;
    for (const QByteArray& line : table.trimmed().split('\n')) {
        bool isNumber = false;
        const QList<QByteArray> cells = line.split(',');
        const double time = cells[0].toDouble(&isNumber);
        if (!isNumber)
            continue;
        for (const QByteArray& cell : cells.mid(1))
            values[time].push_back(cell.isEmpty() ? std::nan("") : cell.toDouble());
    }
    return values;
}

bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool areSame(const std::vector<double>& a, const std::vector<double>& b)
{
    return std::ranges::equal(a, b, isSame);
}

// What single precision does to a reading. A kept frame has the way w since the last exact state
// with a relative error of 2^-24, so that a place is off by dx <= 2^-24 |w|, and |w| <= v 1 s as a
// stretch is a second long at most; velocities and tensions are off by 2^-24 of themselves. Sums
// and square roots of three components make no more than twice of it. Strains and angles (rad)
// come from places over a length, at worst the shortest of a link. Double precision adds 1e-13.
double tolerance(const Layout::Probe& probe, double value, double fastest, double shortest)
{
    const double single = std::ldexp(1.0, -24);
    const double places = 2.0 * single * fastest * 1.0;
    double bound = 2.0 * single * std::abs(value);
    if (probe.unit == "m")
        bound = places;
    else if (probe.unit == "m/s")
        bound = 2.0 * single * fastest;
    else if (probe.unit == "deg")
        bound = 2.0 * places / shortest * 180.0 / M_PI;
    else if (probe.unit.empty())
        bound = 2.0 * places / shortest;
    return bound + 1e-13 * std::max(1.0, std::abs(value));
}

} // namespace

class TestSameNumbers : public QObject
{
    Q_OBJECT

private slots:
    void everybodyReadsTheSame_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::newRow("a kite on its line") << "delta_kite";
        QTest::newRow("a glider") << "hang_glider";
    }

    void everybodyReadsTheSame()
    {
        QFETCH(QString, sample);
        const QString file = QString(SCENES_DIR "/%1.ripstop.json").arg(sample);
        QTemporaryDir folder;

        // the window
        Document document;
        Player player(document);
        PlotPanel plots(document, player);
        std::shared_ptr<Recording> recording;
        std::vector<std::shared_ptr<const Frame>> live;
        connect(&player, &Player::recordingBegan, this,
                [&](const auto& begun) { recording = begun; });
        connect(&player, &Player::frameReady, this,
                [&](const auto& frame) { live.push_back(frame); });
        document.replace(*readScene(file.toStdString()));
        for (int i = 1; i <= 5; ++i) { // so that there are frames, fast as it may be
            const double until = 0.2 * i * QString(seconds).toDouble();
            player.playUntil(until);
            QTRY_VERIFY_WITH_TIMEOUT(player.frame() && player.frame()->time > until - 0.01
                                         && !player.isPlaying(),
                                     60000);
        }
        QVERIFY(recording && live.size() > 3);

        // the command line
        const auto written = [&](const char* name) { return folder.filePath(name); };
        QCOMPARE(call({"run", file, "--seconds", seconds, "--csv", written("run.csv"), "--record",
                       written("run.ripstop-run")})
                     .exitCode,
                 0);
        QCOMPARE(
            call({"export", file, "-o", written("export.csv"), "--to", seconds, "--fps", "240"})
                .exitCode,
            0);
        QCOMPARE(call({"export", written("run.ripstop-run"), "-o", written("exact.csv"), "--exact",
                       "--fps", "240"})
                     .exitCode,
                 0);
        const Values run = valuesOf(contentOf(written("run.csv")));
        QVERIFY(run.size() > 400);
        const Values exported = valuesOf(contentOf(written("export.csv")));
        QVERIFY(exported.size() > 400);
        QBuffer buffer;
        QVERIFY(buffer.open(QIODevice::WriteOnly));
        plots.writeCsv(buffer);
        const Values plotted = valuesOf(buffer.data());
        QCOMPARE(plotted.size(), run.size()); // each step, though it flew faster than it was drawn

        for (const Values& table : {exported, valuesOf(contentOf(written("exact.csv")))})
            for (const auto& [time, values] : table) {
                const auto row = run.find(time);
                QVERIFY2(row != run.end() && areSame(values, row->second),
                         qPrintable(QString::number(time)));
            }

        double fastest = 0.0, shortest = 1e9;
        for (const auto& frame : live)
            for (const Vec3& velocity : frame->velocity)
                fastest = std::max(fastest, velocity.norm());
        const Layout& layout = *live.back()->layout;
        for (const Layout::Link& link : layout.links)
            shortest = std::min(shortest, link.restLength);
        fastest *= 1.5; // between the frames that were seen it may have been faster

        std::size_t compared = 0;
        for (const auto& frame : live) {
            if (frame->step == 0)
                continue;
            QVERIFY2(run.contains(frame->time), qPrintable(QString::number(frame->time)));
            const std::vector<double>& values = run.at(frame->time);
            QVERIFY(areSame(frame->probe, values));
            const std::size_t at = plots.history().nearest(frame->time);
            if (plots.history().time()[at] == frame->time)
                for (std::size_t i = 0; i < layout.probes.size(); ++i) {
                    const auto history = plots.history().valuesOf(layout.probes[i].id);
                    QVERIFY(isSame(history[at], values[i]));
                }
            if (const auto row = plotted.find(frame->time); row != plotted.end()) {
                std::size_t column = 0; // the table of the plots has what is plotted
                for (std::size_t i = 0; i < layout.probes.size(); ++i)
                    if (layout.probes[i].plotted)
                        QVERIFY(isSame(row->second[column++], values[i]));
                QCOMPARE(column, row->second.size());
                ++compared;
            }

            const auto kept = recording->frame(recording->frameOfStep(frame->step));
            QVERIFY(kept);
            QCOMPARE((*kept)->step, frame->step); // light designs have each step
            QCOMPARE((*kept)->hash, frame->hash);
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (std::isnan(values[i]) && std::isnan((*kept)->probe[i]))
                    continue;
                const double bound = tolerance(layout.probes[i], values[i], fastest, shortest);
                QVERIFY2(std::abs((*kept)->probe[i] - values[i]) <= bound,
                         qPrintable(QString("%1 at %2 s: %3 and %4, bound %5")
                                        .arg(QString::fromStdString(layout.probes[i].name))
                                        .arg(frame->time)
                                        .arg((*kept)->probe[i], 0, 'g', 17)
                                        .arg(values[i], 0, 'g', 17)
                                        .arg(bound)));
            }
        }
        QVERIFY(compared > 2);
        const auto exact = recording->exactFrame(live.back()->step);
        QVERIFY(exact && areSame((*exact)->probe, live.back()->probe));
    }
};

const RegisteredTest registered("test_same_numbers", runWithWidgets<TestSameNumbers>);

} // namespace ripstop::test_same_numbers
#include "test_same_numbers.moc"
