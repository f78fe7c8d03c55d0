// Applies edits and makes the one edit that is made of a whole scene, the removal.
// - Applier has one function for each kind of change. Each returns the change that undoes it; rows
//   stay in ascending order of id, and the id counter of the scene only rises.
// - apply() makes the changes in order and returns their inverses in reverse order.
// - removal() first collects all that must go with the named things, then rewrites the references
//   to them, and removes rows and items last, so that undo brings back the things before the
//   references.
#include "scene/edit.h"

#include "scene/references.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace ripstop {
namespace {

template <typename Row>
void insertRows(std::vector<Row>& rows, const std::vector<Row>& added)
{
    const auto byId = [](const Row& a, const Row& b) { return a.id < b.id; };
    const auto middle = std::ptrdiff_t(rows.size());
    rows.insert(rows.end(), added.begin(), added.end());
    std::sort(rows.begin() + middle, rows.end(), byId);
    std::inplace_merge(rows.begin(), rows.begin() + middle, rows.end(), byId);
}

template <typename Row>
std::vector<Row> extractRows(std::vector<Row>& rows, std::vector<Id> ids)
{
    std::sort(ids.begin(), ids.end());
    std::vector<Row> removed;
    removed.reserve(ids.size());
    std::erase_if(rows, [&](const Row& row) {
        const bool out = std::binary_search(ids.begin(), ids.end(), row.id);
        if (out)
            removed.push_back(row);
        return out;
    });
    return removed;
}

template <typename Row>
std::vector<Id> idsOf(const std::vector<Row>& rows)
{
    std::vector<Id> ids;
    ids.reserve(rows.size());
    for (const Row& row : rows)
        ids.push_back(row.id);
    return ids;
}

struct Applier
{
    Scene& scene;

    Change operator()(const SetValues& change) const
    {
        assert(change.values.size() == 1 || change.values.size() == change.targets.size());
        SetValues inverse{change.property, change.targets, {}};
        inverse.values.reserve(change.targets.size());
        for (std::size_t i = 0; i < change.targets.size(); ++i) {
            const std::optional<Ref> ref = find(scene, change.targets[i]);
            assert(ref && kindOf(asConst(*ref)) == change.property->kind);
            inverse.values.push_back(change.property->get(asConst(*ref)));
            change.property->set(*ref, change.values[change.values.size() == 1 ? 0 : i]);
        }
        return inverse;
    }

    Change operator()(const AddItem& change) const
    {
        const std::size_t index = std::min(change.index, scene.items.size());
        scene.items.insert(scene.items.begin() + std::ptrdiff_t(index), change.entry);
        use(change.entry.id);
        if (const Part* part = std::get_if<Part>(&change.entry.item))
            useRows(part->particles, part->links, part->panels);
        return RemoveItem{change.entry.id};
    }

    Change operator()(const RemoveItem& change) const
    {
        const auto entry = std::find_if(scene.items.begin(), scene.items.end(),
                                        [&](const Entry& e) { return e.id == change.id; });
        assert(entry != scene.items.end());
        AddItem inverse{std::size_t(entry - scene.items.begin()), std::move(*entry)};
        scene.items.erase(entry);
        return inverse;
    }

    Change operator()(const AddRows& change) const
    {
        Part& part = std::get<Part>(*findItem(scene, change.part));
        insertRows(part.particles, change.particles);
        insertRows(part.links, change.links);
        insertRows(part.panels, change.panels);
        useRows(change.particles, change.links, change.panels);
        return RemoveRows{change.part, idsOf(change.particles), idsOf(change.links),
                          idsOf(change.panels)};
    }

    Change operator()(const RemoveRows& change) const
    {
        Part& part = std::get<Part>(*findItem(scene, change.part));
        return AddRows{change.part, extractRows(part.particles, change.particles),
                       extractRows(part.links, change.links),
                       extractRows(part.panels, change.panels)};
    }

    void use(Id id) const { scene.nextId = std::max(scene.nextId, Id{std::uint32_t(id) + 1}); }

    void useRows(const std::vector<Particle>& particles, const std::vector<Link>& links,
                 const std::vector<Panel>& panels) const
    {
        for (const Particle& row : particles)
            use(row.id);
        for (const Link& row : links)
            use(row.id);
        for (const Panel& row : panels)
            use(row.id);
    }
};

} // namespace

Edit apply(Scene& scene, const Edit& edit)
{
    Edit inverse{edit.label, {}};
    for (const Change& change : edit.changes)
        inverse.changes.push_back(std::visit(Applier{scene}, change));
    std::reverse(inverse.changes.begin(), inverse.changes.end());
    return inverse;
}

bool sameTargets(const Edit& a, const Edit& b)
{
    return std::equal(a.changes.begin(), a.changes.end(), b.changes.begin(), b.changes.end(),
                      [](const Change& x, const Change& y) {
                          const auto* left = std::get_if<SetValues>(&x);
                          const auto* right = std::get_if<SetValues>(&y);
                          return left && right && left->property == right->property
                                 && left->targets == right->targets;
                      });
}

Effect worstEffect(const Edit& edit)
{
    Effect worst = Effect::DisplayOnly;
    for (const Change& change : edit.changes) {
        const auto* values = std::get_if<SetValues>(&change);
        if (!values || values->property->effect == Effect::Recompile)
            return Effect::Recompile;
        if (values->property->effect == Effect::OnReset)
            worst = Effect::OnReset;
    }
    return worst;
}

Edit removal(const Scene& scene, const std::vector<Id>& ids)
{
    // Everything that goes: what was named, the elements of named parts, and links and panels
    // that lose a corner.
    std::set<Id> gone(ids.begin(), ids.end());
    forEachPart(scene, [&](Id id, const Part& part) {
        if (gone.contains(id)) {
            for (const Id element : idsOf(part.particles))
                gone.insert(element);
            for (const Id element : idsOf(part.links))
                gone.insert(element);
            for (const Id element : idsOf(part.panels))
                gone.insert(element);
        }
    });
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& link : part.links)
            if (gone.contains(link.from) || gone.contains(link.to))
                gone.insert(link.id);
        for (const Panel& panel : part.panels)
            if (gone.contains(panel.a) || gone.contains(panel.b) || gone.contains(panel.c))
                gone.insert(panel.id);
    });

    Edit edit{Message("Remove"), {}};

    // References first, so that undo restores what they point at before the references themselves.
    const Heirs left = [&](Id id, std::vector<Id>& heirs) {
        if (!gone.contains(id))
            heirs.push_back(id);
    };
    for (const Entry& entry : scene.items)
        if (!gone.contains(entry.id))
            std::visit([&](const auto& item) { passOn(edit, entry.id, &item, left); }, entry.item);
    const auto forget = [&](const auto& rows) {
        for (const auto& row : rows)
            if (gone.contains(row.material) && !gone.contains(row.id))
                passOn(edit, row.id, &row, left);
    };
    forEachPart(scene, [&](Id, const Part& part) {
        forget(part.links);
        forget(part.panels);
    });

    const auto goneOf = [&](const auto& rows) {
        std::vector<Id> found = idsOf(rows);
        std::erase_if(found, [&](Id id) { return !gone.contains(id); });
        return found;
    };
    for (const Entry& entry : scene.items) {
        const Part* part = std::get_if<Part>(&entry.item);
        if (gone.contains(entry.id))
            edit.changes.emplace_back(RemoveItem{entry.id});
        else if (part) {
            RemoveRows rows{entry.id, goneOf(part->particles), goneOf(part->links),
                            goneOf(part->panels)};
            if (!rows.particles.empty() || !rows.links.empty() || !rows.panels.empty())
                edit.changes.emplace_back(std::move(rows));
        }
    }
    return edit;
}

} // namespace ripstop
