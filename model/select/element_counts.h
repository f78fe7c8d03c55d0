// What an edit brings into a design and what it takes out of it, in numbers, for labels, for the
// question before a removal and for the preview of operations. It reads the edit alone, before or
// after it is applied.
#pragma once

#include "scene/edit.h"

namespace ripstop {

// Elements and items. Rows count, also those of parts that come.
struct ElementCounts
{
    std::size_t particles = 0;
    std::size_t links = 0;
    std::size_t panels = 0;
    std::size_t items = 0;
    bool isNothing() const { return particles + links + panels + items == 0; }
};
struct EditCounts
{
    ElementCounts added;
    ElementCounts removed;
};
EditCounts editCountsOf(const Edit& edit);

// What goes when `ids` are removed by `removal`, beyond what they name themselves: links and
// panels that lose an end or a corner. The elements of a named part are named with it.
ElementCounts alsoRemoved(const std::vector<Id>& ids, const Edit& removal);

} // namespace ripstop
