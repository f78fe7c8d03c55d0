// The constructor puts the legend above the axes, where it hides no curve, and notes when a user
// rather than the program changes a range. show() replaces all curves, earlier runs first so that
// the present one lies above them. fitNames() names as many as have room, and fit() sets the axes
// unless the user has chosen what is in sight; on a logarithmic axis only positive values count.
#include "plots/xy_chart.h"

#include "plots/chart_style.h"

#include <QEvent>
#include <QScopedValueRollback>
#include <qcustomplot.h>

#include <algorithm>
#include <utility>

namespace ripstop {

XyChart::XyChart(QWidget* parent)
    : QWidget(parent)
    , m_plot(makePlot(*this))
    , m_x(new SpokenAxis(*m_plot->xAxis))
    , m_y(new SpokenAxis(*m_plot->yAxis))
{
    m_plot->setContextMenuPolicy(Qt::CustomContextMenu); // it lets no click through to the panel
    connect(m_plot, &QWidget::customContextMenuRequested, this, [this](const QPoint& place) {
        emit customContextMenuRequested(m_plot->mapTo(this, place));
    });
    tighten(*m_plot->axisRect());
    putLegendAbove(*m_plot);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis})
        connect(axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this,
                [this] { m_held |= !m_setting; });
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, [this] {
        m_held = false;
        fit();
    });
    stylePlot(*m_plot, *this);
}

void XyChart::show(const AxisWords& x, const AxisWords& y, const std::vector<XyCurve>& curves)
{
    m_plot->legend->clearItems(); // they point at what goes
    m_plot->clearPlottables();
    m_x->say(x);
    m_y->say(y);
    for (const XyCurve& one : curves) {
        auto* curve = new QCPCurve(m_plot->xAxis, m_plot->yAxis); // the plot's own from now on
        curve->setName(one.name);
        QColor color = one.color;
        color.setAlphaF(one.past ? 0.45F : 1.0F);
        curve->setPen(QPen(color, one.past ? 1.0 : 1.6));
        curve->setData(QVector<double>(one.x.begin(), one.x.end()),
                       QVector<double>(one.y.begin(), one.y.end()));
    }
    m_pastCount = std::ranges::count_if(curves, &XyCurve::past);
    fitNames();
    fit();
}

// Earlier runs are drawn first and named last.
void XyChart::fitNames()
{
    std::vector<QCPAbstractPlottable*> curves;
    for (int i = 0; i < m_plot->plottableCount(); ++i)
        curves.push_back(m_plot->plottable(i));
    std::rotate(curves.begin(), curves.begin() + m_pastCount, curves.end());
    constexpr int lowChart = 240; // px
    fitLegend(*m_plot->legend, curves, width(), height() < lowChart ? 1 : 2);
}

void XyChart::setRange(std::optional<double> low, std::optional<double> high)
{
    if (low == m_low && high == m_high)
        return;
    m_low = low;
    m_high = high;
    m_held = false;
    fit();
}

void XyChart::setLogarithmic(bool logarithmic)
{
    if (std::exchange(m_logarithmic, logarithmic) == logarithmic)
        return;
    m_y->setLogarithmic(logarithmic);
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
            m_plot->xAxis->setRange(withAir(x));
            m_plot->yAxis->setRange(m_logarithmic ? y : withAir(y));
        }
        const QCPRange range = m_plot->yAxis->range();
        const QCPRange asked(m_low.value_or(range.lower), m_high.value_or(range.upper));
        if (m_low.value_or(range.lower) < m_high.value_or(range.upper))
            m_plot->yAxis->setRange(asked);
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

int XyChart::curveCount() const { return m_plot->plottableCount(); }
std::pair<double, double> XyChart::valueRange() const
{
    const QCPRange range = m_plot->yAxis->range();
    return {range.lower, range.upper};
}

void XyChart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitNames();
}

void XyChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        stylePlot(*m_plot, *this);
    fitNames();
    QWidget::changeEvent(event);
}

} // namespace ripstop
