#include "select/group.h"

#include "select/elements.h"

#include <algorithm>
#include <iterator>

namespace ripstop {
namespace {

// A collider that a control moves is meant by the control, and is no member of a group.
std::vector<Id> membersOf(const Scene& scene, const std::vector<Id>& selected)
{
    return sortedElements(scene, selected).ids();
}

Edit regrouped(const Scene& scene, Id group, std::vector<Id> members, Message label)
{
    if (members == findItem<Group>(scene, group)->members)
        return {};
    const Property* property = &propertyOf<&Group::members>();
    return {std::move(label), {SetValues{property, {group}, {std::move(members)}}}};
}

} // namespace

std::string freeName(const Scene& scene, std::string_view base)
{
    std::string name(base);
    const auto isTaken = [&] {
        return std::ranges::any_of(scene.items,
                                   [&](const Entry& entry) { return nameOf(entry.item) == name; });
    };
    for (int number = 2; isTaken(); ++number)
        name = std::string(base) + " " + std::to_string(number);
    return name;
}

Edit grouped(const Scene& scene, const std::string& name, const std::vector<Id>& selected)
{
    const Entry entry{scene.nextId, Group{name, membersOf(scene, selected)}};
    return {Message("Group %1", name), {AddItem{scene.items.size(), entry}}};
}

Edit addedToGroup(const Scene& scene, Id group, const std::vector<Id>& selected)
{
    const std::vector<Id>& before = findItem<Group>(scene, group)->members;
    std::vector<Id> known = before;
    std::ranges::sort(known);
    std::vector<Id> members = before; // which keep their order
    std::ranges::set_difference(membersOf(scene, selected), known, std::back_inserter(members));
    return regrouped(scene, group, std::move(members),
                     Message("Add to %1", findItem<Group>(scene, group)->name));
}

Edit removedFromGroup(const Scene& scene, Id group, const std::vector<Id>& selected)
{
    const std::vector<Id> out = membersOf(scene, selected);
    std::vector<Id> members = findItem<Group>(scene, group)->members;
    std::erase_if(members, [&](Id id) { return std::ranges::binary_search(out, id); });
    return regrouped(scene, group, std::move(members),
                     Message("Remove from %1", findItem<Group>(scene, group)->name));
}

} // namespace ripstop
