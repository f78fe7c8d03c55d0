// The colour in which a thin line is drawn before the sky.
//
// Authors choose colours of materials for fabric; a thin line in the same colour may vanish before
// a light or dark background. The contrast is that of WCAG 2.1, and only as much white or black is
// mixed in as it takes.
#pragma once

#include "look/look.h"
#include "look/theme.h"

namespace ripstop {

// An author's colour of a thin line, made lighter (dark theme) or darker (light theme) until it can
// be seen before the sky: a black spar is grey at night.
Color lineColor(const Color& authored, const Theme& theme);

} // namespace ripstop
