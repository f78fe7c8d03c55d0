// The second column of the outline: what a person wants to know of a thing at a glance.
#pragma once

#include "scene/property.h"

#include <QString>

namespace ripstop {

std::vector<Id> rowIds(const Part& part, Kind table); // of its particles, links or panels

// "152", or "3 of 152" while some of them are selected. `selected` in ascending order.
QString tableDetail(const Part& part, Kind table, const std::vector<Id>& selected);

// "6 m/s", "Left / Right", "1,245 members".
QString itemDetail(const Scene& scene, const Item& item);

} // namespace ripstop
