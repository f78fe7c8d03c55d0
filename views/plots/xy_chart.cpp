#include "plots/xy_chart.h"

#include "plots/chart_style.h"

#include <QEvent>
#include <QScopedValueRollback>
#include <QVBoxLayout>
#include <qcustomplot.h>

namespace ripstop {

XyChart::XyChart(QWidget* parent)
    : QWidget(parent)
    , m_plot(new QCustomPlot)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    m_plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    m_plot->setContextMenuPolicy(Qt::CustomContextMenu); // it lets no click through to the panel
    connect(m_plot, &QWidget::customContextMenuRequested, this, [this](const QPoint& place) {
        emit customContextMenuRequested(m_plot->mapTo(this, place));
    });
    m_plot->legend->setVisible(true);
    m_plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignRight);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis})
        connect(axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this,
                [this] { m_held |= !m_setting; });
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, [this] {
        m_held = false;
        fit();
    });
    stylePlot(*m_plot, *this);
}

void XyChart::show(const QString& xLabel, const QString& yLabel, const std::vector<XyCurve>& curves)
{
    m_plot->clearPlottables();
    m_plot->xAxis->setLabel(xLabel);
    m_plot->yAxis->setLabel(yLabel);
    for (const XyCurve& one : curves) {
        auto* curve = new QCPCurve(m_plot->xAxis, m_plot->yAxis); // the plot's own from now on
        curve->setName(one.name);
        QColor color = one.color;
        color.setAlphaF(one.past ? 0.45F : 1.0F);
        curve->setPen(QPen(color, one.past ? 1.0 : 1.6));
        curve->setData(QVector<double>(one.x.begin(), one.x.end()),
                       QVector<double>(one.y.begin(), one.y.end()));
    }
    fit();
}

void XyChart::setLogarithmic(bool logarithmic)
{
    m_logarithmic = logarithmic;
    QCPAxis& axis = *m_plot->yAxis;
    axis.setScaleType(logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    axis.setTicker(logarithmic ? QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog)
                               : QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
    axis.setNumberFormat(logarithmic ? QStringLiteral("eb") : QStringLiteral("gb"));
    axis.setNumberPrecision(logarithmic ? 0 : 6);
    m_held = false;
    fit();
}

void XyChart::fit()
{
    const QScopedValueRollback setting(m_setting, true);
    if (!m_held) {
        const QCP::SignDomain sign = m_logarithmic ? QCP::sdPositive : QCP::sdBoth;
        bool any = false;
        QCPRange x;
        QCPRange y;
        for (int i = 0; i < m_plot->plottableCount(); ++i) {
            bool hasX = false;
            bool hasY = false;
            const QCPRange across = m_plot->plottable(i)->getKeyRange(hasX);
            const QCPRange up = m_plot->plottable(i)->getValueRange(hasY, sign);
            if (!hasX || !hasY)
                continue;
            x = any ? x.expanded(across) : across;
            y = any ? y.expanded(up) : up;
            any = true;
        }
        if (any) {
            constexpr double headroom = 1.08;
            m_plot->xAxis->setRange(x);
            m_plot->yAxis->setRange(y);
            m_plot->xAxis->scaleRange(headroom);
            if (!m_logarithmic)
                m_plot->yAxis->scaleRange(headroom);
        }
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

int XyChart::curveCount() const { return m_plot->plottableCount(); }
double XyChart::yTop() const { return m_plot->yAxis->range().upper; }

void XyChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        stylePlot(*m_plot, *this);
    QWidget::changeEvent(event);
}

} // namespace ripstop
