// The second column of the outline: what a person wants to know of a thing at a glance.
//
// Texts are made when a row is painted, so they are short and cost little: the size of a table, the
// speed of a wind, the turbulence of gusts, the keys of a control.
#pragma once

#include "scene/property.h"

#include <QString>

namespace ripstop {

std::vector<Id> rowIds(const Part& part, Kind table); // of its particles, links or panels

// The size of a table, "152", or "3 of 152" while some of its rows are selected. `selected` is in
// ascending order.
QString tableDetail(const Part& part, Kind table, const std::vector<Id>& selected);

// What is said of an item: "6 m/s" of a wind, "Left / Right" of a control, a number of members;
// empty where there is nothing to say.
QString itemDetail(const Scene& scene, const Item& item);

} // namespace ripstop
