// What is read of a flight: a probe of the scene, and what becomes of its values.
#pragma once

#include "base/choice_names.h"
#include "simulation/frame.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace ripstop {

enum class Reduction {
    Last,
    Mean, // of the steps, which are alike
    Least,
    Largest,
    Rms,        // root of the mean square
    Percentile, // the value that `percent` of all lie below, between two of them on a line
    Slope,      // of the line through the values with the least squares, per second
    LeastTime,  // s, when it was least for the first time
    LargestTime // s
};

template <>
inline constexpr std::array choiceNames<Reduction>{
    "final", "mean", "min", "max", "rms", "percentile", "slope", "time_of_min", "time_of_max"};

struct Measure
{
    std::string probe; // its name
    Reduction reduction = Reduction::Last;
    double percent = 95.0;                               // of Percentile
    double from = 0.0;                                   // s, values from here
    double to = std::numeric_limits<double>::infinity(); // s, to here count

    bool operator==(const Measure&) const = default;
};

// The value that `percent` of all lie below, between two of them on a line; not a number of none.
double percentileOf(std::vector<double> values, double percent);

std::string headingOf(const Measure& measure, const std::string& unit); // "height max (m)"

// Final, mean, least and largest value of each, from `from` on.
std::vector<Measure> usualMeasures(const std::vector<Layout::Probe>& probes, double from = 0.0);

// The values of one measure during a flight. Moments without a reading do not count.
class MeasureReader
{
public:
    explicit MeasureReader(const Measure& measure)
        : m_measure(measure)
    {}

    // Times rise. `timeStep`, s, decides whether a moment is in the window (reached.h).
    //   most  ProbeSample::most() of the same instant, which the largest are of
    void take(double time, double value, double most, double timeStep);

    double result() const; // not a number when no value counted

private:
    Measure m_measure;
    double m_last = std::numeric_limits<double>::quiet_NaN();
    double m_least = std::numeric_limits<double>::infinity();
    double m_largest = -std::numeric_limits<double>::infinity();
    double m_leastTime = 0.0;
    double m_largestTime = 0.0;
    double m_sum = 0.0;
    double m_squares = 0.0;
    double m_count = 0.0;
    double m_meanTime = 0.0;   // s
    double m_spread = 0.0;     // s^2, sum of the squares of times about their mean
    double m_common = 0.0;     // s, sum of times about their mean with values
    std::vector<double> m_all; // of a percentile
};

} // namespace ripstop
