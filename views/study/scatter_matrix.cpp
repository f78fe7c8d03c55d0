// build() makes a cell for each pair below the diagonal when there are other columns than before;
// fill() gives them their points.
#include "study/scatter_matrix.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"
#include "plots/spoken_axis.h"

#include <QEvent>
#include <QRubberBand>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int stepsOfSide = 96;         // of a side of a cell, of very many points
constexpr std::size_t fewPoints = 2000; // that are drawn each
constexpr int bins = 24;                // of a diagonal
constexpr int shortest = 6;             // px, that is no click

QCPRange rangeOf(const StudyColumn& column)
{
    const auto span = spanOf(column.value);
    if (!span)
        return {0.0, 1.0};
    if (column.isLogarithmic && span->least > 0.0)
        return {0.9 * span->least, 1.1 * span->largest};
    return withAir({span->least, span->largest});
}

bool isLogarithmic(const StudyColumn& column)
{
    const auto span = spanOf(column.value);
    return column.isLogarithmic && span && span->least > 0.0;
}

// A spoken axis writes its whole title, which has no room here.
void giveScale(QCPAxis& axis, bool isLogarithmic)
{
    axis.setScaleType(isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    constexpr int most = 3;
    const QSharedPointer<QCPAxisTicker> even(new QCPAxisTicker);
    even->setTickCount(most);
    axis.setTicker(isLogarithmic ? decadeTicker(most) : even);
}

} // namespace

ScatterMatrix::ScatterMatrix(QWidget* parent)
    : QWidget(parent)
    , m_columns(std::make_shared<const std::vector<StudyColumn>>())
    , m_plot(makePlot(*this))
    , m_band(new QRubberBand(QRubberBand::Rectangle, this))
{
    m_plot->setInteractions({}); // a drag is a rubber band
    m_plot->plotLayout()->clear();
    m_plot->plotLayout()->setRowSpacing(0);
    m_plot->plotLayout()->setColumnSpacing(0);
    setMinimumSize(180, 150);
    connect(m_plot, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
        m_from = event->pos();
        const auto found = std::ranges::find_if(
            m_cells, [&](const Cell& cell) { return cell.rect->rect().contains(m_from); });
        m_pressed = event->button() == Qt::LeftButton && found != m_cells.end() ? &*found : nullptr;
    });
    connect(m_plot, &QCustomPlot::mouseMove, this,
            [this](const QMouseEvent* event) { pull(event->pos()); });
    connect(m_plot, &QCustomPlot::mouseRelease, this,
            [this](const QMouseEvent* event) { release(*event); });
}

void ScatterMatrix::show(SharedColumns columns, const std::vector<std::size_t>& selected)
{
    const std::size_t shown = std::min(columns->size(), roomFor());
    bool isSame = shown == m_shown && m_shown <= m_columns->size();
    for (std::size_t i = 0; isSame && i < shown; ++i)
        isSame = (*columns)[i].title == (*m_columns)[i].title;
    m_columns = std::move(columns);
    m_shown = shown;
    if (!isSame)
        build();
    mark(selected);
}

// As many as can be read: a low panel shows fewer.
std::size_t ScatterMatrix::roomFor() const
{
    constexpr int least = 52; // px, of a cell
    return std::clamp<std::size_t>(std::size_t(height() / least), 2, mostColumns);
}

void ScatterMatrix::build()
{
    m_pressed = nullptr;
    m_cells.clear();
    m_diagonals.clear();
    m_plot->clearPlottables();
    m_plot->plotLayout()->clear();
    for (std::size_t row = 0; row < m_shown; ++row)
        for (std::size_t column = 0; column <= row; ++column)
            if (column == row)
                addDiagonal(column);
            else
                addCell(column, row);
    restyle();
}

void ScatterMatrix::addCell(std::size_t x, std::size_t y)
{
    auto* rect = new QCPAxisRect(m_plot);
    m_plot->plotLayout()->addElement(int(y), int(x), rect);
    QCPAxis* across = rect->axis(QCPAxis::atBottom);
    QCPAxis* upwards = rect->axis(QCPAxis::atLeft);
    Cell cell{x, y, rect, m_plot->addGraph(across, upwards), m_plot->addGraph(across, upwards)};
    for (QCPGraph* graph : {cell.others, cell.selected})
        graph->setLineStyle(QCPGraph::lsNone);
    m_cells.push_back(cell);
}

void ScatterMatrix::addDiagonal(std::size_t column)
{
    auto* rect = new QCPAxisRect(m_plot);
    m_plot->plotLayout()->addElement(int(column), int(column), rect);
    QCPAxis* across = rect->axis(QCPAxis::atBottom);
    QCPAxis* upwards = rect->axis(QCPAxis::atLeft);
    m_diagonals.push_back({column, new QCPBars(across, upwards), new QCPBars(across, upwards)});
}

void ScatterMatrix::fill()
{
    for (const Cell& cell : m_cells)
        fillCell(cell);
    for (const Diagonal& diagonal : m_diagonals)
        fillDiagonal(diagonal);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ScatterMatrix::fillCell(const Cell& cell)
{
    const StudyColumn& xs = (*m_columns)[cell.x];
    const StudyColumn& ys = (*m_columns)[cell.y];
    QCPAxis& across = *cell.rect->axis(QCPAxis::atBottom);
    QCPAxis& upwards = *cell.rect->axis(QCPAxis::atLeft);
    giveScale(across, isLogarithmic(xs));
    giveScale(upwards, isLogarithmic(ys));
    across.setRange(rangeOf(xs));
    upwards.setRange(rangeOf(ys));
    const auto place = [](const QCPAxis& axis, double value) {
        const QCPRange& range = axis.range();
        const double share =
            axis.scaleType() == QCPAxis::stLogarithmic
                ? std::log(value / range.lower) / std::log(range.upper / range.lower)
                : (value - range.lower) / range.size();
        return std::size_t(std::clamp(int(share * stepsOfSide), 0, stepsOfSide - 1));
    };
    const std::size_t count = xs.value.size();
    std::vector<char> seen(count > fewPoints ? std::size_t(2 * stepsOfSide * stepsOfSide) : 0, 0);
    QVector<double> x, y, selectedX, selectedY;
    for (std::size_t point = 0; point < count; ++point) {
        const double a = xs.value[point];
        const double b = ys.value[point];
        if (!std::isfinite(a) || !std::isfinite(b))
            continue;
        const bool isIn = isSelected(point);
        if (!seen.empty()) {
            char& there =
                seen[((isIn ? stepsOfSide : 0) + place(upwards, b)) * std::size_t(stepsOfSide)
                     + place(across, a)];
            if (std::exchange(there, 1) == 1)
                continue;
        }
        (isIn ? selectedX : x) << a;
        (isIn ? selectedY : y) << b;
    }
    cell.others->setData(x, y);
    cell.selected->setData(selectedX, selectedY);
}

void ScatterMatrix::fillDiagonal(const Diagonal& diagonal)
{
    const StudyColumn& column = (*m_columns)[diagonal.column];
    const QCPRange range = rangeOf(column);
    const double width = range.size() / bins;
    QVector<double> x(bins), all(bins, 0.0), selected(bins, 0.0);
    for (int i = 0; i < bins; ++i)
        x[i] = range.lower + (i + 0.5) * width;
    for (std::size_t point = 0; point < column.value.size(); ++point) {
        const double value = column.value[point];
        if (!std::isfinite(value))
            continue;
        const int bin = std::clamp(int((value - range.lower) / width), 0, bins - 1);
        all[bin] += 1.0;
        if (isSelected(point))
            selected[bin] += 1.0;
    }
    for (QCPBars* bars : {diagonal.bars, diagonal.selected})
        bars->setWidth(width);
    diagonal.bars->setData(x, all, true);
    diagonal.selected->setData(x, selected, true);
    diagonal.bars->keyAxis()->setRange(range);
    diagonal.bars->valueAxis()->setRange(
        0.0, 1.05 * std::max(1.0, *std::max_element(all.begin(), all.end())));
}

void ScatterMatrix::mark(const std::vector<std::size_t>& selected)
{
    m_isSelected = marksOf(selected, m_columns->empty() ? 0 : m_columns->front().value.size());
    fill();
}

QPointF ScatterMatrix::placeOf(std::size_t x, std::size_t y, std::size_t point) const
{
    const auto found =
        std::ranges::find_if(m_cells, [&](const Cell& cell) { return cell.x == x && cell.y == y; });
    if (found == m_cells.end())
        return {};
    return {found->rect->axis(QCPAxis::atBottom)->coordToPixel((*m_columns)[x].value[point]),
            found->rect->axis(QCPAxis::atLeft)->coordToPixel((*m_columns)[y].value[point])};
}

// --- brushing ----------------------------------------------------------------------------------

void ScatterMatrix::pull(const QPoint& place)
{
    if (!m_pressed || (place - m_from).manhattanLength() < shortest)
        return;
    m_band->setGeometry(QRect(m_from, place).normalized() & m_pressed->rect->rect());
    m_band->show();
    m_band->raise();
}

// A click beside all points, as a band without any, selects none.
void ScatterMatrix::release(const QMouseEvent& event)
{
    const Cell* cell = std::exchange(m_pressed, nullptr);
    m_band->hide();
    if (!cell)
        return;
    QRect band = QRect(m_from, event.pos()).normalized();
    if ((event.pos() - m_from).manhattanLength() < shortest)
        band.adjust(-shortest, -shortest, shortest, shortest);
    const QCPAxis& across = *cell->rect->axis(QCPAxis::atBottom);
    const QCPAxis& upwards = *cell->rect->axis(QCPAxis::atLeft);
    const auto span = [](const QCPAxis& axis, int one, int other) {
        const auto [least, largest] =
            std::minmax({axis.pixelToCoord(one), axis.pixelToCoord(other)});
        return ValueSpan{least, largest};
    };
    emit picked(pointsIn(*m_columns, {{cell->x, span(across, band.left(), band.right())},
                                      {cell->y, span(upwards, band.top(), band.bottom())}}),
                pickingOf(event.modifiers()));
}

// --- looks -------------------------------------------------------------------------------------

void ScatterMatrix::restyle()
{
    m_plot->setBackground(palette().base());
    const QColor color = curveColor(0, palette());
    QColor grey = palette().color(QPalette::Text);
    grey.setAlpha(70);
    const auto style = [&](QCPAxisRect& rect, std::size_t x, std::size_t y) {
        rect.setMinimumMargins(QMargins(2, 2, 2, 2));
        const bool isLeft = x == 0 && y > 0;
        const bool isBottom = y + 1 == m_shown;
        for (const auto& [side, isOuter, column] :
             {std::tuple{QCPAxis::atLeft, isLeft, y}, {QCPAxis::atBottom, isBottom, x}}) {
            QCPAxis& axis = *rect.axis(side);
            styleAxis(axis, *this);
            axis.setTickLabels(isOuter);
            const int room = (side == QCPAxis::atLeft ? height() : width()) / int(m_shown) - 8;
            const QString title = QString::fromStdString((*m_columns)[column].title);
            axis.setLabel(isOuter ? fontMetrics().elidedText(title, Qt::ElideRight, room)
                                  : QString());
            axis.grid()->setVisible(false);
        }
        rect.setupFullAxesBox();
        for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) {
            styleAxis(*rect.axis(side), *this);
            rect.axis(side)->setTicks(false);
        }
    };
    for (const Cell& cell : m_cells) {
        style(*cell.rect, cell.x, cell.y);
        cell.others->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssSquare, QPen(grey), grey, 3));
        cell.selected->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssSquare, QPen(color), color, 3));
    }
    for (const Diagonal& diagonal : m_diagonals) {
        style(*diagonal.bars->keyAxis()->axisRect(), diagonal.column, diagonal.column);
        diagonal.bars->valueAxis()->setTicks(false);
        diagonal.bars->setPen(Qt::NoPen);
        diagonal.bars->setBrush(grey);
        diagonal.selected->setPen(Qt::NoPen);
        diagonal.selected->setBrush(color);
    }
}

void ScatterMatrix::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (std::min(m_columns->size(), roomFor()) != m_shown) {
        m_shown = std::min(m_columns->size(), roomFor());
        build();
        fill();
    } else {
        restyle(); // as much of the titles as has room
    }
}

void ScatterMatrix::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        restyle();
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
    QWidget::changeEvent(event);
}

} // namespace ripstop
