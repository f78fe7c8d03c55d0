// The amplitude spectrum of a curve: how strongly it swings at each frequency.
//
// The samples are put on an even grid, their mean is taken away, a window of Hann is laid over
// them, and a discrete Fourier transform gives the lines. An amplitude is that of a lasting sine:
// the window weakens a sine by its own mean of 1/2, which is divided out again. Pure functions; any
// thread may call them.
#pragma once

#include <span>
#include <vector>

namespace ripstop {

struct Spectrum
{
    std::vector<double> frequency; // [lines] Hz, ascending, without 0
    std::vector<double> amplitude; // [lines] in the unit of the curve: half of peak to peak
};

// The spectrum of `values` [samples] at the times `time` [samples], s, ascending. The steps need
// not be equal: the grid is as fine as the mean step or a little coarser, so that the transform is
// quick, from the first to the last sample that is a number. It is empty for fewer than 16 samples
// that are numbers.
Spectrum spectrumOf(std::span<const double> time, std::span<const double> values);

} // namespace ripstop
