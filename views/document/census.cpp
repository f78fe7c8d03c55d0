#include "document/census.h"

#include <algorithm>

namespace ripstop {
namespace {

// Only the stretch of `ids` that can lie in the table is searched: parts rarely interleave.
template <typename Row>
void findRows(const std::vector<Row>& rows, const std::vector<Id>& ids, Id part,
              std::vector<Census::Found>& found)
{
    if (rows.empty())
        return;
    const auto first = std::lower_bound(ids.begin(), ids.end(), rows.front().id);
    const auto last = std::upper_bound(first, ids.end(), rows.back().id);
    for (auto id = first; id != last; ++id)
        if (const Row* row = findRow(rows, *id))
            found.push_back({*id, row, part});
}

} // namespace

Census census(const Scene& scene, const std::vector<Id>& ids)
{
    Census result;
    const auto of = [&](Kind kind) -> auto& { return result.found[std::size_t(kind)]; };
    const auto wanted = [&](Id id) { return std::binary_search(ids.begin(), ids.end(), id); };

    if (wanted(settingsId))
        of(Kind::Settings).push_back({settingsId, &scene.settings, noId});
    for (const Entry& entry : scene.items) {
        if (wanted(entry.id)) {
            const auto ref =
                std::visit([](const auto& item) -> ConstRef { return &item; }, entry.item);
            of(kindOf(ref)).push_back({entry.id, ref, noId});
        }
        if (const Part* part = std::get_if<Part>(&entry.item)) {
            findRows(part->particles, ids, entry.id, of(Kind::Particle));
            findRows(part->links, ids, entry.id, of(Kind::Link));
            findRows(part->panels, ids, entry.id, of(Kind::Panel));
        }
    }
    for (auto& found : result.found)
        std::sort(found.begin(), found.end(),
                  [](const auto& a, const auto& b) { return a.id < b.id; });
    return result;
}

} // namespace ripstop
