#pragma once

#include "author/design_figures.h"
#include "author/rebuild.h"

#include <QString>

namespace ripstop {

// "152 particles, 458 links, 221 panels" and what else there is to say, in a few lines.
QString textOf(const DesignFigures& figures);

// What goes when a part is built again, and how to keep it; empty when nothing does.
QString textOf(const HandWork& lost, std::size_t letGo);

} // namespace ripstop
