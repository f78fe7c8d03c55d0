// Axes stand at the whole numbers of x, and y goes from 0 at the bottom of all axes to 1 at their
// top. Between two axes each pair of heights that occurs is one straight line, heights being
// counted in small steps where there are very many points.
#include "study/parallel_chart.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"
#include "study/shown_value.h"

#include <QEvent>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN(); // between two lines
constexpr double missing = -0.09;                                // y of what has no value
constexpr int steps = 96;                                        // of a height, of many points
constexpr int fewStrokes = 6;                                    // px, that are a click
constexpr double strokeWidth = 0.045;                            // half, of the room of an axis

enum class Seen : char { No, Other, Selected };

} // namespace

ParallelChart::ParallelChart(QWidget* parent)
    : QWidget(parent)
    , m_columns(std::make_shared<const std::vector<StudyColumn>>())
    , m_plot(makePlot(*this))
    , m_others(new QCPCurve(m_plot->xAxis, m_plot->yAxis))
    , m_selected(new QCPCurve(m_plot->xAxis, m_plot->yAxis))
{
    m_plot->setInteractions({}); // a drag is a stroke
    m_plot->yAxis->setVisible(false);
    m_plot->yAxis->setRange(-0.2, 1.12);
    m_plot->xAxis->setTickPen(Qt::NoPen);
    m_plot->xAxis->setSubTickPen(Qt::NoPen);
    setMinimumSize(180, 150);
    connect(m_plot, &QCustomPlot::mousePress, this,
            [this](const QMouseEvent* event) { press(*event); });
    connect(m_plot, &QCustomPlot::mouseMove, this,
            [this](const QMouseEvent* event) { pull(*event); });
    connect(m_plot, &QCustomPlot::mouseRelease, this,
            [this](const QMouseEvent* event) { release(*event); });
    restyle();
}

void ParallelChart::show(SharedColumns columns, const std::vector<std::size_t>& selected)
{
    const auto titles = [](const SharedColumns& all) {
        std::vector<std::string> names;
        for (const StudyColumn& one : *all)
            names.push_back(one.title);
        return names;
    };
    if (titles(columns) != titles(m_columns))
        m_strokes.clear();
    m_columns = std::move(columns);
    m_spans.clear();
    for (const StudyColumn& column : *m_columns) {
        ValueSpan span = spanOf(column.value).value_or(ValueSpan{0.0, 1.0});
        if (span.least == span.largest)
            span = {span.least - 0.5, span.largest + 0.5};
        m_spans.push_back(span);
    }
    drawAxes();
    mark(selected);
}

double ParallelChart::shareOf(std::size_t column, double value) const
{
    const ValueSpan& span = m_spans[column];
    if (!std::isfinite(value))
        return missing;
    if ((*m_columns)[column].isLogarithmic && span.least > 0.0)
        return std::log(value / span.least) / std::log(span.largest / span.least);
    return (value - span.least) / (span.largest - span.least);
}

double ParallelChart::valueAt(std::size_t column, double share) const
{
    const ValueSpan& span = m_spans[column];
    if ((*m_columns)[column].isLogarithmic && span.least > 0.0)
        return span.least * std::pow(span.largest / span.least, share);
    return span.least + share * (span.largest - span.least);
}

QPointF ParallelChart::placeOf(std::size_t column, double value) const
{
    return {m_plot->xAxis->coordToPixel(double(column)),
            m_plot->yAxis->coordToPixel(shareOf(column, value))};
}

void ParallelChart::drawAxes()
{
    m_plot->clearItems();
    m_marks.clear();
    const QColor ink = palette().color(QPalette::Text);
    const QSharedPointer<QCPAxisTickerText> titles(new QCPAxisTickerText);
    const auto write = [&](double x, double y, Qt::Alignment side, const QString& words) {
        auto* text = new QCPItemText(m_plot);
        text->setPositionAlignment(side);
        text->position->setCoords(x, y);
        text->setText(words);
        text->setFont(font());
        text->setColor(ink);
    };
    const int room = width() / std::max(1, int(m_columns->size())); // px, of a title
    for (std::size_t i = 0; i < m_columns->size(); ++i) {
        const StudyColumn& column = (*m_columns)[i];
        titles->addTick(double(i), fontMetrics().elidedText(QString::fromStdString(column.title),
                                                            Qt::ElideMiddle, room - 6));
        auto* axis = new QCPItemLine(m_plot);
        axis->start->setCoords(double(i), 0.0);
        axis->end->setCoords(double(i), 1.0);
        axis->setPen(QPen(ink, 1.4));
        const auto end = [&](double value) {
            const auto place = std::size_t(std::max(0.0, value));
            return place < column.labels.size() ? QString::fromStdString(column.labels[place])
                                                : fourDigits(value);
        };
        write(double(i), 1.02, Qt::AlignHCenter | Qt::AlignBottom, end(m_spans[i].largest));
        write(double(i), -0.02, Qt::AlignHCenter | Qt::AlignTop, end(m_spans[i].least));
        if (std::ranges::any_of(column.value, [](double value) { return !std::isfinite(value); }))
            write(double(i), missing - 0.02, Qt::AlignHCenter | Qt::AlignTop, tr("none", "value"));
    }
    m_plot->xAxis->setTicker(titles);
    m_plot->xAxis->setRange(-0.5, std::max(0.5, double(m_columns->size()) - 0.5));
    drawStrokes();
}

void ParallelChart::drawLines()
{
    const std::size_t count = m_columns->empty() ? 0 : m_columns->front().value.size();
    const bool isCoarse = count > std::size_t(8 * steps);
    const bool hasSelection = !m_isSelected.empty();
    QVector<double> x, y, selectedX, selectedY;
    const auto put = [](QVector<double>& xs, QVector<double>& ys, std::size_t i, double a,
                        double b) {
        xs << double(i) << double(i + 1) << gap;
        ys << a << b << gap;
    };
    constexpr std::size_t heights = steps + 2; // and what has no value
    const auto height = [](double share) {
        return share < 0.0 ? steps + 1 : int(std::lround(share * steps));
    };
    const auto shareAt = [](std::size_t place) {
        return place == heights - 1 ? missing : double(place) / steps;
    };
    for (std::size_t i = 0; i + 1 < m_columns->size(); ++i) {
        std::vector<Seen> seen(isCoarse ? heights * heights : 0, Seen::No);
        for (std::size_t point = 0; point < count; ++point) {
            const double a = shareOf(i, (*m_columns)[i].value[point]);
            const double b = shareOf(i + 1, (*m_columns)[i + 1].value[point]);
            const bool isIn = !hasSelection || m_isSelected[point];
            if (isCoarse) {
                Seen& there = seen[std::size_t(height(a)) * heights + std::size_t(height(b))];
                there = std::max(there, isIn ? Seen::Selected : Seen::Other);
            } else {
                put(isIn ? selectedX : x, isIn ? selectedY : y, i, a, b);
            }
        }
        for (std::size_t place = 0; place < seen.size(); ++place)
            if (seen[place] != Seen::No) {
                const bool isIn = seen[place] == Seen::Selected;
                put(isIn ? selectedX : x, isIn ? selectedY : y, i, shareAt(place / heights),
                    shareAt(place % heights));
            }
    }
    QColor color = curveColor(0, palette());
    const auto lines = double(selectedX.size()) / 3.0 / std::max(1.0, double(m_spans.size()) - 1.0);
    color.setAlphaF(float(std::clamp(40.0 / std::max(1.0, lines), 0.12, 0.9)));
    m_selected->setPen(QPen(color, 1.0));
    m_selected->setAntialiased(!isCoarse);
    m_others->setAntialiased(!isCoarse);
    m_others->setData(x, y);
    m_selected->setData(selectedX, selectedY);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ParallelChart::mark(const std::vector<std::size_t>& selected)
{
    m_isSelected = marksOf(selected, m_columns->empty() ? 0 : m_columns->front().value.size());
    drawLines();
}

// --- brushing ----------------------------------------------------------------------------------

void ParallelChart::press(const QMouseEvent& event)
{
    const double x = m_plot->xAxis->pixelToCoord(event.pos().x());
    const int column = int(std::lround(x));
    constexpr double near = 0.3; // of the way to the next axis
    m_pressed = event.button() == Qt::LeftButton && column >= 0 && column < int(m_columns->size())
                        && std::abs(x - column) < near
                    ? column
                    : -1;
    m_from = event.pos().y();
}

void ParallelChart::pull(const QMouseEvent& event)
{
    if (m_pressed < 0 || std::abs(event.pos().y() - m_from) < fewStrokes)
        return;
    const auto column = std::size_t(m_pressed);
    const auto at = [&](double pixel) {
        return valueAt(column, std::clamp(m_plot->yAxis->pixelToCoord(pixel), 0.0, 1.0));
    };
    const auto [least, largest] = std::minmax({at(m_from), at(event.pos().y())});
    std::erase_if(m_strokes, [&](const ColumnSpan& one) { return one.column == column; });
    m_strokes.push_back({column, {least, largest}});
    drawStrokes();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ParallelChart::release(const QMouseEvent& event)
{
    if (m_pressed < 0)
        return;
    const auto column = std::size_t(std::exchange(m_pressed, -1));
    if (std::abs(event.pos().y() - m_from) < fewStrokes)
        std::erase_if(m_strokes, [&](const ColumnSpan& one) { return one.column == column; });
    drawStrokes();
    emit picked(m_strokes.empty() ? std::vector<std::size_t>() : pointsIn(*m_columns, m_strokes),
                Picking::Replace);
}

void ParallelChart::drawStrokes()
{
    for (QCPItemRect* mark : m_marks)
        m_plot->removeItem(mark);
    m_marks.clear();
    QColor color = curveColor(1, palette());
    for (const ColumnSpan& stroke : m_strokes) {
        auto* mark = new QCPItemRect(m_plot);
        const double x = double(stroke.column);
        mark->topLeft->setCoords(x - strokeWidth, shareOf(stroke.column, stroke.span.largest));
        mark->bottomRight->setCoords(x + strokeWidth, shareOf(stroke.column, stroke.span.least));
        mark->setPen(QPen(color, 1.5));
        color.setAlpha(90);
        mark->setBrush(color);
        color.setAlpha(255);
        m_marks.push_back(mark);
    }
}

void ParallelChart::restyle()
{
    stylePlot(*m_plot, *this);
    m_plot->xAxis->setBasePen(Qt::NoPen);
    m_plot->xAxis->setTickPen(Qt::NoPen);
    m_plot->xAxis->setSubTickPen(Qt::NoPen);
    m_plot->xAxis->grid()->setVisible(false);
    m_plot->yAxis->grid()->setVisible(false);
    QColor grey = palette().color(QPalette::Text);
    grey.setAlpha(45);
    m_others->setPen(QPen(grey, 1.0));
    drawAxes();
    drawLines();
}

void ParallelChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        restyle();
    QWidget::changeEvent(event);
}

void ParallelChart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    drawAxes(); // as much of the titles as has room
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

} // namespace ripstop
