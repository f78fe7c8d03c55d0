// The words for the figures of a design and for what is lost when a part is built again, in the
// language of the window and with SI units. BuilderDialog shows them under its form.
#pragma once

#include "author/design_figures.h"
#include "author/rebuild.h"

#include <QString>

namespace ripstop {

// "152 particles, 458 links, 221 panels" and what else there is to say, in a few lines.
QString textOf(const DesignFigures& figures);

// What a part is of though its form does not offer it: "Cord: Liros LTC65 by now, which stays ...".
QString textOf(const std::vector<OtherMaterial>& staying);

// What is lost when a part is built again, and how to keep it; empty when nothing is.
QString textOf(const HandmadeParts& lost, std::size_t letGo);

} // namespace ripstop
