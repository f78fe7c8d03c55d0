#pragma once

#include "document/census.h"

#include <QString>

namespace ripstop {

// What the things amount to, in a line or two: mass of particles, length of links, area of panels,
// what a part or a group holds, what a material is used for. Empty when there is nothing to add up.
QString totals(const Scene& scene, Kind kind, const std::vector<Id>& ids);

// The same of whatever is selected, an item standing for its elements: "1.2 kg · 34 m long · 5 m²".
QString totals(const Scene& scene, const std::vector<Id>& selected);

} // namespace ripstop
