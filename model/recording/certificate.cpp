#include "recording/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double safety = 1.25;       // Roache 1994, for three grids
constexpr double safetyWithout = 3.0; // of an order
constexpr double leastOrder = 0.5;    // that the limit is told by
constexpr double roundOff = 1e-13;    // of a value
constexpr double nothing = 1e-12;     // m, N, ...: what rounding leaves of what is none
constexpr int mostDigits = 15;
constexpr double shareOfWay = 0.5;    // that an error may be of what a probe goes through
constexpr double littleOfSize = 1e-3; // of the largest value, that is no motion

int digitsOf(double value, double error)
{
    if (!std::isfinite(error) || !std::isfinite(value))
        return 0;
    if (error <= roundOff * std::abs(value))
        return mostDigits;
    if (value == 0.0)
        return 0;
    const double digits = std::floor(1.0 - std::log10(2.0 * error / std::abs(value)));
    return int(std::clamp(digits, 0.0, double(mostDigits)));
}

} // namespace

double roundingOf(double value) { return std::max(roundOff * std::abs(value), nothing); }

Convergence convergenceOf(const std::array<double, 3>& value)
{
    Convergence result{.value = value};
    const auto [coarse, half, fine] = value;
    const double least = roundingOf(fine);
    const double first = std::abs(coarse - half) > least ? coarse - half : 0.0;
    const double second = std::abs(half - fine) > least ? half - fine : 0.0;
    const double ratio = first / second;
    if (first == 0.0 && second == 0.0) {
        result.limit = fine;
        result.error = 0.0;
    } else if (ratio > 1.0) {
        result.order = std::log2(ratio);
        result.limit = fine - second / (std::exp2(std::max(result.order, leastOrder)) - 1.0);
        result.error = safety * std::abs(coarse - result.limit);
    } else {
        result.error = safetyWithout * std::max(std::abs(first), std::abs(second));
    }
    result.digits = digitsOf(coarse, result.error);
    return result;
}

std::size_t CertifiedProbe::worstMoment() const
{
    std::size_t worst = 0;
    for (std::size_t k = 0; k < error.size(); ++k)
        if (std::isfinite(error[k]) && !(error[k] <= error[worst]))
            worst = k;
    return worst;
}

bool CertifiedProbe::holdsItsCourse() const
{
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const double one : value)
        if (std::isfinite(one)) {
            least = std::min(least, one);
            most = std::max(most, one);
        }
    const double largest = error.empty() ? 0.0 : error[worstMoment()];
    const double size = std::max(std::abs(least), std::abs(most));
    return ofMean || !(largest > shareOfWay * (most - least) && largest > littleOfSize * size);
}

double Certificate::errorAt(const std::string& probe, double at) const
{
    const auto found = std::ranges::find(probes, probe, &CertifiedProbe::name);
    // times are sums of steps, and the same in each run
    const auto moment = std::ranges::lower_bound(time, at);
    if (found == probes.end() || moment == time.end() || *moment != at)
        return Convergence::none;
    return found->error[std::size_t(moment - time.begin())];
}

} // namespace ripstop
