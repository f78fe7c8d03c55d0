// Curves over time, looked at in other ways.
#pragma once

#include "plots/chart.h"
#include "plots/history.h"
#include "plots/xy_chart.h"

#include <optional>
#include <vector>

namespace ripstop {

// Each curve against what another probe reads at the same times. At most some thousand points of
// each: the eye sees no more.
std::vector<XyCurve> phaseCurves(const History& history, const std::vector<EarlierRun>& earlier,
                                 const std::vector<Curve>& curves, std::uint32_t across);

// How strongly each curve swings at each frequency, Hz.
std::vector<XyCurve> spectra(const History& history, const std::vector<EarlierRun>& earlier,
                             const std::vector<Curve>& curves);

} // namespace ripstop
