// A reading over one variable: its median with the bands of 5 to 95 and 25 to 75 % where points
// repeat a value or lie close, and a plain curve where each value was flown once. Crosses at the
// bottom are where flights ended early. A click picks the points of a value, with Ctrl or Shift
// more of them. Only the window's thread uses it.
#pragma once

#include "study/picking.h"
#include "study/study_columns.h"

#include <QWidget>

class QCPGraph;
class QCustomPlot;

namespace ripstop {

class SpokenAxis;

class PercentileChart final : public QWidget
{
    Q_OBJECT

public:
    explicit PercentileChart(QWidget* parent = nullptr);

    void show(const StudyColumn& variable, const StudyColumn& reading, const StudyFlights& flights);
    using QWidget::show;

    QCustomPlot& plot() { return *m_plot; }
    const std::vector<StudyBand>& bands() const { return m_bands; }
    bool hasBands() const { return m_hasBands; }

signals:
    void picked(const std::vector<std::size_t>& points, ripstop::Picking how); // of the study

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void restyle();
    void draw();
    void nameBands();
    void fitAxes(const StudyColumn& variable, const StudyColumn& reading);

    std::vector<StudyBand> m_bands;
    bool m_hasBands = false;
    QCustomPlot* m_plot;
    SpokenAxis* m_x;
    SpokenAxis* m_y;
    std::array<QCPGraph*, bandPercents.size()> m_lines{}; // [percentiles]
    QCPGraph* m_failed;
};

} // namespace ripstop
