#include "select/element_counts.h"

#include <algorithm>

namespace ripstop {

EditCounts editCountsOf(const Edit& edit)
{
    EditCounts counts;
    const auto count = [](ElementCounts& of, const auto& particles, const auto& links,
                          const auto& panels) {
        of.particles += particles.size();
        of.links += links.size();
        of.panels += panels.size();
    };
    for (const Change& change : edit.changes) {
        if (const auto* rows = std::get_if<AddRows>(&change))
            count(counts.added, rows->particles, rows->links, rows->panels);
        else if (const auto* gone = std::get_if<RemoveRows>(&change))
            count(counts.removed, gone->particles, gone->links, gone->panels);
        else if (const auto* item = std::get_if<AddItem>(&change)) {
            ++counts.added.items;
            if (const Part* part = std::get_if<Part>(&item->entry.item))
                count(counts.added, part->particles, part->links, part->panels);
        } else if (std::get_if<RemoveItem>(&change))
            ++counts.removed.items;
    }
    return counts;
}

ElementCounts alsoRemoved(const std::vector<Id>& ids, const Edit& removal)
{
    std::vector<Id> named = ids;
    std::sort(named.begin(), named.end());
    const auto unnamed = [&](const std::vector<Id>& gone) {
        return std::size_t(std::ranges::count_if(
            gone, [&](Id id) { return !std::binary_search(named.begin(), named.end(), id); }));
    };
    ElementCounts counts;
    for (const Change& change : removal.changes)
        if (const auto* rows = std::get_if<RemoveRows>(&change)) {
            counts.particles += unnamed(rows->particles);
            counts.links += unnamed(rows->links);
            counts.panels += unnamed(rows->panels);
        }
    return counts;
}

} // namespace ripstop
