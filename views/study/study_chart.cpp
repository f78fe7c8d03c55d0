// show() draws axes, cells or points, and lines anew. Cells are drawn where their numbers are, with
// the values of the study as the texts of the axes, so that columns are even for any values. Points
// are graphs, one for each of some shades, since a graph has one colour.
#include "study/study_chart.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"
#include "study/shown_value.h"

#include <QEvent>
#include <QMouseEvent>
#include <QRubberBand>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace ripstop {
namespace {

constexpr int shadeCount = 24;
constexpr int mostContours = 8;
constexpr double gap = std::numeric_limits<double>::quiet_NaN(); // between two segments
constexpr double nearPoint = 12.0;                               // px
constexpr std::size_t manyPoints = 5000; // that are not all drawn where they cover each other
constexpr double samePlace = 4.0;        // px, within which they do

// Even steps in lightness from dark blue to yellow, for the colour-blind too (the colours of
// viridis, by Smith and van der Walt 2015).
QCPColorGradient colours()
{
    constexpr std::array<QRgb, 9> stops{0xff440154, 0xff472d7b, 0xff3b528b, 0xff2c728e, 0xff21918c,
                                        0xff28ae80, 0xff5ec962, 0xffaddc30, 0xfffde725};
    QCPColorGradient gradient;
    gradient.clearColorStops();
    for (std::size_t i = 0; i < stops.size(); ++i)
        gradient.setColorStopAt(double(i) / double(stops.size() - 1), QColor::fromRgb(stops[i]));
    gradient.setNanHandling(QCPColorGradient::nhTransparent);
    return gradient;
}

// With some room where all are alike, or from 0 to 1 where there is nothing.
QCPRange rangeOf(const std::optional<ValueSpan>& span)
{
    if (!span)
        return {0.0, 1.0};
    const double size = std::abs(span->least);
    const double room = span->least < span->largest ? 0.0 : size > 0.0 ? 0.05 * size : 1.0;
    return {span->least - room, span->largest + room};
}

QCPRange placesOf(const StudyMap& map, double StudyMap::Point::*axis)
{
    std::optional<ValueSpan> span;
    if (!map.points.empty()) {
        const auto [least, largest] = std::ranges::minmax(map.points, {}, axis);
        span = ValueSpan{least.*axis, largest.*axis};
    }
    return rangeOf(span);
}

// Values of a grid at its columns, as many as have room.
QSharedPointer<QCPAxisTicker> gridTicker(const std::vector<std::string>& labels, int most)
{
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    const std::size_t every = 1 + (labels.size() - 1) / std::size_t(std::max(1, most));
    for (std::size_t i = 0; i < labels.size(); i += every) {
        ticker->addTick(double(i), shownValue(labels[i]));
    }
    return ticker;
}

} // namespace

StudyChart::StudyChart(QWidget* parent)
    : QWidget(parent)
    , m_band(new QRubberBand(QRubberBand::Rectangle, this))
    , m_plot(makePlot(*this))
    , m_cells(new QCPColorMap(m_plot->xAxis, m_plot->yAxis))
    , m_scale(new QCPColorScale(m_plot))
    , m_contours(new QCPCurve(m_plot->xAxis, m_plot->yAxis))
    , m_frontier(new QCPCurve(m_plot->xAxis, m_plot->yAxis))
{
    m_plot->plotLayout()->addElement(0, 1, m_scale);
    m_scale->setType(QCPAxis::atRight);
    m_saidX = new SpokenAxis(*m_plot->xAxis);
    m_saidY = new SpokenAxis(*m_plot->yAxis);
    m_saidScale = new SpokenAxis(*m_scale->axis());
    m_scale->setGradient(colours());
    m_scale->setBarWidth(12);
    m_cells->setColorScale(m_scale);
    m_cells->setGradient(colours());
    m_cells->setInterpolate(false);
    m_cells->setTightBoundary(false);
    for (int i = 0; i < shadeCount; ++i) {
        m_shades.push_back(m_plot->addGraph());
        m_shades.back()->setLineStyle(QCPGraph::lsNone);
    }
    m_torn = m_plot->addGraph();
    m_torn->setLineStyle(QCPGraph::lsNone);
    m_crosses = m_plot->addGraph();
    m_crosses->setLineStyle(QCPGraph::lsNone);
    m_doubts = m_plot->addGraph();
    m_doubts->setLineStyle(QCPGraph::lsNone);
    m_doubts->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(QColor(Qt::black), 1.0),
                                              QBrush(QColor(Qt::white)), 5));
    m_outlines = new QCPCurve(m_plot->xAxis, m_plot->yAxis);
    m_rings = m_plot->addGraph();
    m_rings->setLineStyle(QCPGraph::lsNone);
    m_mark = new QCPItemRect(m_plot);
    m_mark->setVisible(false);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis})
        axis->grid()->setVisible(false);

    m_plot->setInteractions(QCP::iRangeZoom); // a drag is a rubber band
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, [this] {
        drawAxes();
        drawMarks();
    });
    setMinimumSize(180, 150);
    connect(m_plot, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
        if (event->button() == Qt::LeftButton)
            pick(*event);
    });
    connect(m_plot, &QCustomPlot::mouseRelease, this,
            [this](const QMouseEvent* event) { pickBand(*event); });
    connect(m_plot, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
        pull(*event);
        const auto place = at(event->pos());
        emit pointedAt(place ? qlonglong(m_map.points[*place].number) : -1);
    });
    restyle();
}

void StudyChart::restyle()
{
    stylePlot(*m_plot, *this);
    styleAxis(*m_scale->axis(), *this);
    const QColor ink = palette().color(QPalette::Text);
    m_contours->setPen(QPen(QColor(255, 255, 255, 130), 1.0));
    m_frontier->setPen(QPen(isDark(palette()) ? QColor(Qt::white) : QColor(Qt::black), 3.0,
                            Qt::SolidLine, Qt::RoundCap));
    m_crosses->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCross, QPen(QColor(220, 50, 40), 2.0), Qt::NoBrush, 9));
    m_torn->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(ink, 1.6), Qt::NoBrush, 11));
    m_mark->setPen(QPen(QColor(230, 60, 50), 2.5));
    const QPen selected(QColor(230, 60, 50), 1.6);
    m_outlines->setPen(selected);
    m_rings->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, selected, Qt::NoBrush, 12));
    QCPColorGradient gradient = colours();
    for (int i = 0; i < shadeCount; ++i)
        m_shades[std::size_t(i)]->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssDisc,
                            QColor::fromRgb(gradient.color(i + 0.5, QCPRange(0, shadeCount))), 8));
}

void StudyChart::show(const StudyMap& map, const QString& reading)
{
    m_map = map;
    m_reading = reading;
    drawAxes();
    drawCells();
    drawPoints();
    drawLines();
    drawMarks();
}

double StudyChart::heightOf(const StudyMap::Point& point) const
{
    return hasHeights() ? point.shown() : point.y;
}

void StudyChart::drawAxes()
{
    const QCPRange values = rangeOf(valueSpan(m_map));
    QCPAxis& x = *m_plot->xAxis;
    QCPAxis& y = *m_plot->yAxis;
    m_scale->setVisible(!hasHeights());
    m_saidScale->say(hasHeights() ? AxisWords() : wordsOfHeading(m_reading));
    m_scale->setDataRange(values);
    const QString across = QString::fromStdString(m_map.x.title);
    const QString upwards = hasHeights() ? m_reading : QString::fromStdString(m_map.y->title);
    if (m_map.isGrid) { // its values stand as they were typed
        m_saidX->setLogarithmic(false);
        m_saidX->say({across, {}});
        m_saidY->setLogarithmic(false);
        m_saidY->say(hasHeights() ? wordsOfHeading(upwards) : AxisWords{upwards, {}});
        x.setTicker(gridTicker(m_map.x.labels, std::max(2, width() / 80)));
        x.setRange(-0.5, double(m_map.columns()) - 0.5);
        if (!hasHeights()) {
            y.setTicker(gridTicker(m_map.y->labels, std::max(2, height() / 30)));
            y.setRange(-0.5, double(m_map.rows()) - 0.5);
        }
    } else {
        m_saidX->setLogarithmic(m_map.x.isLogarithmic);
        m_saidX->say(wordsOfHeading(across));
        m_saidY->setLogarithmic(m_map.y && m_map.y->isLogarithmic);
        m_saidY->say(wordsOfHeading(upwards));
        const auto fit = [&](QCPAxis& axis, const QCPRange& span) {
            axis.setRange(axis.scaleType() == QCPAxis::stLogarithmic
                              ? QCPRange(0.9 * span.lower, 1.1 * span.upper)
                              : withAir(span));
        };
        fit(x, placesOf(m_map, &StudyMap::Point::x));
        if (!hasHeights())
            fit(y, placesOf(m_map, &StudyMap::Point::y));
    }
    if (hasHeights())
        y.setRange(withAir(values));
}

void StudyChart::drawCells()
{
    m_cells->setVisible(m_map.isGrid && !hasHeights());
    if (!m_cells->visible())
        return;
    const int columns = int(m_map.columns());
    const int rows = int(m_map.rows());
    // ranges are those of the middles of the outer cells
    m_cells->data()->setSize(columns, rows);
    m_cells->data()->setRange(QCPRange(0.0, std::max(1, columns - 1)),
                              QCPRange(0.0, std::max(1, rows - 1)));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            m_cells->data()->setCell(column, row,
                                     m_map.points[std::size_t(row * columns + column)].shown());
    m_cells->setDataRange(m_scale->dataRange());
}

void StudyChart::drawPoints()
{
    const bool areCells = m_cells->visible();
    const QCPRange values = rangeOf(valueSpan(m_map));
    std::vector<QVector<double>> x(shadeCount), y(shadeCount);
    std::set<std::array<int, 3>> drawn; // shade and place of very many points, each once
    const bool areMany = m_map.points.size() > manyPoints;
    QVector<double> tornX, tornY, crossX, crossY, doubtX, doubtY;
    for (const StudyMap::Point& point : m_map.points) {
        const double height = heightOf(point);
        if (point.outcome == FlightOutcome::Stopped) {
            crossX << point.x; // at the bottom, as it has no height
            crossY << (std::isfinite(height) ? height : m_plot->yAxis->range().lower);
        }
        if (point.isInaccurate && std::isfinite(height)) {
            doubtX << point.x;
            doubtY << height;
        }
        if (areCells || !std::isfinite(point.shown()))
            continue;
        const double share = (point.value - values.lower) / values.size();
        const auto shade = std::size_t(std::clamp(int(share * shadeCount), 0, shadeCount - 1));
        if (areMany) {
            const QPointF there = placeOf(point) / samePlace;
            if (!drawn.insert({int(shade), int(there.x()), int(there.y())}).second)
                continue;
        }
        x[shade] << point.x;
        y[shade] << height;
        if (point.outcome == FlightOutcome::Torn) {
            tornX << point.x;
            tornY << height;
        }
    }
    for (std::size_t i = 0; i < x.size(); ++i)
        m_shades[i]->setData(x[i], y[i]);
    m_torn->setData(tornX, tornY);
    m_crosses->setData(crossX, crossY);
    m_doubts->setData(doubtX, doubtY);
}

void StudyChart::drawLines()
{
    const auto put = [](QCPCurve& curve, const std::vector<MapSegment>& lines) {
        QVector<double> x, y;
        for (const MapSegment& line : lines) {
            x << line.from[0] << line.to[0] << gap;
            y << line.from[1] << line.to[1] << gap;
        }
        curve.setData(x, y);
    };
    std::vector<MapSegment> contours;
    if (!hasHeights())
        for (const double level : contourLevels(m_map, mostContours)) {
            const auto more = contour(m_map, level);
            contours.insert(contours.end(), more.begin(), more.end());
        }
    put(*m_contours, contours);
    put(*m_frontier, hasHeights() ? std::vector<MapSegment>() : frontier(m_map));
}

// --- what is picked -----------------------------------------------------------------------------

void StudyChart::pick(const QMouseEvent& event)
{
    m_pressed = event.pos();
    const auto place = at(event.pos());
    if (!place)
        return;
    const Picking how = pickingOf(event.modifiers());
    if (how == Picking::Add && m_map.isGrid)
        emit picked(spanTo(*place), how);
    else
        emit picked({m_map.points[*place].number}, how);
}

// The cells of the rectangle between the chosen one and this one.
std::vector<std::size_t> StudyChart::spanTo(std::size_t place) const
{
    const StudyMap::Point& to = m_map.points[place];
    const auto found =
        std::ranges::find_if(m_map.points, [&](const auto& one) { return one.number == m_marked; });
    const StudyMap::Point& from = m_marked && found != m_map.points.end() ? *found : to;
    const auto [left, right] = std::minmax(from.x, to.x);
    const auto [below, above] = std::minmax(from.y, to.y);
    std::vector<std::size_t> numbers;
    for (const StudyMap::Point& one : m_map.points)
        if (one.x >= left && one.x <= right && one.y >= below && one.y <= above)
            numbers.push_back(one.number);
    return numbers;
}

void StudyChart::pull(const QMouseEvent& event)
{
    constexpr int shortest = 6; // px, that is no click with an unsteady hand
    const QPoint way = event.pos() - m_pressed;
    if (!event.buttons().testFlag(Qt::LeftButton)
        || (!m_band->isVisible() && way.manhattanLength() < shortest))
        return;
    m_band->setGeometry(QRect(m_pressed, event.pos()).normalized());
    m_band->show();
    m_band->raise();
}

void StudyChart::pickBand(const QMouseEvent& event)
{
    if (!m_band->isVisible())
        return;
    m_band->hide();
    const QRectF band = QRect(m_pressed, event.pos()).normalized();
    std::vector<std::size_t> numbers;
    for (const StudyMap::Point& one : m_map.points)
        if (band.contains(placeOf(one)))
            numbers.push_back(one.number);
    const bool adds = pickingOf(event.modifiers()) != Picking::Replace;
    emit picked(numbers, adds ? Picking::Add : Picking::Replace);
}

void StudyChart::mark(const std::vector<std::size_t>& selected, std::optional<std::size_t> chosen)
{
    m_selected = selected;
    m_marked = chosen;
    drawMarks();
}

void StudyChart::drawMarks()
{
    std::vector<std::size_t> selected = m_selected;
    std::ranges::sort(selected);
    const bool areCells = m_cells->visible();
    QVector<double> x, y, ringX, ringY;
    const StudyMap::Point* chosen = nullptr;
    std::set<std::array<int, 2>> ringed; // places of very many, each once
    const auto isFirstAt = [&](const StudyMap::Point& point) {
        if (selected.size() < manyPoints)
            return true;
        const QPointF there = placeOf(point) / samePlace;
        return ringed.insert({int(there.x()), int(there.y())}).second;
    };
    for (const StudyMap::Point& one : m_map.points) {
        if (one.number == m_marked)
            chosen = &one;
        if (selected.size() < 2 || !std::ranges::binary_search(selected, one.number))
            continue;
        if (areCells) {
            for (const auto& [right, up] :
                 {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}}) {
                x << one.x + right;
                y << one.y + up;
            }
            x << gap;
            y << gap;
        } else if (std::isfinite(heightOf(one)) && isFirstAt(one)) {
            ringX << one.x;
            ringY << heightOf(one);
        }
    }
    m_outlines->setData(x, y);
    m_rings->setData(ringX, ringY);
    m_mark->setVisible(chosen != nullptr);
    if (chosen && areCells) {
        m_mark->topLeft->setType(QCPItemPosition::ptPlotCoords);
        m_mark->bottomRight->setType(QCPItemPosition::ptPlotCoords);
        m_mark->topLeft->setCoords(chosen->x - 0.5, chosen->y + 0.5);
        m_mark->bottomRight->setCoords(chosen->x + 0.5, chosen->y - 0.5);
    } else if (chosen) {
        const QPointF place = placeOf(*chosen);
        m_mark->topLeft->setPixelPosition(place - QPointF(7, 7));
        m_mark->bottomRight->setPixelPosition(place + QPointF(7, 7));
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

std::optional<std::size_t> StudyChart::at(const QPointF& place) const
{
    if (!m_plot->axisRect()->rect().contains(place.toPoint()))
        return std::nullopt;
    if (m_cells->visible()) {
        const double column = std::round(m_plot->xAxis->pixelToCoord(place.x()));
        const double row = std::round(m_plot->yAxis->pixelToCoord(place.y()));
        if (column < 0 || row < 0 || column >= double(m_map.columns())
            || row >= double(m_map.rows()))
            return std::nullopt;
        return std::size_t(row) * m_map.columns() + std::size_t(column);
    }
    std::optional<std::size_t> nearest;
    double least = nearPoint;
    for (std::size_t i = 0; i < m_map.points.size(); ++i) {
        const StudyMap::Point& point = m_map.points[i];
        if (!std::isfinite(heightOf(point)))
            continue;
        const QPointF away = placeOf(point) - place;
        if (const double distance = std::hypot(away.x(), away.y()); distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

QPointF StudyChart::placeOf(std::size_t point) const
{
    const auto found =
        std::ranges::find_if(m_map.points, [&](const auto& one) { return one.number == point; });
    return found == m_map.points.end() ? QPointF() : placeOf(*found);
}

QPointF StudyChart::placeOf(const StudyMap::Point& point) const
{
    return {m_plot->xAxis->coordToPixel(point.x), m_plot->yAxis->coordToPixel(heightOf(point))};
}

void StudyChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        restyle();
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
    QWidget::changeEvent(event);
}

// As many values stand at the axes as have room.
void StudyChart::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    drawAxes();
    drawMarks(); // draws it again
}

} // namespace ripstop
