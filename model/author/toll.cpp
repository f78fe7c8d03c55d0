#include "author/toll.h"

#include <algorithm>

namespace ripstop {

Tolls tollsOf(const Edit& edit)
{
    Tolls tolls;
    const auto count = [](Toll& toll, const auto& particles, const auto& links,
                          const auto& panels) {
        toll.particles += particles.size();
        toll.links += links.size();
        toll.panels += panels.size();
    };
    for (const Change& change : edit.changes) {
        if (const auto* rows = std::get_if<AddRows>(&change))
            count(tolls.added, rows->particles, rows->links, rows->panels);
        else if (const auto* gone = std::get_if<RemoveRows>(&change))
            count(tolls.removed, gone->particles, gone->links, gone->panels);
        else if (const auto* item = std::get_if<AddItem>(&change)) {
            ++tolls.added.items;
            if (const Part* part = std::get_if<Part>(&item->entry.item))
                count(tolls.added, part->particles, part->links, part->panels);
        } else if (std::get_if<RemoveItem>(&change))
            ++tolls.removed.items;
    }
    return tolls;
}

Toll alsoRemoved(const std::vector<Id>& ids, const Edit& removal)
{
    std::vector<Id> named = ids;
    std::sort(named.begin(), named.end());
    const auto unnamed = [&](const std::vector<Id>& gone) {
        return std::size_t(std::ranges::count_if(
            gone, [&](Id id) { return !std::binary_search(named.begin(), named.end(), id); }));
    };
    Toll toll;
    for (const Change& change : removal.changes)
        if (const auto* rows = std::get_if<RemoveRows>(&change)) {
            toll.particles += unnamed(rows->particles);
            toll.links += unnamed(rows->links);
            toll.panels += unnamed(rows->panels);
        }
    return toll;
}

} // namespace ripstop
