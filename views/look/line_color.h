#pragma once

#include "look/look.h"
#include "look/theme.h"

namespace ripstop {

// An author's colour of a thin line, as light or dark as it must be to be seen before the sky: a
// black spar is grey at night.
Color lineColor(const Color& authored, const Theme& theme);

} // namespace ripstop
