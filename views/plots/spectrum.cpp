#include "plots/spectrum.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace ripstop {
namespace {

constexpr std::size_t fewest = 16; // samples
constexpr double hannMean = 0.5;   // of the window, by which it weakens a sine

struct Samples
{
    std::vector<double> time;
    std::vector<double> value;
};

Samples numbersOf(std::span<const double> time, std::span<const double> values)
{
    Samples samples;
    for (std::size_t i = 0; i < std::min(time.size(), values.size()); ++i)
        if (std::isfinite(values[i])) {
            samples.time.push_back(time[i]);
            samples.value.push_back(values[i]);
        }
    return samples;
}

// The most samples, but not more than `most`, whose transform is quick: a number without prime
// factors above 5. A transform of a prime number of samples takes its square of steps, seconds for
// the samples of a minute.
std::size_t quickCount(std::size_t most)
{
    for (std::size_t count = most;; --count) {
        std::size_t rest = count;
        for (const std::size_t factor : {2, 3, 5})
            while (rest % factor == 0)
                rest /= factor;
        if (rest == 1)
            return count;
    }
}

// The samples at `count` equal steps, interpolated in straight lines.
std::vector<double> evened(const Samples& samples, std::size_t count)
{
    const std::size_t all = samples.time.size();
    const double first = samples.time.front();
    const double step = (samples.time.back() - first) / double(count - 1);
    std::vector<double> even;
    std::size_t next = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double time = first + double(i) * step;
        while (next + 1 < all && samples.time[next] < time)
            ++next;
        const double width = samples.time[next] - samples.time[next - 1];
        const double share = width > 0.0 ? (time - samples.time[next - 1]) / width : 1.0;
        even.push_back(
            std::lerp(samples.value[next - 1], samples.value[next], std::clamp(share, 0.0, 1.0)));
    }
    return even;
}

} // namespace

Spectrum spectrumOf(std::span<const double> time, std::span<const double> values)
{
    const Samples samples = numbersOf(time, values);
    if (samples.time.size() < fewest || !(samples.time.back() > samples.time.front()))
        return {};
    const std::size_t count = quickCount(samples.time.size());
    std::vector<double> even = evened(samples, count);
    double mean = 0.0;
    for (const double value : even)
        mean += value / double(count);
    for (std::size_t i = 0; i < count; ++i)
        even[i] = (even[i] - mean)
                  * (0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * double(i) / double(count)));

    std::vector<std::complex<double>> lines;
    Eigen::FFT<double> transform;
    transform.fwd(lines, even);
    const double length =
        (samples.time.back() - samples.time.front()) * double(count) / double(count - 1);
    Spectrum spectrum;
    for (std::size_t k = 1; k <= count / 2; ++k) {
        spectrum.frequency.push_back(double(k) / length);
        spectrum.amplitude.push_back(2.0 * std::abs(lines[k]) / (double(count) * hannMean));
    }
    return spectrum;
}

} // namespace ripstop
