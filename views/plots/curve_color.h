#pragma once

#include <QColor>
#include <QPalette>

namespace ripstop {

// The colour of the n-th curve: neighbours differ for everybody, also for the colour-blind, and
// each stands out from the background of the palette, light or dark. Colours repeat after eight.
QColor curveColor(int n, const QPalette& palette);

bool isDark(const QPalette& palette);

} // namespace ripstop
