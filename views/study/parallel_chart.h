// Parallel coordinates: an axis for each column, and a line through its values for each point of
// the study (Inselberg 1985).
//
// A stroke along an axis brushes it: the points whose values lie in all strokes are selected and
// drawn in colour, the others in grey behind them. A click on an axis takes its stroke away. A
// point without a value on an axis runs below it, where it is called so: none is left out. Of very
// many points lines that would fall on each other are drawn once; what is brushed is decided by the
// numbers. Only the window's thread uses it.
#pragma once

#include "study/picking.h"
#include "study/study_columns.h"

#include <QWidget>

#include <memory>

class QCPCurve;
class QCPItemLine;
class QCPItemRect;
class QCustomPlot;
class QMouseEvent;

namespace ripstop {

using SharedColumns = std::shared_ptr<const std::vector<StudyColumn>>;

class ParallelChart final : public QWidget
{
    Q_OBJECT

public:
    explicit ParallelChart(QWidget* parent = nullptr);

    //   selected  points by their numbers in the study; none: all are drawn alike
    void show(SharedColumns columns, const std::vector<std::size_t>& selected);
    using QWidget::show;
    void mark(const std::vector<std::size_t>& selected);

    QCustomPlot& plot() { return *m_plot; }
    // Where a value stands on an axis, px of the plot.
    QPointF placeOf(std::size_t column, double value) const;
    std::size_t strokeCount() const { return m_strokes.size(); }

signals:
    void picked(const std::vector<std::size_t>& points, ripstop::Picking how);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void restyle();
    void drawAxes();
    void drawLines();
    void press(const QMouseEvent& event);
    void pull(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void drawStrokes();
    double shareOf(std::size_t column, double value) const;
    double valueAt(std::size_t column, double share) const;

    SharedColumns m_columns;
    std::vector<ValueSpan> m_spans; // [columns] of the axes
    std::vector<char> m_isSelected; // [points] empty: none is
    std::vector<ColumnSpan> m_strokes;
    int m_pressed = -1; // column of the stroke under way
    double m_from = 0.0;
    QCustomPlot* m_plot;
    QCPCurve* m_others;
    QCPCurve* m_selected;
    std::vector<QCPItemRect*> m_marks; // of strokes
};

} // namespace ripstop
