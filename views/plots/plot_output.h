// Curves as text, for files and spreadsheets: one column of times, s, and one for each curve,
// without any reduction of the samples that the history holds.
#pragma once

#include "plots/chart.h"

class QIODevice;

namespace ripstop {

// Writes a header with units and a row for each sample, with an empty cell where a curve has no
// value. With bands (plots/error_bands.h) each curve that has one is followed by the error of its
// values, "height error (m)", as tables of the command line have it. Numbers have as many digits as
// are needed to read the same bits back, and a point whatever the language. Errors stay with the
// device, which the caller has opened.
void writeCurves(QIODevice& device, const History& history, const std::vector<Curve>& curves,
                 const ErrorBands* bands = nullptr, char separator = ',');

} // namespace ripstop
