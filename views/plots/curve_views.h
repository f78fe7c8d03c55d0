// The curves of the plots dock looked at in other ways than over time: against another probe, and
// as spectra. Earlier runs come first in the result, marked as past and named after their run, so
// that the present run is drawn above them. Pure functions of the histories; PlotView calls them.
#pragma once

#include "plots/chart.h"
#include "plots/history.h"
#include "plots/xy_chart.h"

#include <optional>
#include <vector>

namespace ripstop {

// Each curve against what the probe `across` reads at the same times, in the units of both. Of long
// runs every n-th sample is taken, so that a curve has at most about 4000 points: the eye sees no
// more.
std::vector<XyCurve> phaseCurves(const History& history, const std::vector<EarlierRun>& earlier,
                                 const std::vector<Curve>& curves, std::uint32_t across);

// How strongly each curve swings at each frequency, Hz, in the unit of the curve
// (plots/spectrum.h).
std::vector<XyCurve> spectra(const History& history, const std::vector<EarlierRun>& earlier,
                             const std::vector<Curve>& curves);

} // namespace ripstop
