#include "viewport/steady_range.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double kept = 0.995;      // share of the values that the range holds
constexpr double far = 0.35;        // values below this share of the range ask for a smaller one
constexpr int patience = 120;       // frames, about 2 s
constexpr double negligible = 1e-9; // rounding noise of a network at rest, in any unit
constexpr double pressed = 0.1;     // share of the bound below zero that counts as compression

double quantile(std::vector<double>& values, double share)
{
    const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

} // namespace

double roundedUp(double value)
{
    if (!(value > 0.0) || !std::isfinite(value))
        return 0.0;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * power * (1.0 + 1e-12))
            return step * power;
    return 10.0 * power;
}

void SteadyRange::take(std::span<const double> values, bool mayBeNegative)
{
    m_scratch.clear();
    for (const double value : values)
        if (std::isfinite(value))
            m_scratch.push_back(value);
    if (m_scratch.empty())
        return;

    const double top = std::max(0.0, quantile(m_scratch, kept));
    const double bottom = mayBeNegative ? std::min(0.0, quantile(m_scratch, 1.0 - kept)) : 0.0;
    const double needed = std::max(top, -bottom);
    if (needed < negligible)
        return;

    if (-bottom > pressed * needed)
        m_symmetric = true;
    const double reach = m_symmetric ? needed : top;
    if (reach > m_bound) {
        m_bound = roundedUp(reach);
        m_calm = 0;
    } else if (reach > far * m_bound) {
        m_calm = 0;
    } else if (++m_calm > patience) {
        m_bound = roundedUp(reach);
        m_calm = 0;
    }
}

ValueRange SteadyRange::range() const
{
    const double bound = m_bound > 0.0 ? m_bound : 1.0;
    return {m_symmetric ? -bound : 0.0, bound};
}

} // namespace ripstop
