#include "author/scene_pairs.h"

#include <algorithm>

namespace ripstop {
namespace {

using Entries = std::vector<const Entry*>;

Entries entriesOf(const Scene& scene)
{
    Entries entries;
    for (const Entry& entry : scene.items)
        entries.push_back(&entry);
    return entries;
}

// Moves those that `match` into pairs, the first with the first that it fits; returns how many.
template <typename Match>
std::size_t pairUp(ScenePairs& pairs, Match match)
{
    std::size_t count = 0;
    std::erase_if(pairs.onlyFirst, [&](const Entry* a) {
        const auto fits = [&](const Entry* b) {
            return a->item.index() == b->item.index() && match(*a, *b);
        };
        const auto found = std::ranges::find_if(pairs.onlySecond, fits);
        if (found == pairs.onlySecond.end())
            return false;
        pairs.items.emplace_back(a, *found);
        pairs.onlySecond.erase(found);
        ++count;
        return true;
    });
    return count;
}

// Rows are in ascending order of id.
template <typename Row>
std::size_t sharedIds(const std::vector<Row>& a, const std::vector<Row>& b)
{
    std::size_t shared = 0;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        shared += a[i].id == b[j].id;
        const bool next = a[i].id <= b[j].id;
        j += b[j].id <= a[i].id;
        i += next;
    }
    return shared;
}

// Half of the rows that may share their ids have to, as ids of designs that were made apart can be
// the same by chance.
template <typename Row>
void pairRows(ScenePairs& pairs, const std::vector<Row>& a, const std::vector<Row>& b, bool sameId)
{
    if (sameId && 2 * sharedIds(a, b) >= std::min(a.size(), b.size())) {
        for (const Row& row : a)
            if (findRow(b, row.id))
                pairs.secondOf.emplace(row.id, row.id);
    } else if (a.size() == b.size()) {
        for (std::size_t i = 0; i < a.size(); ++i)
            pairs.secondOf.emplace(a[i].id, b[i].id);
    } else {
        for (const Row& row : a)
            pairs.unknown.insert(row.id);
    }
}

} // namespace

ScenePairs pairsOf(const Scene& first, const Scene& second)
{
    ScenePairs pairs{{}, entriesOf(first), entriesOf(second), {}, {}};
    const std::size_t known = pairUp(pairs, [](const Entry& a, const Entry& b) {
        return a.id == b.id && nameOf(a.item) == nameOf(b.item);
    });
    const std::size_t elsewhere = pairUp(
        pairs, [](const Entry& a, const Entry& b) { return nameOf(a.item) == nameOf(b.item); });
    if (known >= elsewhere) // two states of one design: what has another name was renamed
        pairUp(pairs, [](const Entry& a, const Entry& b) { return a.id == b.id; });

    std::ranges::sort(pairs.items, {}, [](const auto& pair) { return pair.first; });
    for (const auto& [a, b] : pairs.items) {
        pairs.secondOf.emplace(a->id, b->id);
        const Part* part = std::get_if<Part>(&a->item);
        if (!part)
            continue;
        const Part& other = std::get<Part>(b->item);
        pairRows(pairs, part->particles, other.particles, a->id == b->id);
        pairRows(pairs, part->links, other.links, a->id == b->id);
        pairRows(pairs, part->panels, other.panels, a->id == b->id);
    }
    return pairs;
}

} // namespace ripstop
