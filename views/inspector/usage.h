#pragma once

#include "scene/property.h"

namespace ripstop {

// False for what the thing ignores as it is, such as the radius of a plane: a row that does nothing
// says so.
bool isUsed(const Property& property, const ConstRef& ref);

} // namespace ripstop
