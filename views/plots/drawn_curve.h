// A curve reduced to what a screen can show: no more points than can be told apart, whatever the
// number of samples.
//
// Where more than two samples fall on a pixel column, the lowest and the highest of them stand for
// all, in the order in which they come, so that no peak is lost. Columns are blocks of samples
// counted from the start of the run, so that nothing flickers while the axis moves. Pure function;
// any thread may call it.
#pragma once

#include <QVector>

#include <span>

namespace ripstop {

struct DrawnCurve
{
    QVector<double> time;  // [points] s
    QVector<double> value; // [points]; not a number where the curve has a gap
    bool any = false;      // whether there is a value in sight
    double low = 0.0;      // lowest of all samples in sight, drawn or not
    double high = 0.0;     // highest of all samples in sight

    void span(const DrawnCurve& other); // takes in the lowest and the highest of another one
};

struct TimeWindow
{
    double from;       // s
    double to;         // s
    int columns;       // px
    bool positiveOnly; // for a logarithmic axis
};

// The part of the curve `values` [samples] over `time` [samples], s, ascending, that the window
// shows. One sample beyond either end is kept, so that the curve goes on to the edge. It is empty
// when the two lists have not the same length.
DrawnCurve drawnCurve(std::span<const double> time, std::span<const double> values,
                      const TimeWindow& window);

} // namespace ripstop
