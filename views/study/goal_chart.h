// What a study looks for, as a picture: how the best grew from flight to flight, the front between
// two objectives, or which variable matters.
//
// Points are flights and can be clicked; bars are indices of Sobol' with their bands. Only the
// window's thread uses it.
#pragma once

#include "study/study_run.h"

#include <QWidget>

class QCPBars;
class QCPErrorBars;
class QCPGraph;
class QCustomPlot;

namespace ripstop {

class SpokenAxis;

class GoalChart final : public QWidget
{
    Q_OBJECT

public:
    enum class Picture { Convergence, Front, Sensitivity };

    explicit GoalChart(QWidget* parent = nullptr);

    // Which of them this study has.
    static std::vector<Picture> picturesOf(const OpenedStudy& study);

    //   reading  of readingsOf(), of bars
    void show(const OpenedStudy& study, const StudyFlights& flights, Picture picture,
              std::size_t reading);
    using QWidget::show;

    QCustomPlot& plot() { return *m_plot; }
    int pointCount() const { return int(m_points.size()); } // that can be clicked
    int barCount() const;

signals:
    void chosen(std::size_t point); // of the study

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Point
    {
        std::size_t number;
        double x;
        double y;
        bool isBest;
    };

    void showConvergence(const OpenedStudy& study, const StudyFlights& flights);
    void showFront(const OpenedStudy& study, const StudyFlights& flights);
    void showSensitivity(const OpenedStudy& study, const StudyFlights& flights,
                         std::size_t reading);
    void drawPoints();
    void restyle();
    void nameBars();
    void clear();

    std::vector<Point> m_points;
    bool m_hasBars = false;
    QCustomPlot* m_plot;
    SpokenAxis* m_x; // what stands beside the axes
    SpokenAxis* m_y;
    QCPGraph* m_flights; // all that fulfil the constraints
    QCPGraph* m_best;    // steps of the best so far, or the front
    QCPBars* m_first;
    QCPBars* m_total;
    QCPErrorBars* m_firstBand;
    QCPErrorBars* m_totalBand;
};

} // namespace ripstop
