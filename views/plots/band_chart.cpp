#include "plots/band_chart.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"

#include <QEvent>
#include <qcustomplot.h>

namespace ripstop {

BandChart::BandChart(QWidget* parent)
    : QWidget(parent)
    , m_plot(makePlot(*this))
    , m_values(new SpokenAxis(*m_plot->yAxis))
    , m_band(addBand(*m_plot, *m_plot->xAxis, *m_plot->yAxis))
    , m_curve(m_plot->addGraph())
{
    (new SpokenAxis(*m_plot->xAxis))->say({tr("time"), QStringLiteral("s")}); // the axis has it
    style();
}

void BandChart::show(const AxisWords& words, const std::vector<double>& time,
                     const std::vector<double>& value, const std::vector<double>& error)
{
    QVector<double> low, high;
    for (std::size_t i = 0; i < value.size(); ++i) {
        low.push_back(value[i] - error[i]);
        high.push_back(value[i] + error[i]);
    }
    const QVector<double> times(time.begin(), time.end());
    m_band.low->setData(times, low, true);
    m_band.high->setData(times, high, true);
    m_curve->setData(times, QVector<double>(value.begin(), value.end()), true);
    m_values->say(words);
    m_plot->xAxis->rescale();
    bool found = false;
    const QCPRange values =
        m_band.high->getValueRange(found).expanded(m_band.low->getValueRange(found));
    if (found)
        m_plot->yAxis->setRange(withAir(values));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void BandChart::clear() { show({}, {}, {}, {}); }

void BandChart::style()
{
    const QColor color = curveColor(0, palette());
    m_curve->setPen(QPen(color, 1.6));
    styleBand(m_band, color, color);
    stylePlot(*m_plot, *this);
}

void BandChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        style();
    QWidget::changeEvent(event);
}

} // namespace ripstop
