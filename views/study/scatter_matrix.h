// A scatter matrix: each column of a study over each other one, and on the diagonal how often its
// values occur. A rubber band in a cell selects the points in it, which are drawn in colour before
// the grey others. Of very many points those that would fall on each other are drawn once. Only the
// window's thread uses it.
#pragma once

#include "study/parallel_chart.h"

class QCPAxisRect;
class QCPBars;
class QCPGraph;
class QRubberBand;

namespace ripstop {

class ScatterMatrix final : public QWidget
{
    Q_OBJECT

public:
    explicit ScatterMatrix(QWidget* parent = nullptr);

    static constexpr std::size_t mostColumns = 6; // of those that are given, the first

    //   selected  points by their numbers in the study; none: all are drawn alike
    void show(SharedColumns columns, const std::vector<std::size_t>& selected);
    using QWidget::show;
    void mark(const std::vector<std::size_t>& selected);

    QCustomPlot& plot() { return *m_plot; }
    // Where a point stands in the cell of two columns, px of the plot; `y` comes after `x`.
    QPointF placeOf(std::size_t x, std::size_t y, std::size_t point) const;

signals:
    void picked(const std::vector<std::size_t>& points, ripstop::Picking how);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Cell // of two different columns
    {
        std::size_t x;
        std::size_t y;
        QCPAxisRect* rect;
        QCPGraph* others;
        QCPGraph* selected;
    };
    struct Diagonal
    {
        std::size_t column;
        QCPBars* bars;
        QCPBars* selected;
    };

    std::size_t roomFor() const; // columns
    void build();
    void addCell(std::size_t x, std::size_t y);
    void addDiagonal(std::size_t column);
    void fill();
    void fillCell(const Cell& cell);
    void fillDiagonal(const Diagonal& diagonal);
    void restyle();
    void pull(const QPoint& place);
    void release(const QMouseEvent& event);
    bool isSelected(std::size_t point) const { return m_isSelected.empty() || m_isSelected[point]; }

    SharedColumns m_columns;
    std::size_t m_shown = 0; // columns
    std::vector<char> m_isSelected;
    std::vector<Cell> m_cells;
    std::vector<Diagonal> m_diagonals;
    const Cell* m_pressed = nullptr;
    QPoint m_from;
    QCustomPlot* m_plot;
    QRubberBand* m_band;
};

} // namespace ripstop
