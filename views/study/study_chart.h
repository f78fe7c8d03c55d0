// A study as a picture: a map of cells over two variables, or its points over one or two.
//
// Colour is the value that is shown. Over a grid stand thin contours and, bold, the tear line
// between what held and what did not; a flight that ended early has a cross, one that missed the
// wanted accuracy a dot, and what is not flown is left empty. Columns and rows of a grid are
// equally wide whatever their values, which stand at the axes. In a study of one variable the value
// is the height. A click picks a flight, with Ctrl or Shift several, and a rubber band all that are
// in it; moving the pointer tells which one is below it. Only the window's thread uses it.
#pragma once

#include "study/picking.h"
#include "study/study_map.h"

#include <QWidget>

#include <optional>

class QCPColorMap;
class QCPColorScale;
class QCPCurve;
class QCPGraph;
class QCPItemRect;
class QCustomPlot;
class QMouseEvent;
class QRubberBand;

namespace ripstop {

class SpokenAxis;

class StudyChart final : public QWidget
{
    Q_OBJECT

public:
    explicit StudyChart(QWidget* parent = nullptr);

    //   reading  with its unit, beside the colours
    void show(const StudyMap& map, const QString& reading);
    using QWidget::show;
    // By their numbers in the study: those that are selected, and the chosen one of them.
    void mark(const std::vector<std::size_t>& selected, std::optional<std::size_t> chosen);

    QCustomPlot& plot() { return *m_plot; }
    // The place in the map of what stands here, in pixels of the plot.
    std::optional<std::size_t> at(const QPointF& place) const;
    QPointF placeOf(std::size_t point) const; // where a point of the study stands

signals:
    void picked(const std::vector<std::size_t>& points, ripstop::Picking how); // of the study
    void pointedAt(qlonglong point);                                           // -1: at none

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    bool hasHeights() const { return !m_map.y; } // the value is the height
    void pick(const QMouseEvent& event);
    void pull(const QMouseEvent& event);
    void pickBand(const QMouseEvent& event);
    std::vector<std::size_t> spanTo(std::size_t place) const;
    void restyle();
    void drawAxes();
    void drawCells();
    void drawPoints();
    void drawLines();
    void drawMarks();
    double heightOf(const StudyMap::Point& point) const;
    QPointF placeOf(const StudyMap::Point& point) const;

    StudyMap m_map;
    QString m_reading;
    std::vector<std::size_t> m_selected;
    std::optional<std::size_t> m_marked;
    QPoint m_pressed; // where a rubber band begins, px of the plot
    QRubberBand* m_band;
    QCustomPlot* m_plot;
    QCPColorMap* m_cells;
    QCPColorScale* m_scale;
    SpokenAxis* m_saidX; // what stands beside the axes
    SpokenAxis* m_saidY;
    SpokenAxis* m_saidScale;
    QCPCurve* m_contours;
    QCPCurve* m_frontier;
    QCPGraph* m_crosses;  // ended early
    QCPGraph* m_torn;     // rings, where no tear line is drawn
    QCPGraph* m_doubts;   // dots, where the accuracy was missed
    QCPCurve* m_outlines; // of cells that are selected
    QCPGraph* m_rings;    // of points that are
    QCPItemRect* m_mark;
    std::vector<QCPGraph*> m_shades; // of points that are no cells, one for each colour
};

} // namespace ripstop
