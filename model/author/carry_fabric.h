// Has the panels of a material carry its pull, in whatever way their part is made.
//
// A part of threads is converted as panel_fabric.h says. In a part of bare links, as the papers'
// designs are, the seams go: links between panels that all carry now, of a material that is no line
// or spar (it has neither EA nor EI) and most of whose links lie between panels. What holds the
// edges stays.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

#include <vector>

namespace ripstop {

// Fails, with a sentence that names the material and the remedy, where the panels would carry
// nothing, and where there are none.
Result<Edit> panelsCarry(const Scene& scene, const std::vector<Id>& materials);

} // namespace ripstop
