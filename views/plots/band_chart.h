// A curve over time in a band of what it may be off by. The dialog that certifies runs shows it. It
// is a widget: only the window's thread uses it.
#pragma once

#include "plots/band_graphs.h"
#include "plots/spoken_axis.h"

#include <QString>
#include <QWidget>

#include <vector>

class QCustomPlot;

namespace ripstop {

class BandChart final : public QWidget
{
    Q_OBJECT

public:
    explicit BandChart(QWidget* parent = nullptr);

    // Replaces what was shown.
    //   time   [times]  s
    //   value  [times]  in the unit of `words`, and so is its error, half of the width of the band
    void show(const AxisWords& words, const std::vector<double>& time,
              const std::vector<double>& value, const std::vector<double>& error);
    void clear();
    using QWidget::show;

    QSize sizeHint() const override { return {560, 260}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void style();

    QCustomPlot* m_plot;
    SpokenAxis* m_values;
    BandGraphs m_band;
    QCPGraph* m_curve;
};

} // namespace ripstop
