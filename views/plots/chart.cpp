#include "plots/chart.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"

#include <QEvent>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

constexpr double scrolling = 30.0; // s, in sight while the run is followed
constexpr double atFirst = 5.0;    // s, in sight when it begins
constexpr int stripHeight = 84;    // px, at least
constexpr int lastStripExtra = 28; // px, for the numbers of the time axis
constexpr double headroom = 0.08;  // of the values, above and below
constexpr double roomy = 0.55;     // values that fill less of their axis are fitted anew
constexpr double flat = 1e-4;      // of its size: less change than this is shown as no change

// The range that the values should fill: some air around them, and never nothing.
QCPRange around(const QCPRange& values)
{
    const double size = std::max(std::abs(values.lower), std::abs(values.upper));
    const double least = size > 0.0 ? flat * size : 1.0;
    const double span = std::max(values.size(), least);
    const double half = (0.5 + headroom) * span;
    return {values.center() - half, values.center() + half};
}

} // namespace

Chart::Chart(QWidget* parent)
    : QWidget(parent)
    , m_plot(new QCustomPlot)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    m_plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    m_plot->setNoAntialiasingOnDrag(true);
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
    m_past.clear();
    m_revision = -1; // draw everything

    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const QString& unit = m_curves[i].unit;
        auto strip = std::find_if(m_strips.begin(), m_strips.end(),
                                  [&](const Strip& s) { return s.unit == unit; });
        if (strip == m_strips.end()) {
            addStrip(unit);
            strip = m_strips.end() - 1;
        }
        addCurve(*strip, int(i));
    }
    for (Strip& strip : m_strips) {
        const bool last = &strip == &m_strips.back();
        strip.time->setTickLabels(last);
        strip.time->setLabel(last ? tr("time (s)") : QString());
        label(strip);
        scale(strip);
    }
    addPast();
    const QScopedValueRollback setting(m_setting, true);
    takeTime(inSight);
    style();
    updateGeometry();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::addStrip(const QString& unit)
{
    Strip strip;
    strip.unit = unit;
    strip.rect = new QCPAxisRect(m_plot);
    m_plot->plotLayout()->addElement(int(m_strips.size()), 0, strip.rect);
    strip.time = strip.rect->axis(QCPAxis::atBottom);
    strip.values = strip.rect->axis(QCPAxis::atLeft);
    strip.rect->axis(QCPAxis::atTop)->setVisible(true);
    strip.rect->axis(QCPAxis::atRight)->setVisible(true);
    strip.values->ticker()->setTickCount(4);
    strip.rect->setMinimumSize(60, stripHeight / 2);

    // tears stand from 0 to 1 on an axis of their own, which nobody sees or moves
    QCPAxis* whole = strip.rect->addAxis(QCPAxis::atRight);
    whole->setVisible(false);
    whole->setRange(0.0, 1.0);
    strip.tears = m_plot->addGraph(strip.time, whole);
    strip.tears->setLineStyle(QCPGraph::lsImpulse);
    strip.cursor = m_plot->addGraph(strip.time, whole);
    strip.cursor->setLineStyle(QCPGraph::lsImpulse);
    drawCursor(strip);

    connect(strip.time, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &Chart::takeTime);
    const std::size_t index = m_strips.size();
    connect(strip.values, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this, index] {
        if (!m_setting)
            m_strips[index].held = true;
    });
    m_strips.push_back(std::move(strip));
    if (m_strips.size() > 1) { // the value axes stand below each other
        QCPMarginGroup* group = m_strips.front().rect->marginGroup(QCP::msLeft);
        if (!group)
            group = new QCPMarginGroup(m_plot);
        m_strips.front().rect->setMarginGroup(QCP::msLeft | QCP::msRight, group);
        m_strips.back().rect->setMarginGroup(QCP::msLeft | QCP::msRight, group);
    }
}

void Chart::addCurve(Strip& strip, int curve)
{
    QCPGraph* graph = m_plot->addGraph(strip.time, strip.values);
    graph->setName(m_curves[std::size_t(curve)].name);
    graph->setAdaptiveSampling(true);
    m_graphs[std::size_t(curve)] = graph;
    strip.curves.push_back(curve);
}

void Chart::setEarlier(const std::vector<EarlierRun>& earlier)
{
    m_earlier = earlier;
    for (QCPGraph* graph : m_past)
        m_plot->removeGraph(graph);
    m_past.clear();
    addPast();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::addPast()
{
    for (const EarlierRun& run : m_earlier)
        for (const Strip& strip : m_strips)
            for (const int curve : strip.curves) {
                const Curve& of = m_curves[std::size_t(curve)];
                const auto time = run.history.time();
                const auto values = run.history.valuesOf(of.probe);
                if (values.size() != time.size())
                    continue;
                QCPGraph* graph = m_plot->addGraph(strip.time, strip.values);
                QColor color = of.color;
                color.setAlphaF(0.45F);
                graph->setPen(QPen(color, 1.0));
                graph->setAdaptiveSampling(true);
                graph->setLayer(QStringLiteral("grid")); // behind the curves of now
                graph->setData(QVector<double>(time.begin(), time.end()),
                               QVector<double>(values.begin(), values.end()), true);
                m_past.push_back(graph);
            }
}

void Chart::setLogarithmic(bool logarithmic)
{
    m_logarithmic = logarithmic;
    for (Strip& strip : m_strips)
        scale(strip);
    follow();
}

void Chart::scale(Strip& strip) const
{
    strip.values->setScaleType(m_logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    const QSharedPointer<QCPAxisTicker> ticker(m_logarithmic ? new QCPAxisTickerLog
                                                             : new QCPAxisTicker);
    ticker->setTickCount(4);
    strip.values->setTicker(ticker);
}

// The axis has the unit: a name along it would be longer than a strip is high.
void Chart::label(Strip& strip) const
{
    strip.values->setLabel(strip.unit);
    auto* legend = new QCPLegend;
    strip.rect->insetLayout()->addElement(legend, Qt::AlignTop | Qt::AlignLeft);
    legend->setLayer(QStringLiteral("legend"));
    legend->setFillOrder(QCPLegend::foColumnsFirst);
    legend->setWrap(0);
    for (const int curve : strip.curves)
        m_graphs[std::size_t(curve)]->addToLegend(legend);
}

// --- drawing ---------------------------------------------------------------------------------

void Chart::draw(const History& history)
{
    fill(history);
    const QScopedValueRollback setting(m_setting, true);
    if (m_following)
        showTime(history);
    for (Strip& strip : m_strips)
        if (!strip.held)
            fitValues(strip);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::fill(const History& history)
{
    const bool anew = history.revision() != m_revision || m_drawn > history.time().size();
    const std::size_t first = anew ? 0 : m_drawn;
    const auto time = history.time().subspan(first);
    const QVector<double> keys(time.begin(), time.end());
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        if (anew)
            m_graphs[i]->data()->clear();
        const auto values = history.valuesOf(m_curves[i].probe);
        if (values.size() != history.time().size())
            continue; // no frame has had this probe yet
        const auto fresh = values.subspan(first);
        m_graphs[i]->addData(keys, QVector<double>(fresh.begin(), fresh.end()), true);
    }
    const auto tears = history.tears();
    for (const Strip& strip : m_strips)
        if (anew || strip.tears->dataCount() != int(tears.size()))
            strip.tears->setData(QVector<double>(tears.begin(), tears.end()),
                                 QVector<double>(qsizetype(tears.size()), 1.0), true);
    m_drawn = history.time().size();
    m_revision = history.revision();
}

void Chart::setCursor(std::optional<double> time)
{
    if (std::exchange(m_cursor, time) == time)
        return;
    for (const Strip& strip : m_strips)
        drawCursor(strip);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::drawCursor(const Strip& strip) const
{
    if (m_cursor)
        strip.cursor->setData({*m_cursor}, {1.0}, true);
    else
        strip.cursor->setData({}, {}, true);
}

void Chart::showTime(const History& history)
{
    const auto time = history.time();
    const double first = time.empty() ? 0.0 : time.front();
    const double now = time.empty() ? 0.0 : time.back();
    const double from = m_wholeRun ? first : std::max(first, now - scrolling);
    takeTime({from, std::max(now, from + atFirst)});
}

void Chart::fitValues(Strip& strip)
{
    QCPRange values;
    bool any = false;
    for (const int curve : strip.curves) {
        bool found = false;
        const QCPRange one = m_graphs[std::size_t(curve)]->getValueRange(
            found, m_logarithmic ? QCP::sdPositive : QCP::sdBoth, strip.time->range());
        if (found)
            values = any ? values.expanded(one) : one;
        any = any || found;
    }
    if (!any)
        return;
    if (m_logarithmic) {
        constexpr double room = 1.3; // times
        strip.values->setRange(values.lower / room, values.upper * room);
        return;
    }
    const QCPRange wanted = around(values);
    const QCPRange shown = strip.values->range();
    const bool fits = shown.contains(values.lower) && shown.contains(values.upper)
                      && wanted.size() > roomy * shown.size();
    if (!fits) // an axis that moved with every sample could not be read
        strip.values->setRange(wanted);
}

// --- hands on it -----------------------------------------------------------------------------

void Chart::follow()
{
    m_following = true;
    m_revision = -1; // the next draw() shows it; nothing may come while the run is paused
    for (Strip& strip : m_strips)
        strip.held = false;
    emit followed();
}

void Chart::setWholeRun(bool whole)
{
    m_wholeRun = whole;
    follow();
}

void Chart::takeTime(const QCPRange& range)
{
    if (!m_setting)
        m_following = false;
    const QScopedValueRollback setting(m_setting, true);
    for (const Strip& strip : m_strips)
        strip.time->setRange(range);
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
}

bool Chart::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Leave)
        emit hovered(std::nullopt);
    return QWidget::eventFilter(watched, event);
}

// --- looks -----------------------------------------------------------------------------------

void Chart::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        style();
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
    const bool dark = isDark(palette());
    strip.tears->setPen(
        QPen(dark ? QColor(0xff, 0x6b, 0x60) : QColor(0xc6, 0x28, 0x28), 1, Qt::DashLine));
    strip.cursor->setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    for (const int curve : strip.curves)
        m_graphs[std::size_t(curve)]->setPen(QPen(m_curves[std::size_t(curve)].color, 1.6));
    if (strip.rect->insetLayout()->elementCount() > 0) {
        auto* legend = qobject_cast<QCPLegend*>(strip.rect->insetLayout()->elementAt(0));
        styleLegend(*legend, *this);
        legend->setMargins({4, 1, 4, 1});
        legend->setRowSpacing(0);
        legend->setIconSize(16, 10);
    }
}

QSize Chart::minimumSizeHint() const
{
    const int strips = std::max(1, int(m_strips.size()));
    return {200, strips * stripHeight + lastStripExtra};
}

double Chart::timeFrom() const { return m_strips.front().time->range().lower; }
double Chart::timeTo() const { return m_strips.front().time->range().upper; }

} // namespace ripstop
