// Walks a table of rows along a sorted list of ids. Selections, tables and the census of the
// editor ask for hundred thousands of ids at once, for which a search of each one would take too
// long.
#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <cstddef>

namespace ripstop {

// Calls visit(row, place) for each row of a table whose id is among `ids`, with its place there.
// Both are in ascending order of id. Where many ids lie in the table it is walked along with them;
// only the stretch of `ids` that can lie in it is looked at, as parts rarely interleave.
template <typename Row, typename Visit>
void forEachRowAmong(const std::vector<Row>& rows, const std::vector<Id>& ids, Visit visit)
{
    if (rows.empty())
        return;
    const auto first = std::lower_bound(ids.begin(), ids.end(), rows.front().id);
    const auto last = std::upper_bound(first, ids.end(), rows.back().id);
    const bool many = 16 * (last - first) > std::ptrdiff_t(rows.size());
    auto row = rows.begin();
    for (auto id = first; id != last; ++id) {
        if (many)
            while (row->id < *id)
                ++row;
        const Row* found = many ? &*row : findRow(rows, *id);
        if (found && found->id == *id)
            visit(*found, std::size_t(id - ids.begin()));
    }
}

} // namespace ripstop
