// Items of types and keys that this version does not know: they are named where problems are, and
// kept. A key may be one of a later version, or a slip of the hand that leaves a number at its
// default without a word.
#pragma once

#include "check/finding.h"
#include "check/tear_check.h"
#include "scene/element_index.h"

namespace ripstop {

const UnknownItem* findUnknownItem(const Scene& scene, Id id); // null when there is none

// "Item 17 is of the type sail, which this version does not know; ..."
Message unknownText(const UnknownItem& item);

// A warning for each such item, and for each such key of one kind of things.
void checkUnknown(const Scene& scene, const ElementIndex& index, const AddFinding& add);

} // namespace ripstop
