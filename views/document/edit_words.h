// What a step of the history is called: "Set mass of 3 particles of kite to 2 g".
#pragma once

#include "scene/property.h"

#include <QString>

#include <span>
#include <vector>

namespace ripstop {

// For setting this property of these things, which exist, in ascending order, to these values: one
// for all of them or one for each. A value stands in it where there is one alone and a line has
// room for it, which notes and lists have not.
Message settingLabel(const Scene& scene, const Property& property, const std::vector<Id>& ids,
                     std::span<const Value> values);

} // namespace ripstop
