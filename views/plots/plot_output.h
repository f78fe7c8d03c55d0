// Curves as text, for files and spreadsheets.
#pragma once

#include "plots/chart.h"

class QIODevice;

namespace ripstop {

// A header with units, a row for each sample; an empty cell where a curve has no value.
void writeCurves(QIODevice& device, const History& history, const std::vector<Curve>& curves,
                 char separator = ',');

} // namespace ripstop
