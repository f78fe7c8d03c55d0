#pragma once

#include "author/figures.h"

#include <QString>

namespace ripstop {

// "152 particles, 458 links, 221 panels" and what else there is to say, in a few lines.
QString textOf(const Figures& figures);

} // namespace ripstop
