#include "check/unknown_items.h"

#include <algorithm>

namespace ripstop {

const UnknownItem* findUnknownItem(const Scene& scene, Id id)
{
    const auto found = std::ranges::find(scene.unknownItems, id, &UnknownItem::id);
    return found != scene.unknownItems.end() ? &*found : nullptr;
}

Message unknownText(const UnknownItem& item)
{
    return Message("Item %1 is of the type %2, which this version does not know; it is kept as it "
                   "is and does nothing.",
                   std::uint32_t(item.id), item.type);
}

void checkUnknownItems(const Scene& scene, const AddFinding& add)
{
    for (const UnknownItem& item : scene.unknownItems)
        add("unknown", Severity::Warning, unknownText(item), noId);
}

} // namespace ripstop
