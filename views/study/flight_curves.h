// What a probe read in several flights of a study, over each other: a curve for each flight in a
// colour of its own. A click on a curve chooses its flight. Above them stand which probe it is and
// how their ghosts are shown in the view. Only the window's thread uses it.
#pragma once

#include "study/study_run.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QCustomPlot;

namespace ripstop {

class XyChart;

struct FlightCurve
{
    std::size_t point; // of the study
    QString name;
    std::shared_ptr<const RecordedFlight> flight;
};

class FlightCurves final : public QWidget
{
    Q_OBJECT

public:
    enum class Ghosts { Over, Beside, None };

    explicit FlightCurves(QWidget* parent = nullptr);

    void show(std::vector<FlightCurve> curves);
    using QWidget::show;
    void mark(std::optional<std::size_t> point); // the chosen one, which is drawn bold

    QColor colorOf(std::size_t place) const; // of a curve, which its ghost shares
    Ghosts ghosts() const;
    const std::vector<FlightCurve>& curves() const { return m_curves; }
    QCustomPlot& plot();
    std::string table() const; // CSV: a row for each moment of each flight

signals:
    void chosen(std::size_t point); // of the study
    void ghostsWanted();            // in another way than before
    void closed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void draw();
    std::optional<std::size_t> nearestTo(const QPointF& place); // px of the plot
    int probe() const { return m_shownProbe; }                  // number among the probes

    std::vector<FlightCurve> m_curves;
    std::optional<std::size_t> m_marked;
    int m_shownProbe = 0;
    QComboBox* m_probe;
    QComboBox* m_ghosts;
    XyChart* m_chart;
};

} // namespace ripstop
