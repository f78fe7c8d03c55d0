// Resolves selections: elementsOf() walks the ids along the sorted list of items and puts the
// elements of an item in its place; then the rows are gathered by one pass over the tables
// (rows_among.h). Lists are sorted only where they are not in order already, because parts rarely
// interleave and selections have hundred thousands of ids.
#include "select/elements.h"

#include "select/rows_among.h"

#include <algorithm>

namespace ripstop {
namespace {

template <typename Row>
void addIds(const std::vector<Row>& rows, std::vector<Id>& ids)
{
    for (const Row& row : rows)
        ids.push_back(row.id);
}

void addMaterial(const Scene& scene, Id material, std::vector<Id>& ids)
{
    const auto addMatching = [&](const auto& rows) {
        for (const auto& row : rows)
            if (row.material == material)
                ids.push_back(row.id);
    };
    forEachPart(scene, [&](Id, const Part& part) {
        addMatching(part.links);
        addMatching(part.panels);
    });
}

void addItem(const Scene& scene, Id id, const Item& item, std::vector<Id>& ids)
{
    const auto addMembers = [&ids](const std::vector<Id>& members) {
        ids.insert(ids.end(), members.begin(), members.end());
    };
    if (const Part* part = std::get_if<Part>(&item)) {
        addIds(part->particles, ids);
        addIds(part->links, ids);
        addIds(part->panels, ids);
    } else if (std::holds_alternative<Material>(item)) {
        addMaterial(scene, id, ids);
    } else if (const Group* group = std::get_if<Group>(&item)) {
        addMembers(group->members);
    } else if (const Control* control = std::get_if<Control>(&item)) {
        addMembers(control->targets);
    } else if (const Probe* probe = std::get_if<Probe>(&item)) {
        addMembers({probe->target, probe->from});
    }
}

// Parts rarely interleave, and then the rows are in order already.
template <typename Row>
void sortById(std::vector<const Row*>& rows)
{
    const auto byId = [](const Row* a, const Row* b) { return a->id < b->id; };
    if (!std::ranges::is_sorted(rows, byId))
        std::ranges::sort(rows, byId);
}

template <typename AddTables>
Elements gathered(const Scene& scene, AddTables add)
{
    Elements elements;
    forEachPart(scene, [&](Id, const Part& part) {
        add(part.particles, elements.particles);
        add(part.links, elements.links);
        add(part.panels, elements.panels);
    });
    sortById(elements.particles);
    sortById(elements.links);
    sortById(elements.panels);
    return elements;
}

} // namespace

std::vector<Id> elementsOf(const Scene& scene, const std::vector<Id>& selected)
{
    std::vector<Id> items;
    for (const Entry& entry : scene.items)
        items.push_back(entry.id);
    std::ranges::sort(items);

    std::vector<Id> ids;
    ids.reserve(selected.size());
    auto item = items.begin();
    for (const Id id : selected) {
        if (item != items.begin() && id < *std::prev(item))
            item = items.begin(); // not in order after all
        while (item != items.end() && *item < id)
            ++item;
        if (item == items.end() || *item != id)
            ids.push_back(id);
        else
            addItem(scene, id, *findItem(scene, id), ids);
    }
    if (!std::ranges::is_sorted(ids))
        std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

std::vector<Id> Elements::ids() const
{
    std::vector<Id> ids;
    ids.reserve(particles.size() + links.size() + panels.size());
    for (const Particle* row : particles)
        ids.push_back(row->id);
    for (const Link* row : links)
        ids.push_back(row->id);
    for (const Panel* row : panels)
        ids.push_back(row->id);
    if (!std::ranges::is_sorted(ids))
        std::ranges::sort(ids);
    return ids;
}

Elements sortedElements(const Scene& scene, const std::vector<Id>& selected)
{
    const std::vector<Id> ids = elementsOf(scene, selected);
    return gathered(scene, [&](const auto& rows, auto& found) {
        forEachRowAmong(rows, ids, [&](const auto& row, std::size_t) { found.push_back(&row); });
    });
}

Elements everyElement(const Scene& scene)
{
    return gathered(scene, [](const auto& rows, auto& found) {
        found.reserve(found.size() + rows.size());
        for (const auto& row : rows)
            found.push_back(&row);
    });
}

} // namespace ripstop
