// Curves looked at in other ways: against each other, as spectra, beside earlier runs, as files.
//
// Stages: spectra and phase plots as pure functions; then earlier runs that are kept, the menu of
// the plot, pictures, and logarithmic axes.
#include "document/document.h"
#include "document/player.h"
#include "plots/chart_picture.h"
#include "plots/curve_views.h"
#include "plots/plot_panel.h"
#include "plots/spectrum.h"
#include "views/run_with_widgets.h"
#include "views/small_scenes.h"

#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>
#include <qcustomplot.h>

#include <cmath>
#include <numbers>

namespace ripstop::test_curves {

namespace {

Frame sample(std::uint64_t run, double time, std::vector<double> values)
{
    auto layout = std::make_shared<Layout>();
    layout->probes = {{41, "x", "m", true}, {42, "y", "m", true}};
    Frame frame;
    frame.run = run;
    frame.layout = layout;
    frame.time = time;
    frame.probe = std::move(values);
    return frame;
}

Curve curve(std::uint32_t probe, const char* name, QColor color)
{
    Curve result;
    result.probe = probe;
    result.name = name;
    result.unit = "m";
    result.color = color;
    return result;
}

const std::vector<Curve> both{curve(41, "x", Qt::red), curve(42, "y", Qt::blue)};

} // namespace

class TestCurves : public QObject
{
    Q_OBJECT

private slots:
    // A sine of 3 m at 2 Hz on a slow drift of its mean has its line there, as high; the same with
    // samples at uneven times.
    void spectrum_data()
    {
        QTest::addColumn<double>("unevenness");
        QTest::newRow("even") << 0.0;
        QTest::newRow("uneven") << 0.3;
    }

    void spectrum()
    {
        QFETCH(double, unevenness);
        constexpr double step = 0.01; // s
        std::vector<double> time;
        std::vector<double> value;
        for (int i = 0; i < 1000; ++i) {
            const double t = step * (i + unevenness * (i % 3 - 1));
            time.push_back(t);
            value.push_back(7.0 + 3.0 * std::sin(2.0 * std::numbers::pi * 2.0 * t));
        }
        const Spectrum found = spectrumOf(time, value);
        const auto peak = std::ranges::max_element(found.amplitude) - found.amplitude.begin();
        QVERIFY(std::abs(found.frequency[std::size_t(peak)] - 2.0) < 0.02);
        QVERIFY2(std::abs(*std::ranges::max_element(found.amplitude) - 3.0) < 0.03,
                 qPrintable(QString::number(*std::ranges::max_element(found.amplitude))));
        QVERIFY(std::abs(found.frequency.back() - 0.5 / step) < 0.1); // half of the rate
    }

    // 20011 is a prime number, of which a plain transform takes 4e8 steps each time it is drawn;
    // the next number without prime factors above 5 is 20000.
    void spectrumOfManySamples()
    {
        constexpr double step = 0.01; // s
        // a line of the transform, between which the window would weaken it
        constexpr double frequency = 400.0 / (20010 * step * 20000.0 / 19999.0); // Hz
        std::vector<double> time;
        std::vector<double> value;
        for (int i = 0; i < 20011; ++i) {
            time.push_back(step * i);
            value.push_back(3.0 * std::sin(2.0 * std::numbers::pi * frequency * time.back()));
        }
        const Spectrum found = spectrumOf(time, value);
        QCOMPARE(found.frequency.size(), std::size_t(10000));
        const auto peak = std::ranges::max_element(found.amplitude) - found.amplitude.begin();
        QVERIFY(std::abs(found.frequency[std::size_t(peak)] - frequency) < 1e-9);
        QVERIFY(std::abs(found.amplitude[std::size_t(peak)] - 3.0) < 0.03);
    }

    void spectrumOfTooLittle()
    {
        const double nothing = std::nan("");
        QVERIFY(spectrumOf({}, {}).frequency.empty());
        const std::vector<double> time(100, 1.0);
        QVERIFY(spectrumOf(time, std::vector<double>(100, nothing)).frequency.empty());
        QVERIFY(
            spectrumOf(time, std::vector<double>(100, 2.0)).frequency.empty()); // no time passes
    }

    // x against itself is a line through the origin; what is not a number is left out.
    void phase()
    {
        History history;
        for (int i = 0; i < 10; ++i)
            history.add(sample(1, 0.1 * i, {double(i), i == 3 ? std::nan("") : 2.0 * i}));
        const auto curves = phaseCurves(history, {}, both, 41);
        QCOMPARE(curves.size(), std::size_t(2));
        QCOMPARE(curves[0].x, curves[0].y);
        QCOMPARE(curves[1].x.size(), std::size_t(9));
        for (std::size_t i = 0; i < curves[1].x.size(); ++i)
            QCOMPARE(curves[1].y[i], 2.0 * curves[1].x[i]);
    }

    void phaseWithEarlierRuns()
    {
        History old;
        History now;
        for (int i = 0; i < 10; ++i) {
            old.add(sample(1, 0.1 * i, {1.0, 2.0}));
            now.add(sample(2, 0.1 * i, {3.0, 4.0}));
        }
        const auto curves =
            phaseCurves(now, {{"run 1", std::make_shared<const History>(old)}}, both, 41);
        QCOMPARE(curves.size(), std::size_t(4));
        QVERIFY(curves[0].past && curves[1].past && !curves[2].past);
        QCOMPARE(curves[0].name, QString("x, run 1"));
        QCOMPARE(curves[3].y.front(), 4.0);
    }

    // A reset begins a new run, and the one before stays until it is cleared.
    void keepsEarlierRuns()
    {
        Document document;
        QVERIFY(!document.open(SOURCE_DIR "/scenes/pendulum.ripstop.json"));
        Player player(document);
        PlotPanel panel(document, player);
        panel.show();
        player.play();
        QTRY_VERIFY_WITH_TIMEOUT(panel.history().time().size() > 5, 30000);
        player.reset();
        QTRY_VERIFY(player.frame()->time == 0.0);
        player.play();
        QTRY_COMPARE(panel.earlier().size(), std::size_t(1));
        QCOMPARE(panel.earlier()[0].name, QString("run 1"));
        QVERIFY(panel.earlier()[0].history->time().size() > 5);
        panel.forgetEarlier();
        QVERIFY(panel.earlier().empty());
    }

    // A right click anywhere on the plot asks for the menu of the panel.
    void rightClick()
    {
        for (const bool strips : {true, false}) {
            Chart chart;
            XyChart xy;
            QWidget& asked = strips ? static_cast<QWidget&>(chart) : xy;
            QCustomPlot& plot = strips ? chart.plot() : xy.plot();
            asked.setContextMenuPolicy(Qt::CustomContextMenu);
            asked.resize(300, 200);
            asked.show();
            QSignalSpy menu(&asked, &QWidget::customContextMenuRequested);
            QTest::mouseClick(&plot, Qt::RightButton, {}, QPoint(150, 100));
            QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(150, 100),
                                    plot.mapToGlobal(QPoint(150, 100)));
            QApplication::sendEvent(&plot, &event);
            QCOMPARE(menu.count(), 1);
        }
    }

    void pictures_data()
    {
        QTest::addColumn<QString>("file");
        for (const char* file : {"a.png", "a.svg", "a.pdf"})
            QTest::newRow(file) << file;
    }

    void pictures()
    {
        QFETCH(QString, file);
        QTemporaryDir folder;
        XyChart chart;
        chart.resize(400, 300);
        chart.show({"x", {}}, {"y", {}}, {{"one", Qt::red, {0, 1, 2}, {0, 1, 4}}});
        const QString path = folder.filePath(file);
        QVERIFY(savePicture(chart.plot(), path));
        if (file.endsWith(".png"))
            QCOMPARE(QImage(path).size(), 2 * chart.plot().size());
        if (!file.endsWith(".svg"))
            return;
        QFile svg(path);
        QVERIFY(svg.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&svg);
        int paths = 0;
        while (!xml.atEnd())
            if (xml.readNext() == QXmlStreamReader::StartElement)
                paths += xml.name() == u"path" || xml.name() == u"polyline";
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QVERIFY(paths > 0);
        QVERIFY(!savePicture(chart.plot(), "/nowhere/a.svg"));
    }

    // Values at or below 0 have no place on a logarithmic axis and do not spoil it.
    void logarithmic()
    {
        XyChart chart;
        chart.setLogarithmic(true);
        chart.show({"x", {}}, {"y", {}}, {{"one", Qt::red, {0, 1, 2, 3}, {-5, 0, 1, 100}}});
        QVERIFY(chart.valueRange().second >= 100.0 && chart.valueRange().second < 1000.0);
    }

    // Marks of a logarithmic axis are 1, 2 and 5 times powers of ten, and never too many.
    void decades_data()
    {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<QStringList>("marks");
        QTest::newRow("one decade")
            << 1400.0 << 25000.0 << QStringList{"2000", "5000", "10000", "20000"};
        QTest::newRow("three") << 0.5 << 600.0 << QStringList{"1", "10", "100"};
        QTest::newRow("many") << 0.01 << 5e5 << QStringList{"0.01", "1", "100", "10000"};
    }
    void decades()
    {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(QStringList, marks);
        QCustomPlot plot;
        plot.xAxis->setScaleType(QCPAxis::stLogarithmic);
        plot.xAxis->setTicker(decadeTicker(5));
        plot.xAxis->setRange(low, high);
        plot.resize(400, 200);
        plot.replot();
        QStringList seen = plot.xAxis->tickVectorLabels().toList();
        QCOMPARE(seen, marks);
    }
};

const RegisteredTest registered("test_curves", runWithWidgets<TestCurves>);

} // namespace ripstop::test_curves
#include "test_curves.moc"
