// What things amount to, in words for the head of the inspector and the status line.
//
// The sums are those of the scene as it is authored, not of a run: masses kg, rest lengths m, areas
// m^2 of panels as drawn. They are found anew for each call.
#pragma once

#include "document/census.h"

#include <QString>

namespace ripstop {

// What things of one kind amount to, in a line or two: mass of particles, length of links, area of
// panels, what a part or a group holds, what a material is used for. Empty when there is nothing to
// add up.
QString totals(const Scene& scene, Kind kind, const std::vector<Id>& ids);

// What all that is selected amounts to, an item standing for its elements, such as
// "1.2 kg · 34 m long · 5 m²".
QString totals(const Scene& scene, const std::vector<Id>& selected);

} // namespace ripstop
