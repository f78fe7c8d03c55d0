// In order: colours and a smaller font derived from the widget's palette, the items of a legend for
// names that are shortened and for those without room, how wide they are, the plot itself, the
// looks of axes and legends, and the choice of names and ranges. Everything is derived from the
// widget and nothing is stored, so that a change of palette or font needs no more than calling
// these again.
#include "plots/chart_style.h"

#include "document/spoken.h"
#include "plots/curve_color.h"
#include "scene/said_number.h"

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
constexpr int narrowest = 120;  // px, of a plot

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

QSize sizeOf(const QString& text, const QFontMetrics& metrics)
{
    return metrics.size(Qt::TextSingleLine, text);
}

// The item of a curve whose name takes no more than a width, px, unless there is more room.
class ShortName final : public QCPPlottableLegendItem
{
public:
    ShortName(QCPLegend& legend, QCPAbstractPlottable& curve, int width)
        : QCPPlottableLegendItem(&legend, &curve)
        , m_width(width)
    {}

protected:
    void draw(QCPPainter* painter) override
    {
        // swatch and name are drawn by the library, which asks the curve for its name
        const QString whole = mPlottable->name();
        mPlottable->setName(QFontMetrics(getFont()).elidedText(whole, Qt::ElideMiddle,
                                                               rect().width() - beforeName()));
        QCPPlottableLegendItem::draw(painter);
        mPlottable->setName(whole);
    }
    QSize minimumOuterSizeHint() const override
    {
        const QFontMetrics metrics(getFont());
        const int name = std::min(m_width, metrics.horizontalAdvance(mPlottable->name()));
        const int icon = mParentLegend->iconSize().height();
        return {beforeName() + name, std::max(metrics.height(), icon)};
    }

private:
    int beforeName() const
    {
        return mParentLegend->iconSize().width() + mParentLegend->iconTextPadding();
    }

    int m_width;
};

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
        return sizeOf(m_text, QFontMetrics(parentLegend()->font()));
    }

private:
    QString m_text;
};

QString moreText(std::size_t count)
{
    return QCoreApplication::translate("Chart", "and %1 more").arg(count);
}

// How many names a legend of that width, px, has room for, in how many columns, and how wide each
// may be. Names stand row by row.
class LegendRoom
{
public:
    LegendRoom(const QCPLegend& legend, const std::vector<QCPAbstractPlottable*>& curves, int width)
        : m_metrics(legend.font())
        , m_swatch(legend.iconSize().width() + legend.iconTextPadding())
        , m_spacing(legend.columnSpacing())
        , m_width(width - legend.margins().left() - legend.margins().right())
        , m_least(m_metrics.averageCharWidth() * leastLetters)
    {
        for (const QCPAbstractPlottable* curve : curves)
            m_names.push_back(m_metrics.horizontalAdvance(curve->name()));
    }

    struct Shown
    {
        std::size_t names;
        int columns;
        int width; // px, of the longest name
    };

    Shown shown(int rows) const
    {
        const std::size_t all = m_names.size();
        int widest = 1;
        for (const int name : m_names)
            widest = std::max(widest, name);
        const int whole = std::max(1, (m_width + m_spacing) / (m_swatch + widest + m_spacing));
        if (all <= std::size_t(rows * whole))
            return {all, whole, shortened(all, std::size_t(whole), widest)};
        const auto columns = std::size_t((int(all) + rows - 1) / rows);
        if (needed(all, columns, m_least) <= m_width)
            return {all, int(columns), shortened(all, columns, widest)};
        // what is left out is said in the last place
        std::size_t few = columns;
        const auto names = [&] { return std::min(all, rows * few) - 1; };
        while (few > (rows == 1 ? 2U : 1U) && needed(names(), few, m_least) > m_width)
            --few;
        return {names(), int(few), shortened(names(), few, widest)};
    }

private:
    static constexpr int leastLetters = 6; // of a name, by which a person can still tell it

    // px, of that many names in columns where none is wider than `most`, and of what is said of
    // those that are left out
    int needed(std::size_t names, std::size_t columns, int most) const
    {
        int sum = int(columns - 1) * m_spacing;
        for (std::size_t column = 0; column < columns; ++column) {
            int wide = 0;
            for (std::size_t i = column; i < names; i += columns)
                wide = std::max(wide, m_swatch + std::min(m_names[i], most));
            if (names < m_names.size() && column == names % columns)
                wide = std::max(wide, sizeOf(moreText(m_names.size()), m_metrics).width());
            sum += wide;
        }
        return sum;
    }

    int shortened(std::size_t names, std::size_t columns, int widest) const
    {
        int most = widest;
        while (most > m_least && needed(names, columns, most) > m_width)
            --most;
        return most;
    }

    QFontMetrics m_metrics;
    int m_swatch;             // px, before each name
    int m_spacing;            // px, between two columns
    int m_width;              // px, of all
    int m_least;              // px, of a name
    std::vector<int> m_names; // px
};

} // namespace

QCustomPlot* makePlot(QWidget& chart)
{
    auto* plot = new QCustomPlot;
    auto* layout = new QVBoxLayout(&chart);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot);
    plot->setMinimumWidth(
        narrowest); // or its legend, which is fitted to it, could not get narrower
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
    const LegendRoom room(legend, curves, width);
    const LegendRoom::Shown shown = room.shown(rows);
    legend.clearItems();
    legend.setWrap(shown.columns);
    for (std::size_t i = 0; i < shown.names; ++i)
        legend.addItem(new ShortName(legend, *curves[i], shown.width));
    if (shown.names < curves.size())
        legend.addItem(new MoreNames(legend, moreText(curves.size() - shown.names)));
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

QCPRange withAir(const QCPRange& values, double one, std::string_view unit)
{
    constexpr double headroom = 0.08; // of the values, above and below
    constexpr double flat = 1e-4;     // of its size: less change than this is shown as no change
    const auto heldOf = [unit](double value) { return isNothing(value, unit) ? 0.0 : value; };
    const QCPRange held(heldOf(values.lower), heldOf(values.upper));
    const double size = std::max(std::abs(held.lower), std::abs(held.upper));
    const double least = size > 0.0 ? flat * size : one;
    const double half = (0.5 + headroom) * std::max(held.size(), least);
    return {held.center() - half, held.center() + half};
}

QCPRange fittedRange(const QCPRange& values, const QCPRange& shown, bool logarithmic, double one,
                     std::string_view unit)
{
    constexpr double room = 1.3;   // times
    constexpr double roomy = 0.55; // values that fill less of their axis are fitted anew
    if (logarithmic)
        return {values.lower / room, values.upper * room};
    const QCPRange wanted = withAir(values, one, unit);
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
