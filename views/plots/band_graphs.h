// A band around a curve, of what its values may be off by: two graphs without lines and what is
// filled between them, in the colour of the curve. Chart and BandChart draw with it. Only the
// window's thread uses it.
#pragma once

#include "plots/drawn_curve.h"

#include <span>

class QCPAxis;
class QCPGraph;
class QColor;
class QCustomPlot;

namespace ripstop {

struct BandGraphs
{
    QCPGraph* low = nullptr;
    QCPGraph* high = nullptr; // filled down to `low`
};

// Behind the curves that are there and those that come; the plot owns the graphs.
BandGraphs addBand(QCustomPlot& plot, QCPAxis& time, QCPAxis& values);

// Shows what of the band between `low` and `high` [samples] the window shows, and returns what it
// spans, without points. A logarithmic axis, which has no place for 0, shows it from far below.
DrawnCurve fillBand(const BandGraphs& band, std::span<const double> time,
                    std::span<const double> low, std::span<const double> high,
                    const TimeWindow& window);

void styleBand(const BandGraphs& band, const QColor& curve, const QColor& legend);

} // namespace ripstop
