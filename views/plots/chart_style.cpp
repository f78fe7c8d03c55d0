#include "plots/chart_style.h"

#include "plots/curve_color.h"

#include <QWidget>
#include <qcustomplot.h>

namespace ripstop {
namespace {

QColor inkOf(const QWidget& chart) { return chart.palette().color(QPalette::Text); }

QColor withOpacity(QColor color, float opacity)
{
    color.setAlphaF(opacity);
    return color;
}

QFont small(const QWidget& chart)
{
    QFont font = chart.font();
    font.setPointSizeF(0.88 * font.pointSizeF());
    return font;
}

} // namespace

void styleAxis(QCPAxis& axis, const QWidget& chart)
{
    const QColor ink = inkOf(chart);
    const QPen faint(withOpacity(ink, 0.35F), 1);
    axis.setBasePen(faint);
    axis.setTickPen(faint);
    axis.setSubTickPen(Qt::NoPen);
    axis.setTickLength(0, 3);
    axis.setTickLabelColor(ink);
    axis.setLabelColor(ink);
    axis.setTickLabelFont(small(chart));
    axis.setLabelFont(small(chart));
    axis.setLabelPadding(2);
    axis.grid()->setPen(QPen(withOpacity(ink, isDark(chart.palette()) ? 0.16F : 0.12F), 1));
    axis.grid()->setZeroLinePen(faint);
}

void styleLegend(QCPLegend& legend, const QWidget& chart)
{
    legend.setBrush(withOpacity(chart.palette().color(QPalette::Base), 0.75F));
    legend.setBorderPen(Qt::NoPen);
    legend.setFont(small(chart));
    legend.setTextColor(inkOf(chart));
}

void stylePlot(QCustomPlot& plot, const QWidget& chart)
{
    plot.setBackground(chart.palette().base());
    styleAxis(*plot.xAxis, chart);
    styleAxis(*plot.yAxis, chart);
    styleLegend(*plot.legend, chart);
    plot.replot(QCustomPlot::rpQueuedReplot);
}

} // namespace ripstop
