#include "look/steady_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace ripstop {
namespace {

constexpr double far = 0.6;         // values below this share of the range ask for a smaller one
constexpr double patience = 120.0;  // frames
constexpr double frameRate = 60.0;  // 1/s, of a quick machine
constexpr double negligible = 1e-9; // rounding noise of a network at rest, in any unit
constexpr double pressed = 0.1;     // share of the bound below zero that counts as compression

// The value that all but `few` values do not go beyond: the upper end, or the lower end when
// `before` is std::less.
template <typename Before>
double allBut(std::size_t few, std::vector<double>& values, Before before)
{
    const auto place = values.begin() + std::ptrdiff_t(few);
    std::nth_element(values.begin(), place, values.end(), before);
    return *place;
}

template <std::size_t n>
double roundedUp(double value, const std::array<double, n>& steps)
{
    if (!(value > 0.0) || !std::isfinite(value))
        return 0.0;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : steps)
        if (value <= step * power * (1.0 + 1e-12))
            return step * power;
    return 10.0 * power;
}

double boundOf(double value)
{
    return roundedUp(value, std::array{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0});
}

} // namespace

double roundedUp(double value) { return roundedUp(value, std::array{1.0, 2.0, 5.0}); }

void SteadyRange::take(std::span<const double> values, bool mayBeNegative, double beyond,
                       double elapsed)
{
    m_scratch.clear();
    for (const double value : values)
        if (std::isfinite(value) && value != 0.0)
            m_scratch.push_back(value);
    if (m_scratch.empty())
        return;

    const auto few = std::size_t(beyond * double(m_scratch.size()));
    const double top = std::max(0.0, allBut(few, m_scratch, std::greater()));
    const double bottom = mayBeNegative ? std::min(0.0, allBut(few, m_scratch, std::less())) : 0.0;
    const double needed = std::max(top, -bottom);
    if (needed < negligible)
        return;

    if (-bottom > pressed * needed)
        m_symmetric = true;
    const double reach = m_symmetric ? needed : top;
    if (reach > m_bound) {
        m_bound = boundOf(reach);
        m_calm = 0.0;
    } else if (reach > far * m_bound) {
        m_calm = 0.0;
    } else if (m_calm += std::max(1.0, frameRate * elapsed); m_calm > patience) {
        m_bound = boundOf(reach);
        m_calm = 0.0;
    }
}

ValueRange SteadyRange::range() const
{
    const double bound = m_bound > 0.0 ? m_bound : 1.0;
    return {m_symmetric ? -bound : 0.0, bound};
}

} // namespace ripstop
