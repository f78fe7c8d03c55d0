// In order: colours and a smaller font derived from the widget's palette, the item of a legend for
// names without room, the plot itself, the looks of axes and legends, and the choice of names and
// ranges. Everything is derived from the widget and nothing is stored, so that a change of palette
// or font needs no more than calling these again.
#include "plots/chart_style.h"

#include "document/spoken.h"
#include "plots/curve_color.h"

#include <QCoreApplication>
#include <QVBoxLayout>
#include <QWidget>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

constexpr int swatchWidth = 16; // px, of a curve beside its name

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

// The item of a legend that stands in place of the names that have no room.
class MoreNames final : public QCPAbstractLegendItem
{
public:
    MoreNames(QCPLegend& legend, QString text)
        : QCPAbstractLegendItem(&legend)
        , m_text(std::move(text))
    {}

protected:
    void draw(QCPPainter* painter) override
    {
        painter->setFont(parentLegend()->font());
        painter->setPen(parentLegend()->textColor());
        painter->drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter, m_text);
    }
    QSize minimumOuterSizeHint() const override
    {
        return QFontMetrics(parentLegend()->font()).size(Qt::TextSingleLine, m_text);
    }

private:
    QString m_text;
};

} // namespace

QCustomPlot* makePlot(QWidget& chart)
{
    auto* plot = new QCustomPlot;
    auto* layout = new QVBoxLayout(&chart);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot);
    plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    // the plot then reaches the screen together with all else that has changed
    plot->setPlottingHint(QCP::phImmediateRefresh, false);
    return plot;
}

QString withUnit(const QString& name, const QString& unit)
{
    return unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, unit);
}

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
    legend.setBrush(Qt::NoBrush);
    legend.setBorderPen(Qt::NoPen);
    legend.setMargins({4, 1, 4, 1});
    legend.setRowSpacing(0);
    legend.setColumnSpacing(12);
    legend.setIconSize(swatchWidth, 10);
    legend.setFont(small(chart));
    legend.setTextColor(inkOf(chart));
}

void fitLegend(QCPLegend& legend, const std::vector<QCPAbstractPlottable*>& curves, int width,
               int rows)
{
    const QFontMetrics metrics(legend.font());
    int widest = 1;
    for (const QCPAbstractPlottable* curve : curves)
        widest = std::max(widest, metrics.horizontalAdvance(curve->name()));
    const int each = swatchWidth + legend.iconTextPadding() + widest + legend.columnSpacing();
    const int columns = std::max(1, width / each);
    legend.clearItems();
    legend.setWrap(columns);
    const auto room = std::size_t(rows * columns);
    const std::size_t shown = curves.size() > room ? room - 1 : curves.size();
    for (std::size_t i = 0; i < shown; ++i)
        curves[i]->addToLegend(&legend);
    if (shown == curves.size())
        return;
    legend.addItem(new MoreNames(
        legend, QCoreApplication::translate("Chart", "and %1 more").arg(curves.size() - shown)));
}

void putLegendAbove(QCustomPlot& plot)
{
    plot.setAutoAddPlottableToLegend(false);
    plot.axisRect()->insetLayout()->take(plot.legend);
    plot.plotLayout()->insertRow(0);
    plot.plotLayout()->addElement(0, 0, plot.legend);
    plot.plotLayout()->setRowStretchFactor(0, 0.001);
    plot.plotLayout()->setRowSpacing(0);
    plot.legend->setFillOrder(QCPLegend::foColumnsFirst);
    plot.legend->setVisible(true);
    // an empty legend would be as wide as its margins at most, and so would what stands below it
    plot.legend->setMaximumSize(QWIDGETSIZE_MAX / 2, QWIDGETSIZE_MAX);
}

QCPRange withAir(const QCPRange& values, double one)
{
    constexpr double headroom = 0.08; // of the values, above and below
    constexpr double flat = 1e-4;     // of its size: less change than this is shown as no change
    const QCPRange held(heldValue(values.lower), heldValue(values.upper));
    const double size = std::max(std::abs(held.lower), std::abs(held.upper));
    const double least = size > 0.0 ? flat * size : one;
    const double half = (0.5 + headroom) * std::max(held.size(), least);
    return {held.center() - half, held.center() + half};
}

QCPRange fittedRange(const QCPRange& values, const QCPRange& shown, bool logarithmic, double one)
{
    constexpr double room = 1.3;   // times
    constexpr double roomy = 0.55; // values that fill less of their axis are fitted anew
    if (logarithmic)
        return {values.lower / room, values.upper * room};
    const QCPRange wanted = withAir(values, one);
    const bool fits = shown.contains(values.lower) && shown.contains(values.upper)
                      && wanted.size() > roomy * shown.size();
    return fits ? shown : wanted;
}

void tighten(QCPAxisRect& rect) { rect.setMinimumMargins({2, 3, 8, 2}); }

void stylePlot(QCustomPlot& plot, const QWidget& chart)
{
    plot.setBackground(chart.palette().base());
    styleAxis(*plot.xAxis, chart);
    styleAxis(*plot.yAxis, chart);
    styleLegend(*plot.legend, chart);
    plot.replot(QCustomPlot::rpQueuedReplot);
}

} // namespace ripstop
