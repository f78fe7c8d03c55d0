// Looks for links that join two particles that are joined already, and for particles that nothing
// holds. Both are found in a time that grows like the number of links.
#pragma once

#include "check/elastic_check.h"

namespace ripstop {

void checkNetwork(const Scene& scene, const ElementIndex& index, const AddFinding& add);

// Links that begin far from their rest lengths: one that a file gives none has the usual metre,
// whatever its ends are apart. Of a scene without errors.
void checkRestLengths(const Scene& scene, const ElementIndex& index, const AddFinding& add);

} // namespace ripstop
