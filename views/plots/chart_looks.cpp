// How the chart looks: colours and fonts of the window, the names of its curves, and its size.
#include "document/event_words.h"
#include "plots/chart.h"
#include "plots/chart_style.h"

#include <QEvent>
#include <qcustomplot.h>

#include <algorithm>

namespace ripstop {
namespace {

constexpr std::size_t many = 12;   // curves, above which fine lines are drawn faster
constexpr int roomy = 120;         // px, of a strip, where a second line of names has room
constexpr int lastStripExtra = 28; // px, for the numbers of the time axis

} // namespace

bool Chart::isCrowded() const { return m_curves.size() > many; }

void Chart::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        style();
        fitLegends();
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

void Chart::style()
{
    m_plot->setBackground(palette().base());
    for (Strip& strip : m_strips)
        style(strip);
}

void Chart::style(Strip& strip)
{
    for (QCPAxis* axis : strip.rect->axes())
        styleAxis(*axis, *this);
    for (const QCPAxis::AxisType side : {QCPAxis::atTop, QCPAxis::atRight}) {
        strip.rect->axis(side)->setTicks(false);
        strip.rect->axis(side)->setTickLabels(false);
    }
    for (std::size_t kind = 0; kind < strip.marks.size(); ++kind)
        strip.marks[kind]->setPen(
            QPen(eventColor(RunEvent::Kind(kind), palette()), 1, Qt::DashLine));
    strip.cursor->setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    const bool fine = isCrowded();
    for (const int curve : strip.curves) {
        QCPGraph& graph = *m_graphs[std::size_t(curve)];
        graph.setPen(QPen(m_curves[std::size_t(curve)].color, fine ? 1.0 : 1.6));
        graph.setAntialiased(!fine);
    }
    for (std::size_t i = 0; i < strip.bands.size(); ++i) {
        const QColor& color = m_curves[std::size_t(strip.curves[i])].color;
        const bool one = strip.bands.size() == 1; // else its name is of all
        styleBand(strip.bands[i], color, one ? color : palette().color(QPalette::Text));
    }
    styleLegend(*strip.legend, *this);
}

void Chart::fitLegends()
{
    for (const Strip& strip : m_strips)
        fitLegend(strip);
}

void Chart::fitLegend(const Strip& strip)
{
    std::vector<QCPAbstractPlottable*> curves;
    for (const int curve : strip.curves)
        curves.push_back(m_graphs[std::size_t(curve)]);
    if (strip.showsBands)
        curves.push_back(strip.bands.front().high); // it says it for all
    const int rows = height() < roomy * int(m_strips.size()) ? 1 : 2;
    ripstop::fitLegend(*strip.legend, curves, width(), rows);
}

void Chart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitLegends();
    const QScopedValueRollback setting(m_setting, true);
    fill(); // the number of pixel columns has changed
}

QSize Chart::minimumSizeHint() const
{
    const int strips = std::max(1, int(m_strips.size()));
    return {200, strips * stripHeight + lastStripExtra};
}

} // namespace ripstop
