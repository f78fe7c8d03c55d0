// Has panels carry the pull of a fabric that threads have carried (laws/cloth_law.h).
//
// Threads are the links that stand for strips of a fabric: those with the role thread or bias and a
// width. They go, as they would carry the same pull beside the panels. Lines, spars, hems and all
// other links stay. Panels that have no rest lengths yet are laid flat (flat_panel.h), with the
// rest lengths of the threads along their sides, so that a design that is drawn or saved under load
// keeps its cut.
//
// A panel is as stiff and as strong of its material as the threads along its sides were on average.
//
// What named a thread names the panels beside it instead; a probe of a quantity that only links
// have goes to the part.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

#include <vector>

namespace ripstop {

// Whether the link is a thread as above.
bool isOfFabric(const Link& link);

struct PanelFabric
{
    Edit edit;
    std::vector<Id> parts;   // that it changes
    std::size_t threads = 0; // that go
    std::size_t panels = 0;  // that carry
};

// The edit, for those of the parts that have threads. Fails, with a sentence that names part and
// remedy, where none has any, and where panels are missing or would carry nothing.
Result<PanelFabric> carriedByPanels(const Scene& scene, const std::vector<Id>& parts);

} // namespace ripstop
