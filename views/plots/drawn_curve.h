// A curve for the screen: no more points than can be told apart, whatever the number of samples.
#pragma once

#include <QVector>

#include <span>

namespace ripstop {

struct DrawnCurve
{
    QVector<double> time;  // s
    QVector<double> value; // not a number where the curve has a gap
    bool any = false;      // whether there is a value in sight
    double low = 0.0;      // of all samples in sight
    double high = 0.0;
};

struct TimeWindow
{
    double from;       // s
    double to;         // s
    int columns;       // px
    bool positiveOnly; // for a logarithmic axis
};

// Where more than two samples fall on a pixel column, the lowest and the highest of them stand for
// all, in the order in which they come: no peak is lost. One sample beyond either end is kept, so
// that the curve goes on to the edge.
DrawnCurve drawnCurve(std::span<const double> time, std::span<const double> values,
                      const TimeWindow& window);

} // namespace ripstop
