// show() empties the plot and lets one of three functions fill it; points stay in a list besides,
// for clicks.
#include "study/goal_chart.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"
#include "study/shown_value.h"
#include "study/study_report.h"
#include "study/study_search.h"

#include <QEvent>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ripstop {
namespace {

constexpr double nearFlight = 12.0; // px
constexpr double barWidth = 0.3;    // of the room of a variable

QCPErrorBars* bandOf(QCustomPlot& plot, QCPBars& bars)
{
    auto* band = new QCPErrorBars(plot.xAxis, plot.yAxis);
    band->setDataPlottable(&bars);
    band->setAntialiased(false);
    return band;
}

QVector<double> valuesOf(const std::vector<double>& numbers)
{
    return {numbers.begin(), numbers.end()};
}

} // namespace

GoalChart::GoalChart(QWidget* parent)
    : QWidget(parent)
    , m_plot(makePlot(*this))
    , m_x(new SpokenAxis(*m_plot->xAxis))
    , m_y(new SpokenAxis(*m_plot->yAxis))
    , m_flights(m_plot->addGraph())
    , m_best(m_plot->addGraph())
    , m_first(new QCPBars(m_plot->xAxis, m_plot->yAxis))
    , m_total(new QCPBars(m_plot->xAxis, m_plot->yAxis))
    , m_firstBand(bandOf(*m_plot, *m_first))
    , m_totalBand(bandOf(*m_plot, *m_total))
{
    putLegendAbove(*m_plot);
    m_flights->setLineStyle(QCPGraph::lsNone);
    m_first->setWidth(barWidth);
    m_total->setWidth(barWidth);
    m_first->setName(tr("alone"));
    m_total->setName(tr("with its interactions"));
    setMinimumSize(180, 150);
    connect(m_plot, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
        const Point* nearest = nullptr;
        double least = nearFlight;
        for (const Point& point : m_points) {
            const QPointF place(m_plot->xAxis->coordToPixel(point.x),
                                m_plot->yAxis->coordToPixel(point.y));
            const QPointF away = place - event->pos();
            if (const double distance = std::hypot(away.x(), away.y()); distance < least) {
                least = distance;
                nearest = &point;
            }
        }
        if (nearest)
            emit chosen(nearest->number);
    });
    restyle();
}

void GoalChart::nameBars()
{
    std::vector<QCPAbstractPlottable*> shown;
    if (m_hasBars)
        shown = {m_first, m_total};
    fitLegend(*m_plot->legend, shown, width(), 2);
}

void GoalChart::resizeEvent(QResizeEvent*) { nameBars(); }

std::vector<GoalChart::Picture> GoalChart::picturesOf(const OpenedStudy& study)
{
    std::vector<Picture> pictures;
    if (study.wanted.size() == 1)
        pictures.push_back(Picture::Convergence);
    if (study.wanted.size() == 2)
        pictures.push_back(Picture::Front);
    if (study.study.plan.kind == StudyPlan::Kind::Sensitivity)
        pictures.push_back(Picture::Sensitivity);
    return pictures;
}

int GoalChart::barCount() const { return m_first->dataCount(); }

void GoalChart::clear()
{
    m_points.clear();
    for (QCPGraph* graph : {m_flights, m_best})
        graph->data()->clear();
    for (QCPBars* bars : {m_first, m_total})
        bars->data()->clear();
    for (QCPErrorBars* band : {m_firstBand, m_totalBand})
        band->data()->clear();
    for (SpokenAxis* axis : {m_x, m_y})
        axis->setLogarithmic(false); // round numbers again
}

void GoalChart::show(const OpenedStudy& study, const StudyFlights& flights, Picture picture,
                     std::size_t reading)
{
    clear();
    m_hasBars = picture == Picture::Sensitivity;
    nameBars();
    switch (picture) {
    case Picture::Convergence:
        showConvergence(study, flights);
        break;
    case Picture::Front:
        showFront(study, flights);
        break;
    case Picture::Sensitivity:
        showSensitivity(study, flights, reading);
        break;
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void GoalChart::drawPoints()
{
    QVector<double> x, y;
    QCPRange across, upwards;
    for (const Point& point : m_points) {
        x << point.x;
        y << point.y;
        const QCPRange here(point.x, point.x), there(point.y, point.y);
        across = x.size() == 1 ? here : across.expanded(here);
        upwards = x.size() == 1 ? there : upwards.expanded(there);
    }
    m_flights->setData(x, y);
    m_plot->xAxis->setRange(withAir(across));
    m_plot->yAxis->setRange(withAir(upwards));
}

void GoalChart::showConvergence(const OpenedStudy& study, const StudyFlights& flights)
{
    const std::vector<double> best = bestSoFar(study, flights);
    QVector<double> stepX, stepY;
    for (std::size_t i = 0; i < flights.size(); ++i) {
        if (flights[i] && scoreOf(study, *flights[i]).isFeasible())
            m_points.push_back(
                {i, double(i + 1), flights[i]->measured[study.wanted.front()], false});
        if (std::isfinite(best[i])) {
            stepX << double(i + 1);
            stepY << best[i];
        }
    }
    m_best->setLineStyle(QCPGraph::lsStepLeft);
    m_best->setScatterStyle(QCPScatterStyle::ssNone);
    m_best->setData(stepX, stepY);
    drawPoints();
    m_x->say({tr("flight"), {}});
    m_y->say(wordsOfHeading(QString::fromStdString(study.headings[study.wanted.front()])));
}

void GoalChart::showFront(const OpenedStudy& study, const StudyFlights& flights)
{
    const std::vector<std::size_t> front = bestPoints(study, flights);
    const std::set<std::size_t> isOnIt(front.begin(), front.end());
    std::vector<double> frontX, frontY;
    for (std::size_t i = 0; i < flights.size(); ++i) {
        if (!flights[i] || !scoreOf(study, *flights[i]).isFeasible())
            continue;
        const double x = flights[i]->measured[study.wanted[0]];
        const double y = flights[i]->measured[study.wanted[1]];
        m_points.push_back({i, x, y, isOnIt.contains(i)});
        if (isOnIt.contains(i)) {
            frontX.push_back(x);
            frontY.push_back(y);
        }
    }
    m_best->setLineStyle(QCPGraph::lsLine);
    m_best->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 9));
    m_best->setData(valuesOf(frontX), valuesOf(frontY));
    drawPoints();
    m_x->say(wordsOfHeading(QString::fromStdString(study.headings[study.wanted[0]])));
    m_y->say(wordsOfHeading(QString::fromStdString(study.headings[study.wanted[1]])));
}

void GoalChart::showSensitivity(const OpenedStudy& study, const StudyFlights& flights,
                                std::size_t reading)
{
    const Sensitivity found = sensitivityOf(study, flights, reading);
    const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
    QCPRange range(0.0, 1.0);
    const auto put = [&](QCPBars& bars, QCPErrorBars& band, double shift, auto index) {
        std::vector<double> x, y, below, above;
        for (std::size_t v = 0; v < found.variables.size(); ++v) {
            const ConfidenceBand& one = found.variables[v].*index;
            if (!std::isfinite(one.value))
                continue;
            x.push_back(double(v) + shift);
            y.push_back(one.value);
            below.push_back(std::max(0.0, one.value - one.low));
            above.push_back(std::max(0.0, one.high - one.value));
            range.expand(QCPRange(one.low, one.high));
        }
        bars.setData(valuesOf(x), valuesOf(y));
        band.setData(valuesOf(below), valuesOf(above));
    };
    put(*m_first, *m_firstBand, -0.5 * barWidth, &SobolIndices::first);
    put(*m_total, *m_totalBand, 0.5 * barWidth, &SobolIndices::total);
    for (std::size_t v = 0; v < study.study.variables.size(); ++v)
        names->addTick(double(v), QString::fromStdString(study.study.variables[v].name));
    m_x->say({});
    m_plot->xAxis->setTicker(names);
    m_y->say({tr("share of the variance"), {}});
    m_plot->xAxis->setRange(-0.6, double(study.study.variables.size()) - 0.4);
    m_plot->yAxis->setRange(withAir(range));
}

void GoalChart::restyle()
{
    stylePlot(*m_plot, *this);
    styleLegend(*m_plot->legend, *this);
    const QColor ink = palette().color(QPalette::Text);
    QColor faint = ink;
    faint.setAlpha(110);
    const QColor one = curveColor(0, palette());
    const QColor other = curveColor(1, palette());
    m_flights->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, faint, faint, 5));
    m_best->setPen(QPen(one, 2.0));
    m_first->setPen(QPen(one));
    m_first->setBrush(one);
    m_total->setPen(QPen(other));
    m_total->setBrush(other);
    for (QCPErrorBars* band : {m_firstBand, m_totalBand})
        band->setPen(QPen(ink, 1.2));
}

void GoalChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        restyle();
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
    QWidget::changeEvent(event);
}

} // namespace ripstop
