// The colours of curves, shared by all charts and by the list of probes, so that a probe has the
// same colour wherever it is shown. They are those of Okabe and Ito (2008), adapted to light and
// dark backgrounds. Pure functions; any thread may call them.
#pragma once

#include <QColor>
#include <QPalette>

namespace ripstop {

// The colour of the n-th curve: neighbours differ for everybody, also for the colour-blind, and
// each stands out from the background of the palette, light or dark. After eight come darker shades
// of them, and after sixteen they repeat.
QColor curveColor(int n, const QPalette& palette);

// Whether the palette has a dark background for text and curves.
bool isDark(const QPalette& palette);

} // namespace ripstop
