// Items of types that this version does not know: they are named where problems are, and kept.
#pragma once

#include "check/finding.h"
#include "check/tear_check.h"

namespace ripstop {

const UnknownItem* findUnknownItem(const Scene& scene, Id id); // null when there is none

// "Item 17 is of the type sail, which this version does not know; ..."
Message unknownText(const UnknownItem& item);

void checkUnknownItems(const Scene& scene, const AddFinding& add); // a warning for each

} // namespace ripstop
