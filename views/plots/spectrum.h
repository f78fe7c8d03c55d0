#pragma once

#include <span>
#include <vector>

namespace ripstop {

// How strongly a curve swings at each frequency.
struct Spectrum
{
    std::vector<double> frequency; // [lines] Hz, ascending, without 0
    std::vector<double> amplitude; // [lines] in the unit of the curve: half of peak to peak
};

// Of samples at these times, s, which need not lie at equal steps: they are put on a grid as fine
// as the mean step, from the first to the last that is a number. The mean is taken away, and a
// window (Hann) keeps the ends from showing; amplitudes are those of a lasting sine. Empty for
// fewer than 16 samples.
Spectrum spectrumOf(std::span<const double> time, std::span<const double> values);

} // namespace ripstop
