// The sampler finds the samples inside the window by bisection, keeps one beyond either end, and
// then either puts each sample (each) or, where there are more than two for a column, the extremes
// of blocks (inBlocks). A block without any number becomes one point that is not a number, which
// the plot draws as a gap. The lowest and highest values are noted on the way, because the axis is
// fitted to all samples and not only to those drawn.
#include "plots/drawn_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

class Sampler
{
public:
    Sampler(std::span<const double> time, std::span<const double> values, const TimeWindow& window)
        : m_time(time)
        , m_values(values)
        , m_window(window)
    {}

    DrawnCurve draw()
    {
        const auto inside = [this](double limit) {
            return std::size_t(std::ranges::lower_bound(m_time, limit) - m_time.begin());
        };
        const std::size_t first = inside(m_window.from);
        const std::size_t end = inside(m_window.to);
        const std::size_t count = end - first;
        const auto columns = std::size_t(std::max(1, m_window.columns));
        m_drawn.time.reserve(qsizetype(std::min(count, 2 * columns) + 2));
        m_drawn.value.reserve(m_drawn.time.capacity());
        if (first > 0)
            put(first - 1);
        if (count <= 2 * columns)
            each(first, end);
        else // blocks do not depend on where the window begins: nothing flickers
            inBlocks(first, end, count / columns + 1);
        if (end < m_time.size())
            put(end);
        return std::move(m_drawn);
    }

private:
    double value(std::size_t i) const
    {
        const double v = m_values[i];
        return m_window.positiveOnly && !(v > 0.0) ? nothing : v;
    }

    void put(std::size_t i)
    {
        m_drawn.time.push_back(m_time[i]);
        m_drawn.value.push_back(value(i));
    }

    void note(double low, double high)
    {
        m_drawn.low = m_drawn.any ? std::min(m_drawn.low, low) : low;
        m_drawn.high = m_drawn.any ? std::max(m_drawn.high, high) : high;
        m_drawn.any = true;
    }

    void each(std::size_t first, std::size_t end)
    {
        for (std::size_t i = first; i < end; ++i) {
            put(i);
            if (const double v = value(i); !std::isnan(v))
                note(v, v);
        }
    }

    struct Extremes
    {
        std::size_t low; // samples; `last` when there is none
        std::size_t high;
    };

    // What is not a number is neither below nor above anything.
    Extremes extremes(std::size_t first, std::size_t last) const
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const double* const values = m_values.data();
        const double least = m_window.positiveOnly ? 0.0 : -infinity;
        Extremes found{last, last};
        double low = infinity;
        double high = least;
        for (std::size_t i = first; i < last; ++i) {
            const double v = values[i];
            if (v < low && v > least) {
                low = v;
                found.low = i;
            }
            if (v > high) {
                high = v;
                found.high = i;
            }
        }
        if (found.low == last || found.high == last)
            return {last, last};
        return found;
    }

    void inBlocks(std::size_t first, std::size_t end, std::size_t block)
    {
        for (std::size_t i = first; i < end;) {
            const std::size_t last = std::min(end, (i / block + 1) * block);
            const Extremes found = extremes(i, last);
            if (found.low == last) {
                put(i); // a gap
            } else {
                note(value(found.low), value(found.high));
                put(std::min(found.low, found.high));
                if (found.low != found.high)
                    put(std::max(found.low, found.high));
            }
            i = last;
        }
    }

    std::span<const double> m_time;
    std::span<const double> m_values;
    const TimeWindow& m_window;
    DrawnCurve m_drawn;
};

} // namespace

void DrawnCurve::span(const DrawnCurve& other)
{
    if (!other.any)
        return;
    low = any ? std::min(low, other.low) : other.low;
    high = any ? std::max(high, other.high) : other.high;
    any = true;
}

DrawnCurve drawnCurve(std::span<const double> time, std::span<const double> values,
                      const TimeWindow& window)
{
    return values.size() == time.size() ? Sampler(time, values, window).draw() : DrawnCurve();
}

} // namespace ripstop
