#include "document/census.h"

#include "select/rows_among.h"

#include <algorithm>

namespace ripstop {

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
            const auto findRows = [&](const auto& rows, Kind kind) {
                forEachRowAmong(rows, ids, [&](const auto& row, std::size_t) {
                    of(kind).push_back({row.id, &row, entry.id});
                });
            };
            findRows(part->particles, Kind::Particle);
            findRows(part->links, Kind::Link);
            findRows(part->panels, Kind::Panel);
        }
    }
    const auto byId = [](const auto& a, const auto& b) { return a.id < b.id; };
    for (auto& found : result.found)
        if (!std::is_sorted(found.begin(), found.end(), byId))
            std::sort(found.begin(), found.end(), byId);
    return result;
}

} // namespace ripstop
