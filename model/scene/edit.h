// Edits: the only way in which a scene changes.
#pragma once

#include "scene/property.h"

#include <string>
#include <vector>

namespace ripstop {

// One property of one or of many things of the same kind; one value for all, or one for each.
struct SetValues
{
    const Property* property;
    std::vector<Id> targets;
    std::vector<Value> values;
};

struct AddItem
{
    std::size_t index; // place in Scene::items
    Entry entry;
};

struct RemoveItem
{
    Id id;
};

// Rows of the tables of one part.
struct AddRows
{
    Id part;
    std::vector<Particle> particles;
    std::vector<Link> links;
    std::vector<Panel> panels;
};

struct RemoveRows
{
    Id part;
    std::vector<Id> particles;
    std::vector<Id> links;
    std::vector<Id> panels;
};

using Change = std::variant<SetValues, AddItem, RemoveItem, AddRows, RemoveRows>;

// Changes that are made, undone and redone together.
struct Edit
{
    Message label;
    std::vector<Change> changes;
};

// Applies the edit and returns its inverse. The edit must fit the scene: ids that exist, values
// that refusal() lets through.
[[nodiscard]] Edit apply(Scene& scene, const Edit& edit);

// True when both edits only set values, and set the same ones: the steps of one gesture.
bool sameTargets(const Edit& a, const Edit& b);

// What a running simulation must do about the edit.
Effect worstEffect(const Edit& edit);

// Removes the item or the elements with these ids and all that hangs on them: links and panels of a
// removed particle, memberships, targets of controls and probes.
Edit removal(const Scene& scene, const std::vector<Id>& ids);

} // namespace ripstop
