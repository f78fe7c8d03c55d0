// Values of properties as JSON, as commands print them with --json.
#pragma once

#include "scene/property.h"
#include "terminal/terminal.h"

namespace ripstop {

Json jsonOf(const Value& value); // null where there is none; of lists of ids, the ids

} // namespace ripstop
