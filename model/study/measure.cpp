// MeasureReader keeps what every reduction needs as the values come, and all of them for a
// percentile only.
#include "study/measure.h"

#include "io/json_text.h"
#include "simulation/reached.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
double percentileOf(std::vector<double> values, double percent)
{
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(values);
    const double place = percent / 100.0 * double(values.size() - 1);
    const auto below = std::size_t(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - double(below)) * (values[above] - values[below]);
}

std::string headingOf(const Measure& measure, const std::string& unit)
{
    std::string text = measure.probe + ' ';
    std::string of = unit;
    switch (measure.reduction) {
    case Reduction::Percentile:
        text += "p" + numberText(measure.percent);
        break;
    case Reduction::Slope:
        of = unit.empty() ? "1/s" : unit + "/s";
        text += "slope";
        break;
    case Reduction::LeastTime:
    case Reduction::LargestTime:
        of = "s";
        text += measure.reduction == Reduction::LeastTime ? "time of min" : "time of max";
        break;
    default:
        text += choiceNames<Reduction>[std::size_t(measure.reduction)];
    }
    if (measure.from > 0.0)
        text += " from " + numberText(measure.from) + " s";
    if (std::isfinite(measure.to))
        text += " to " + numberText(measure.to) + " s";
    return of.empty() ? text : text + " (" + of + ")";
}

std::vector<Measure> usualMeasures(const std::vector<Layout::Probe>& probes, double from)
{
    std::vector<Measure> all;
    for (const Layout::Probe& probe : probes)
        for (const Reduction reduction :
             {Reduction::Last, Reduction::Mean, Reduction::Least, Reduction::Largest}) {
            Measure& one = all.emplace_back();
            one.probe = probe.name;
            one.reduction = reduction;
            one.from = reduction == Reduction::Last ? 0.0 : from;
        }
    return all;
}

// Means of times and values are followed as they come (Welford 1962), so that a slope late in a
// long flight loses no digits.
void MeasureReader::take(double time, double value, double most, double timeStep)
{
    const bool isIn =
        hasReached(time, m_measure.from, timeStep)
        && (!std::isfinite(m_measure.to) || !hasReached(time, m_measure.to + timeStep, timeStep));
    if (!isIn)
        return;
    m_last = value;
    if (std::isfinite(most) && most > m_largest) {
        m_largest = most;
        m_largestTime = time;
    }
    if (!std::isfinite(value))
        return;
    if (value < m_least) {
        m_least = value;
        m_leastTime = time;
    }
    m_count += 1.0;
    m_sum += value;
    m_squares += value * value;
    const double off = time - m_meanTime;
    m_meanTime += off / m_count;
    m_spread += off * (time - m_meanTime);
    m_common += off * (value - m_sum / m_count);
    if (m_measure.reduction == Reduction::Percentile)
        m_all.push_back(value);
}

double MeasureReader::result() const
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (m_measure.reduction == Reduction::Last)
        return m_last;
    if (m_count == 0.0)
        return none;
    switch (m_measure.reduction) {
    case Reduction::Mean:
        return m_sum / m_count;
    case Reduction::Least:
        return m_least;
    case Reduction::Largest:
        return m_largest;
    case Reduction::Rms:
        return std::sqrt(m_squares / m_count);
    case Reduction::Percentile:
        return percentileOf(m_all, m_measure.percent);
    case Reduction::Slope:
        return m_spread > 0.0 ? m_common / m_spread : none;
    case Reduction::LeastTime:
        return m_leastTime;
    case Reduction::LargestTime:
        return m_largestTime;
    case Reduction::Last:
        break;
    }
    return m_last;
}

} // namespace ripstop
