// Edits: the only way in which a scene changes.
// An edit is a label and a list of changes. apply() makes them and returns the inverse edit, which
// is what undo keeps. Edits are small beside a scene, so the document sends the same edit to its
// follower thread and recordings note them. A scene has no lock: only the thread that owns it may
// apply an edit to it.
#pragma once

#include "scene/property.h"

#include <string>
#include <vector>

namespace ripstop {

// Sets one property of one or of many things of the same kind. There is one value for all of them,
// or one for each.
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

// Adds rows to the tables of one part. They may come in any order of id.
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

// What a running simulation must do about the edit: the strongest effect of all its changes.
Effect worstEffect(const Edit& edit);

// Removes the item or the elements with these ids and all that hangs on them: links and panels of a
// removed particle, memberships, targets of controls and probes.
Edit removal(const Scene& scene, const std::vector<Id>& ids);

} // namespace ripstop
