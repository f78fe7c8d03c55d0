#include "plots/polar_chart.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"

#include <QEvent>
#include <qcustomplot.h>

#include <algorithm>

namespace ripstop {

PolarChart::PolarChart(QWidget* parent)
    : QWidget(parent)
    , m_plot(makePlot(*this))
{
    m_plot->xAxis->setLabel(tr("Angle of attack (degrees)"));
    m_plot->xAxis->setRange(0.0, 90.0);
    const QSharedPointer<QCPAxisTickerFixed> ticks(new QCPAxisTickerFixed);
    ticks->setTickStep(15.0);
    m_plot->xAxis->setTicker(ticks);
    m_plot->legend->setVisible(true);
    // below the curves, which fill the whole chart
    m_plot->axisRect()->insetLayout()->take(m_plot->legend);
    m_plot->plotLayout()->addElement(1, 0, m_plot->legend);
    m_plot->plotLayout()->setRowStretchFactor(1, 0.001);
    m_plot->legend->setFillOrder(QCPLegend::foColumnsFirst);
    m_plot->legend->setWrap(2);
    stylePlot(*m_plot, *this);
}

void PolarChart::show(const QString& quantity, const std::vector<Curve>& curves)
{
    m_plot->clearGraphs();
    m_plot->yAxis->setLabel(quantity);
    double highest = 0.0;
    double lowest = 0.0;
    for (const Curve& curve : curves) {
        QCPGraph* graph = m_plot->addGraph();
        graph->setName(curve.name);
        graph->setData(QVector<double>(curve.degrees.begin(), curve.degrees.end()),
                       QVector<double>(curve.value.begin(), curve.value.end()), true);
        for (const double value : curve.value) {
            highest = std::max(highest, value);
            lowest = std::min(lowest, value);
        }
    }
    for (int i = 0; i < m_plot->graphCount(); ++i) {
        const bool published = curves[std::size_t(i)].published;
        m_plot->graph(i)->setPen(QPen(curveColor(i, palette()), published ? 1.4 : 3.0,
                                      published ? Qt::DashLine : Qt::SolidLine));
        if (!published)
            m_plot->graph(i)->setLayer(QStringLiteral("axes")); // above the published ones
    }
    m_plot->yAxis->setRange(lowest, 1.05 * std::max(highest, 0.1));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

int PolarChart::curveCount() const { return m_plot->graphCount(); }

void PolarChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        stylePlot(*m_plot, *this);
    QWidget::changeEvent(event);
}

} // namespace ripstop
