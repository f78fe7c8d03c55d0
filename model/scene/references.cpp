#include "scene/references.h"

#include <algorithm>

namespace ripstop {
namespace {

Id passedOn(Id id, const Heirs& heirs)
{
    if (id == noId)
        return id;
    std::vector<Id> found;
    heirs(id, found);
    return found.empty() ? noId : found.front();
}

// The list as it was when every member is its own heir; otherwise the heirs in ascending order of
// id, each once.
std::vector<Id> passedOn(const std::vector<Id>& list, const Heirs& heirs)
{
    std::vector<Id> found;
    found.reserve(list.size());
    for (const Id id : list)
        heirs(id, found);
    if (found == list)
        return found;
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace

void passOn(Edit& edit, Id holder, const ConstRef& ref, const Heirs& heirs)
{
    for (const Property& property : propertiesOf(kindOf(ref))) {
        if (property.pointsAt.empty())
            continue;
        const Value before = property.get(ref);
        Value value = before;
        if (Id* id = std::get_if<Id>(&value))
            *id = passedOn(*id, heirs);
        if (auto* list = std::get_if<std::vector<Id>>(&value))
            *list = passedOn(*list, heirs);
        if (value != before)
            edit.changes.emplace_back(SetValues{&property, {holder}, {value}});
    }
}

void passOn(Edit& edit, const Scene& scene, const Heirs& heirs)
{
    for (const Entry& entry : scene.items)
        std::visit([&](const auto& item) { passOn(edit, entry.id, &item, heirs); }, entry.item);
}

} // namespace ripstop
