#include "plots/band_chart.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"

#include <QEvent>
#include <qcustomplot.h>

namespace ripstop {
namespace {

enum Curve { Low, High, Value };

constexpr int bandOpacity = 70; // of 255

} // namespace

BandChart::BandChart(QWidget* parent)
    : QWidget(parent)
    , m_plot(makePlot(*this))
{
    m_plot->xAxis->setLabel(tr("Time (s)"));
    for (const Curve curve : {Low, High, Value})
        m_plot->addGraph()->setVisible(curve != Low);
    m_plot->graph(High)->setChannelFillGraph(m_plot->graph(Low));
    style();
}

void BandChart::show(const QString& label, const std::vector<double>& time,
                     const std::vector<double>& value, const std::vector<double>& error)
{
    QVector<double> low, high;
    for (std::size_t i = 0; i < value.size(); ++i) {
        low.push_back(value[i] - error[i]);
        high.push_back(value[i] + error[i]);
    }
    const QVector<double> times(time.begin(), time.end());
    m_plot->graph(Low)->setData(times, low, true);
    m_plot->graph(High)->setData(times, high, true);
    m_plot->graph(Value)->setData(times, QVector<double>(value.begin(), value.end()), true);
    m_plot->yAxis->setLabel(label);
    m_plot->xAxis->rescale();
    bool found = false;
    const QCPRange values = m_plot->graph(High)->getValueRange(found).expanded(
        m_plot->graph(Low)->getValueRange(found));
    if (found)
        m_plot->yAxis->setRange(withAir(values));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void BandChart::clear() { show({}, {}, {}, {}); }

void BandChart::style()
{
    QColor band = curveColor(0, palette());
    m_plot->graph(Value)->setPen(QPen(band, 2.0));
    band.setAlpha(bandOpacity);
    m_plot->graph(High)->setPen(Qt::NoPen);
    m_plot->graph(High)->setBrush(band);
    stylePlot(*m_plot, *this);
}

void BandChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        style();
    QWidget::changeEvent(event);
}

} // namespace ripstop
