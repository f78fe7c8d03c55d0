// Strips (layOut(): one for each unit, anew only when the curves themselves change), drawing
// (fill() reduces each curve to what the pixels can tell, fitValues() moves an axis only when it
// must), hands (m_setting tells a program's change of a range from a user's, which stops
// following); looks are in chart_looks.cpp. The cursors have a layer of their own: the mouse does
// not redraw the curves.
#include "plots/chart.h"

#include "document/event_words.h"
#include "document/plain_text.h"
#include "document/spoken.h"
#include "plots/chart_style.h"
#include "plots/curve_color.h"
#include "plots/error_bands.h"
#include "plots/spoken_axis.h"

#include <QEvent>
#include <QToolTip>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

const QString cursorLayer = QStringLiteral("cursor");
constexpr double atFirst = 5.0; // s, in sight when it begins
constexpr int nearMark = 4;     // px, of the mouse
constexpr int nearBand = 3;     // px, of the mouse

} // namespace

Chart::Chart(QWidget* parent)
    : QWidget(parent)
    , m_plot(makePlot(*this))
    , m_margins(new QCPMarginGroup(m_plot))
{
    m_plot->setNoAntialiasingOnDrag(true);
    m_plot->addLayer(cursorLayer);
    m_plot->layer(cursorLayer)->setMode(QCPLayer::lmBuffered);
    m_plot->setAutoAddPlottableToLegend(false);          // each strip has a legend of its own
    m_plot->setContextMenuPolicy(Qt::CustomContextMenu); // it lets no click through to the panel
    connect(m_plot, &QWidget::customContextMenuRequested, this, [this](const QPoint& place) {
        emit customContextMenuRequested(m_plot->mapTo(this, place));
    });
    m_plot->installEventFilter(this);
    m_plot->setToolTip({});
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, &Chart::follow);
    connect(m_plot, &QCustomPlot::mousePress, this,
            [this](QMouseEvent* event) { aim(event->position()); });
    connect(m_plot, &QCustomPlot::mouseWheel, this,
            [this](QWheelEvent* event) { aim(event->position()); });
    connect(m_plot, &QCustomPlot::mouseMove, this,
            [this](QMouseEvent* event) { hover(event->position()); });
    layOut();
}

void Chart::setCurves(std::vector<Curve> curves)
{
    if (curves == m_curves)
        return;
    m_curves = std::move(curves);
    layOut();
}

// --- strips ----------------------------------------------------------------------------------

void Chart::layOut()
{
    const QCPRange inSight = m_strips.empty() ? QCPRange(0.0, atFirst) : m_strips[0].time->range();
    m_plot->clearPlottables();
    m_plot->plotLayout()->clear();
    m_strips.clear();
    m_graphs.assign(m_curves.size(), nullptr);

    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const Curve& curve = m_curves[i];
        auto strip = std::find_if(m_strips.begin(), m_strips.end(), [&](const Strip& s) {
            return s.unit == curve.unit && s.isShare == curve.isShare;
        });
        if (strip == m_strips.end()) {
            addStrip(curve);
            strip = m_strips.end() - 1;
        }
        addCurve(*strip, int(i));
    }
    for (Strip& strip : m_strips) {
        const bool last = &strip == &m_strips.back();
        strip.time->setTickLabels(last);
        strip.saidTime->say(last ? AxisWords{tr("time"), QStringLiteral("s")} : AxisWords());
        strip.said->setLogarithmic(m_settings.logarithmic);
    }
    addPast();
    style();
    fitLegends();
    fillMarks();
    const QScopedValueRollback setting(m_setting, true);
    takeTime(inSight);
    updateGeometry();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::addStrip(const Curve& first)
{
    Strip strip;
    strip.unit = first.unit;
    strip.isShare = first.isShare;
    strip.legend = new QCPLegend; // over the strip, where it hides nothing
    strip.rect = new QCPAxisRect(m_plot);
    QCPLayoutGrid& grid = *m_plot->plotLayout();
    const int row = 2 * int(m_strips.size());
    grid.addElement(row, 0, strip.legend);
    grid.addElement(row + 1, 0, strip.rect);
    grid.setRowStretchFactor(row, 0.001);
    grid.setRowSpacing(0);
    strip.legend->setLayer(QStringLiteral("legend"));
    strip.legend->setFillOrder(QCPLegend::foColumnsFirst);
    strip.time = strip.rect->axis(QCPAxis::atBottom);
    strip.values = strip.rect->axis(QCPAxis::atLeft);
    strip.rect->axis(QCPAxis::atTop)->setVisible(true);
    strip.rect->axis(QCPAxis::atRight)->setVisible(true);
    strip.saidTime = new SpokenAxis(*strip.time);
    strip.said = new SpokenAxis(*strip.values);
    strip.said->say({{}, strip.unit, strip.isShare}); // a name would be longer than a strip is high
    tighten(*strip.rect);
    strip.rect->setMinimumSize(60, stripHeight / 2);

    // marks stand from 0 to 1 on an axis of their own, which nobody sees or moves
    QCPAxis* whole = strip.rect->addAxis(QCPAxis::atRight);
    whole->setVisible(false);
    whole->setRange(0.0, 1.0);
    for (QCPGraph*& mark : strip.marks) {
        mark = m_plot->addGraph(strip.time, whole);
        mark->setLineStyle(QCPGraph::lsImpulse);
    }
    strip.cursor = m_plot->addGraph(strip.time, whole);
    strip.cursor->setLineStyle(QCPGraph::lsImpulse);
    strip.cursor->setLayer(cursorLayer);
    drawCursor(strip);

    connect(strip.time, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &Chart::takeTime);
    const std::size_t index = m_strips.size();
    connect(strip.values, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this, index] {
        if (!m_setting)
            m_strips[index].held = true;
    });
    m_strips.push_back(std::move(strip));
    if (m_strips.size() > 1) { // the value axes stand below each other
        m_strips.front().rect->setMarginGroup(QCP::msLeft | QCP::msRight, m_margins);
        m_strips.back().rect->setMarginGroup(QCP::msLeft | QCP::msRight, m_margins);
    }
}

void Chart::addCurve(Strip& strip, int curve)
{
    strip.bands.push_back(addBand(*m_plot, *strip.time, *strip.values));
    strip.bands.back().high->setName(tr("error band"));
    QCPGraph* graph = m_plot->addGraph(strip.time, strip.values);
    graph->setName(m_curves[std::size_t(curve)].name);
    graph->setAdaptiveSampling(false); // drawnCurve() has done that
    m_graphs[std::size_t(curve)] = graph;
    strip.curves.push_back(curve);
}

void Chart::setEarlier(const std::vector<EarlierRun>& earlier)
{
    m_earlier = earlier;
    addPast();
    const QScopedValueRollback setting(m_setting, true);
    fill();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::addPast()
{
    for (Strip& strip : m_strips) {
        for (QCPGraph* graph : strip.past)
            m_plot->removeGraph(graph);
        strip.past.clear();
        for (std::size_t run = 0; run < m_earlier.size(); ++run)
            for (const int curve : strip.curves) {
                QCPGraph* graph = m_plot->addGraph(strip.time, strip.values);
                QColor color = m_curves[std::size_t(curve)].color;
                color.setAlphaF(0.45F);
                graph->setPen(QPen(color, 1.0));
                graph->setAdaptiveSampling(false);
                graph->setLayer(QStringLiteral("grid")); // behind the curves of now
                strip.past.push_back(graph);
            }
    }
}

void Chart::setPlot(const Plot& plot)
{
    if (plot == m_settings)
        return;
    m_settings = plot;
    for (const Strip& strip : m_strips)
        strip.said->setLogarithmic(m_settings.logarithmic);
    follow();
}

// --- drawing ---------------------------------------------------------------------------------

void Chart::draw(const History& history, const ErrorBands* bands)
{
    m_history = &history;
    m_bands = bands;
    fillMarks();
    if (!m_strips.empty()) {
        const QScopedValueRollback setting(m_setting, true);
        takeTime(m_following ? timeToShow() : m_strips.front().time->range());
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::fill()
{
    for (Strip& strip : m_strips)
        fill(strip);
}

void Chart::fill(Strip& strip)
{
    strip.inSight = {};
    if (!m_history)
        return;
    const QCPRange range = strip.time->range();
    const int columnWidth = isCrowded() ? 2 : 1; // px
    const TimeWindow window{range.lower, range.upper,
                            std::max(100, strip.rect->width() / columnWidth),
                            m_settings.logarithmic};
    const auto show = [&](QCPGraph& graph, const History& history, int curve) {
        DrawnCurve drawn = drawnCurve(history.time(),
                                      history.valuesOf(m_curves[std::size_t(curve)].probe), window);
        graph.setData(drawn.time, drawn.value, true);
        return drawn;
    };
    for (const int curve : strip.curves)
        strip.inSight.span(show(*m_graphs[std::size_t(curve)], *m_history, curve));
    fillBands(strip, window);
    auto graph = strip.past.begin();
    for (const EarlierRun& run : m_earlier)
        for (const int curve : strip.curves)
            strip.inSight.span(show(**graph++, *run.history, curve));
}

void Chart::fillBands(Strip& strip, const TimeWindow& window)
{
    bool some = false;
    for (std::size_t i = 0; i < strip.bands.size(); ++i) {
        const Curve& curve = m_curves[std::size_t(strip.curves[i])];
        auto band = m_bands ? m_bands->of(curve.probe) : ErrorBands::Band();
        if (band.low.size() > m_history->time().size())
            band = {}; // the history has become shorter since they were found
        const DrawnCurve drawn = fillBand(strip.bands[i], m_history->time().first(band.low.size()),
                                          band.low, band.high, window);
        strip.inSight.span(drawn);
        some = some || drawn.any;
    }
    if (std::exchange(strip.showsBands, some) != some)
        fitLegend(strip);
}

void Chart::setMarks(std::vector<Mark> marks)
{
    m_marks = std::move(marks);
    fillMarks();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::fillMarks()
{
    std::array<QVector<double>, runEventNames.size()> times;
    if (m_history)
        for (const double tear : m_history->tears())
            times[std::size_t(RunEvent::Kind::Tear)].push_back(tear);
    for (const Mark& mark : m_marks)
        if (mark.kind != RunEvent::Kind::Tear)
            times[std::size_t(mark.kind)].push_back(mark.time);
    for (const Strip& strip : m_strips)
        for (std::size_t kind = 0; kind < times.size(); ++kind)
            strip.marks[kind]->setData(times[kind], QVector<double>(times[kind].size(), 1.0), true);
}

void Chart::setCursor(std::optional<double> time)
{
    if (std::exchange(m_cursor, time) != time)
        drawCursors();
}

void Chart::setHover(std::optional<double> time)
{
    if (std::exchange(m_hover, time) != time)
        drawCursors();
}

// Draws the cursors over the curves, which are not drawn again for that.
void Chart::drawCursors()
{
    for (const Strip& strip : m_strips)
        drawCursor(strip);
    m_plot->layer(cursorLayer)->replot();
}

void Chart::drawCursor(const Strip& strip) const
{
    QVector<double> times;
    for (const auto& time : {m_cursor, m_hover})
        if (time)
            times.push_back(*time);
    strip.cursor->setData(times, QVector<double>(times.size(), 1.0));
}

QCPRange Chart::timeToShow() const
{
    const auto time = m_history->time();
    const double first = time.empty() ? 0.0 : time.front();
    const double now = time.empty() ? 0.0 : time.back();
    const double seconds = m_settings.seconds;
    const double from = seconds > 0.0 ? std::max(first, now - seconds) : first;
    const double least = seconds > 0.0 ? std::min(atFirst, seconds) : atFirst;
    return {from, std::max(now, from + least)};
}

void Chart::fitValues(Strip& strip)
{
    const QCPRange shown = strip.values->range();
    const QCPRange values(strip.inSight.low, strip.inSight.high);
    QCPRange wanted = strip.inSight.any
                          ? fittedRange(values, shown, m_settings.logarithmic,
                                        strip.isShare ? 0.01 : 1.0, strip.unit.toStdString())
                          : shown;
    wanted.lower = m_settings.low.value_or(wanted.lower);
    wanted.upper = m_settings.high.value_or(wanted.upper);
    if (wanted.lower < wanted.upper)
        strip.values->setRange(wanted);
}

// --- hands on it -----------------------------------------------------------------------------

void Chart::follow()
{
    m_following = true;
    for (Strip& strip : m_strips)
        strip.held = false;
    emit followed();
}

void Chart::takeTime(const QCPRange& range)
{
    if (!m_setting)
        m_following = false;
    const QScopedValueRollback setting(m_setting, true);
    for (const Strip& strip : m_strips)
        strip.time->setRange(range);
    fill();
    for (Strip& strip : m_strips)
        if (!strip.held)
            fitValues(strip);
}

// Over its numbers the mouse moves the value axis, everywhere else the time.
void Chart::aim(const QPointF& place)
{
    for (const Strip& strip : m_strips) {
        const bool values = place.x() < strip.rect->left();
        strip.rect->setRangeDrag(values ? Qt::Vertical : Qt::Horizontal);
        strip.rect->setRangeZoom(values ? Qt::Vertical : Qt::Horizontal);
    }
}

void Chart::hover(const QPointF& place)
{
    if (m_strips.empty())
        return;
    const QCPAxisRect& rect = *m_strips.front().rect;
    const bool inside = place.x() >= rect.left() && place.x() <= rect.right();
    emit hovered(inside ? std::optional(m_strips.front().time->pixelToCoord(place.x()))
                        : std::nullopt);
    const Mark* mark = inside ? markAt(place.x()) : nullptr;
    const QString text = mark ? mark->text : inside ? bandAt(place) : QString();
    QToolTip::showText(m_plot->mapToGlobal(place.toPoint()), shownAsIs(text), this);
}

const Mark* Chart::markAt(double x) const
{
    const Mark* nearest = nullptr;
    double best = nearMark;
    for (const Mark& mark : m_marks) {
        const double distance = std::abs(m_strips.front().time->coordToPixel(mark.time) - x);
        if (distance <= best) {
            best = distance;
            nearest = &mark;
        }
    }
    return nearest;
}

// What the band under the mouse means, or nothing.
QString Chart::bandAt(const QPointF& place) const
{
    for (const Strip& strip : m_strips) {
        if (!strip.showsBands || m_history->time().empty()
            || !strip.rect->rect().contains(place.toPoint()))
            continue;
        const std::size_t sample = m_history->nearest(strip.time->pixelToCoord(place.x()));
        for (const int index : strip.curves) {
            const Curve& curve = m_curves[std::size_t(index)];
            const auto band = m_bands->of(curve.probe);
            if (sample >= band.low.size()
                || place.y() < strip.values->coordToPixel(band.high[sample]) - nearBand
                || place.y() > strip.values->coordToPixel(band.low[sample]) + nearBand)
                continue;
            const double error = 0.5 * (band.high[sample] - band.low[sample]);
            return tr("%1: %2 ± %3, by the certificate of the run")
                .arg(curve.name,
                     readingText(curve.isShare, 0.5 * (band.high[sample] + band.low[sample]),
                                 curve.unit.toStdString(), 6),
                     readingText(curve.isShare, error, curve.unit.toStdString(), 2));
        }
    }
    return {};
}

bool Chart::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Leave)
        emit hovered(std::nullopt);
    return QWidget::eventFilter(watched, event);
}

double Chart::timeFrom() const { return m_strips.front().time->range().lower; }
double Chart::timeTo() const { return m_strips.front().time->range().upper; }

int Chart::pointCount() const
{
    int count = 0;
    for (const QCPGraph* graph : m_graphs)
        count += graph->dataCount();
    return count;
}

int Chart::bandCount() const
{
    int count = 0;
    for (const Strip& strip : m_strips)
        for (const BandGraphs& band : strip.bands)
            count += band.high->dataCount() > 0 ? 1 : 0;
    return count;
}

int Chart::markCount(RunEvent::Kind kind) const
{
    return m_strips.empty() ? 0 : m_strips.front().marks[std::size_t(kind)]->dataCount();
}

std::optional<std::pair<double, double>> Chart::valueRange() const
{
    if (m_strips.size() != 1)
        return std::nullopt;
    const QCPRange range = m_strips.front().values->range();
    return std::pair(range.lower, range.upper);
}

} // namespace ripstop
