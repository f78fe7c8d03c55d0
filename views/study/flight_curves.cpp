// The chart draws curves in the order in which it is given them, so that the place of a curve that
// is clicked is that of its flight.
#include "study/flight_curves.h"

#include "icons/icon.h"
#include "io/csv.h"
#include "plots/chart_style.h"
#include "plots/curve_color.h"
#include "plots/xy_chart.h"
#include "study/narrow_box.h"
#include "study/shown_value.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>

namespace ripstop {

FlightCurves::FlightCurves(QWidget* parent)
    : QWidget(parent)
    , m_probe(new NarrowBox(tr("Probe of the curves"), {}, 2))
    , m_ghosts(new NarrowBox(tr("How the flights are shown in the view"), {}, 2))
    , m_chart(new XyChart)
{
    m_ghosts->addItems({tr("ghosts over each other"), tr("ghosts side by side"), tr("no ghosts")});
    auto* close = new QToolButton;
    close->setIcon(icon(QStringLiteral("close")));
    close->setToolTip(tr("Compare no more"));
    close->setAccessibleName(close->toolTip());
    close->setAutoRaise(true);
    auto* line = new QHBoxLayout;
    line->addWidget(m_probe, 1);
    line->addWidget(m_ghosts, 1);
    line->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(line);
    layout->addWidget(m_chart, 1);
    m_chart->setMinimumWidth(120);
    connect(m_probe, &QComboBox::activated, this, [this](int probe) {
        m_shownProbe = probe;
        draw();
    });
    connect(m_ghosts, &QComboBox::activated, this, &FlightCurves::ghostsWanted);
    connect(close, &QToolButton::clicked, this, &FlightCurves::closed);
    connect(&plot(), &QCustomPlot::plottableClick, this,
            [this](QCPAbstractPlottable*, int, const QMouseEvent* event) {
                if (const auto nearest = nearestTo(event->pos()))
                    emit chosen(m_curves[*nearest].point);
            });
}

// Where curves lie close the click is told of the topmost, which need not be the one that is meant.
std::optional<std::size_t> FlightCurves::nearestTo(const QPointF& place)
{
    std::optional<std::size_t> nearest;
    double least = 0.0;
    for (std::size_t i = 0; i < m_curves.size() && int(i) < plot().plottableCount(); ++i) {
        const double away =
            plot().plottable(int(i))->selectTest(place, false); // < 0: has no points
        if (away >= 0.0 && (!nearest || away < least)) {
            least = away;
            nearest = i;
        }
    }
    return nearest;
}

QCustomPlot& FlightCurves::plot() { return m_chart->plot(); }

QColor FlightCurves::colorOf(std::size_t place) const { return curveColor(int(place), palette()); }

FlightCurves::Ghosts FlightCurves::ghosts() const { return Ghosts(m_ghosts->currentIndex()); }

void FlightCurves::show(std::vector<FlightCurve> curves)
{
    m_curves = std::move(curves);
    QStringList names;
    if (!m_curves.empty())
        for (const Layout::Probe& probe : m_curves.front().flight->flight.probes)
            names << withUnit(QString::fromStdString(probe.name),
                              QString::fromStdString(probe.unit));
    QStringList before;
    for (int i = 0; i < m_probe->count(); ++i)
        before << m_probe->itemText(i);
    if (names != before) {
        m_shownProbe = std::max(0, int(names.indexOf(m_probe->currentText())));
        m_probe->clear();
        m_probe->addItems(names);
        m_probe->setCurrentIndex(m_shownProbe);
    }
    draw();
}

void FlightCurves::mark(std::optional<std::size_t> point)
{
    m_marked = point;
    for (std::size_t i = 0; i < m_curves.size() && int(i) < plot().plottableCount(); ++i) {
        QPen pen = plot().plottable(int(i))->pen();
        pen.setWidthF(m_curves[i].point == m_marked ? 3.0 : 1.6);
        plot().plottable(int(i))->setPen(pen);
    }
    plot().replot(QCustomPlot::rpQueuedReplot);
}

void FlightCurves::draw()
{
    std::vector<XyCurve> curves;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const ProbeCurves& read = m_curves[i].flight->curves;
        XyCurve& curve = curves.emplace_back();
        curve.name = m_curves[i].name;
        curve.color = colorOf(i);
        if (std::size_t(probe()) < read.value.size()) {
            curve.x = read.time;
            curve.y = read.value[std::size_t(probe())];
        }
    }
    m_chart->show({tr("time"), QStringLiteral("s")}, wordsOfHeading(m_probe->currentText()),
                  curves);
    mark(m_marked);
}

std::string FlightCurves::table() const
{
    std::string text = "flight,time (s)";
    if (!m_curves.empty())
        for (const Layout::Probe& probe : m_curves.front().flight->flight.probes)
            text += ',' + csvCell(withUnit(probe.name, probe.unit));
    text += '\n';
    for (const FlightCurve& curve : m_curves) {
        const ProbeCurves& read = curve.flight->curves;
        const std::string name = csvCell(curve.name.toStdString());
        for (std::size_t i = 0; i < read.time.size(); ++i) {
            text += name;
            appendCell(text, read.time[i]);
            for (const std::vector<double>& values : read.value)
                appendCell(text, values[i]);
            text += '\n';
        }
    }
    return text;
}

void FlightCurves::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        draw();
    QWidget::changeEvent(event);
}

} // namespace ripstop
