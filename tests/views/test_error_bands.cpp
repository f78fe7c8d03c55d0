// Bands of what values may be off by, around the curves of runs that are certified: how wide they
// are, where they end, and what a certified recording brings.
#include "document/spoken.h"
#include "run/certify.h"
#include "views/plot_desk.h"
#include "views/run_with_widgets.h"
#include "views/small_scenes.h"

#include <QBuffer>
#include <QToolTip>
#include <QtTest>
#include <qcustomplot.h>

#include <cmath>

namespace ripstop::test_error_bands {

namespace {

constexpr double g = 9.80665; // m/s^2
constexpr double h = 0.01;    // s
constexpr double top = 10.;   // m

// The falling pair with its height (8) and its speed (9), in steps of semi-implicit Euler.
Scene measured()
{
    Scene scene = measuredPair();
    scene.settings.integrator = Integrator::SemiImplicitEuler;
    scene.settings.solver = Solver::Direct; // takes the substeps that are said, one
    return scene;
}

Certification certified(const Scene& scene, double seconds)
{
    return *certify(scene, seconds, {}, {});
}

struct Desk : PlotDesk
{
    Desk()
        : PlotDesk(measured())
    {}
    void certify(double seconds)
    {
        recordings.takeCertificate(
            std::make_shared<const Certificate>(certified(document.scene(), seconds).certificate));
    }
    void fly(double time)
    {
        PlotDesk::fly(time);
        QTRY_COMPARE(plots.history().time().size(), std::size_t(std::lround(time / h)) + 1);
    }
    int bandsInSight()
    {
        QTest::qWait(150); // more than between two drawings
        return plots.chart().bandCount();
    }
    std::size_t samplesWithBands()
    {
        QTest::qWait(150);
        return plots.errorBands().sampleCount();
    }
};

} // namespace

class TestErrorBands : public QObject
{
    Q_OBJECT

private slots:
    // Semi-implicit Euler falls too fast: after n steps of h it is at y - g h^2 n (n + 1) / 2,
    // which is g t h / 2 below the parabola. That error is of first order without any rest, so that
    // the limit of the certificate is the parabola and the band is 1.25 times as wide as the error
    // (Roache 1994). Speed g t is exact.
    void boundTheFall()
    {
        Desk desk;
        QCOMPARE(desk.bandsInSight(), 0);
        desk.certify(0.4);
        desk.fly(0.4);
        QCOMPARE(desk.samplesWithBands(), std::size_t(41));
        const auto time = desk.plots.history().time();
        const auto height = desk.plots.errorBands().of(8);
        const auto speed = desk.plots.errorBands().of(9);
        QCOMPARE(height.low.size(), time.size());
        for (std::size_t i = 1; i < time.size(); ++i) {
            const double t = time[i];
            const double parabola = top - 0.5 * g * t * t;
            QVERIFY(height.low[i] < parabola && parabola < height.high[i]);
            const double half = 0.5 * (height.high[i] - height.low[i]);
            QVERIFY2(std::abs(half - 1.25 * 0.5 * g * t * h) < 1e-9,
                     qPrintable(QString::number(t)));
            QVERIFY(speed.high[i] - speed.low[i] < 1e-9);
        }
        QCOMPARE(desk.plots.chart().bandCount(), 2);
    }

    // What is computed after an edit is another run; undone, it is the certified one again.
    void endWithTheCertifiedRun()
    {
        Desk desk;
        desk.certify(0.4);
        desk.fly(0.1);
        desk.document.push(setValue(desk.document.scene(), Id{2}, "velocity", Vec3(0, 1, 0)));
        desk.player.reset();
        desk.fly(0.2);
        QCOMPARE(desk.samplesWithBands(), std::size_t(0));
        QCOMPARE(desk.bandsInSight(), 0);
        desk.document.history().undo();
        desk.player.reset();
        desk.fly(0.2);
        QCOMPARE(desk.samplesWithBands(), std::size_t(21));
        const Scene& scene = desk.document.scene();
        desk.document.push(setValue(scene, settingsId, "gravity", Vec3(0, -1, 0)));
        desk.fly(0.3);
        QVERIFY(desk.samplesWithBands() <= 22); // the edit comes at the next step
        QVERIFY(desk.samplesWithBands() >= 21);
    }

    void endWithTheCertificate()
    {
        Desk desk;
        desk.certify(0.2);
        desk.fly(0.4);
        QCOMPARE(desk.samplesWithBands(), std::size_t(21));
        desk.certify(0.3); // the one that reaches furthest counts
        QCOMPARE(desk.samplesWithBands(), std::size_t(31));
    }

    // A hand that steers makes the run another one, too.
    void endWhereOneSteers()
    {
        Desk desk;
        desk.certify(0.4);
        desk.fly(0.1);
        desk.player.steer(Id{7}, 0.1);
        desk.fly(0.3);
        QVERIFY(desk.samplesWithBands() <= 12);
    }

    void areSwitchedOff()
    {
        Desk desk;
        desk.certify(0.4);
        desk.fly(0.4);
        QCOMPARE(desk.bandsInSight(), 2);
        desk.plots.showErrorBands(false);
        QCOMPARE(desk.bandsInSight(), 0);
        desk.plots.showErrorBands(true);
        QCOMPARE(desk.bandsInSight(), 2);
    }

    // A recording from a file has a certificate with the values of its run, which are drawn while
    // one looks back at it.
    void comeWithARecording()
    {
        Desk desk;
        QTRY_VERIFY(desk.player.frame());
        desk.recordings.add(certified(desk.document.scene(), 0.4).flown);
        QTRY_VERIFY(desk.recordings.isLookingBack());
        QCOMPARE(desk.samplesWithBands(), std::size_t(41));
        QCOMPARE(desk.plots.chart().bandCount(), 2);
        desk.recordings.backToLive();
        QCOMPARE(desk.samplesWithBands(), std::size_t(0)); // the run stands at its start
        desk.fly(0.2);
        QCOMPARE(desk.samplesWithBands(), std::size_t(21)); // and is the recorded one
    }

    // The mouse on a band is told what it says; the value is that of the certified run.
    void tellTheirNumbers()
    {
        Desk desk;
        desk.certify(0.4);
        desk.fly(0.4);
        QCOMPARE(desk.bandsInSight(), 2);
        QCustomPlot& plot = desk.plots.chart().plot();
        const QCPAxisRect& heights = *plot.axisRects().front();
        const double value = desk.plots.history().valuesOf(8)[30];
        const QPoint place = QPointF(heights.axis(QCPAxis::atBottom)->coordToPixel(30 * h),
                                     heights.axis(QCPAxis::atLeft)->coordToPixel(value))
                                 .toPoint();
        const auto isToldOnMoving = [&] { // a tip goes again by itself when the machine is slow
            QTest::mouseMove(&plot, place - QPoint(1, 0));
            QTest::mouseMove(&plot, place);
            return QToolTip::text().startsWith("height: ");
        };
        QTRY_VERIFY(isToldOnMoving());
        const double half = 1.25 * 0.5 * g * 30 * h * h; // m
        QVERIFY2(QToolTip::text().contains(QString("± ") + spokenText(half, "m", 2)),
                 qPrintable(QToolTip::text()));
    }

    // The table that is saved has a column of errors beside each value.
    void areInTheTable()
    {
        Desk desk;
        desk.certify(0.2);
        desk.fly(0.2);
        QCOMPARE(desk.bandsInSight(), 2);
        QBuffer table;
        table.open(QIODevice::ReadWrite);
        desk.plots.writeCsv(table);
        const QStringList lines = QString::fromUtf8(table.data()).split('\n');
        QCOMPARE(lines[0], QString("time (s),height (m),height error (m),speed (m/s),"
                                   "speed error (m/s)"));
        const QStringList last = lines[21].split(',');
        QVERIFY(std::abs(last[2].toDouble() - 1.25 * 0.5 * g * 0.2 * h) < 1e-9);
    }

    // On a logarithmic axis a band that reaches below 0 is drawn from far below, and the axis still
    // fits the curves.
    void onALogarithmicAxis()
    {
        const std::vector<double> time{0.0, 1.0, 2.0}, low{-1.0, 0.5, 1.0}, high{3.0, 4.0, 5.0};
        QCustomPlot plot;
        const BandGraphs band = addBand(plot, *plot.xAxis, *plot.yAxis);
        const DrawnCurve spanned = fillBand(band, time, low, high, {0.0, 2.5, 100, true});
        QVERIFY(spanned.any);
        QCOMPARE(spanned.high, 5.0);
        QVERIFY(spanned.low > 0.0);
        QVERIFY(band.low->dataMainValue(0) > 0.0);
    }
};

const RegisteredTest registered("test_error_bands", runWithWidgets<TestErrorBands>);

} // namespace ripstop::test_error_bands
#include "test_error_bands.moc"
