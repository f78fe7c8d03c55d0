// Builds a part again in these stages:
// 1. The builder runs twice, with the old and the new parameters; counterparts.h pairs the old
//    build with what stands in the scene, both are weighed as its materials are by now, what was
//    painted goes over to the new build, and handWork() counts what else was done by hand.
// 2. Rows and items of the new build get ids: those of the scene where there is a counterpart or
//    the tables are as long, otherwise fresh ones. What the author has removed stays away.
// 3. Materials are added, the part is replaced at its place, items are merged property by property
//    where the two builds differ, and what the builder makes no more goes.
// 4. References to rows that are gone are let go, and settings follow where nobody has tuned them.
#include "author/rebuild.h"

#include "author/carry_paint.h"
#include "author/counterparts.h"
#include "author/tuned_weights.h"
#include "select/group.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ripstop {
namespace {

const Entry* entryOf(const Scene& scene, Id id)
{
    for (const Entry& entry : scene.items)
        if (entry.id == id)
            return &entry;
    return nullptr;
}

const Part& partOf(const Entry& entry) { return std::get<Part>(entry.item); }

// Makes the edit that leads from what stands in the scene to what the builder makes now.
class Rebuilding
{
public:
    Rebuilding(const Scene& scene, Id part, const Scene& before, const Scene& after,
               Counterparts counterparts, Id nextId)
        : m_scene(scene)
        , m_part(part)
        , m_before(before)
        , m_after(after)
        , m_counterparts(std::move(counterparts))
        , m_next(nextId)
        , m_end(scene.items.size())
    {}

    Rebuilt run()
    {
        const Entry& held = *entryOf(m_scene, m_part);
        m_rebuilt.lost = handWork(partOf(partEntry(m_before)), partOf(held), m_counterparts);
        m_rebuilt.edit.label = Message("Change parameters of %1", partOf(held).name);
        nameRows(partOf(held), partOf(partEntry(m_after)));
        m_ids[partEntry(m_after).id] = m_part;
        nameItems();
        addMaterials();
        replacePart(held);
        mergeItems();
        mergeSettings();
        return std::move(m_rebuilt);
    }

private:
    Id fresh()
    {
        const Id id = m_next;
        m_next = Id{std::uint32_t(m_next) + 1};
        return id;
    }

    Id idOf(Id built) const
    {
        const auto found = m_ids.find(built);
        return found == m_ids.end() ? noId : found->second;
    }

    // Rows keep their ids where there are as many as before, so that what points at them stays.
    void nameRows(const Part& held, const Part& built)
    {
        const auto name = [&](const auto& before, const auto& after) {
            const bool keeps = before.size() == after.size();
            for (std::size_t i = 0; i < after.size(); ++i)
                m_ids[after[i].id] = keeps ? before[i].id : fresh();
            if (!keeps)
                for (const auto& row : before)
                    m_gone.insert(row.id);
        };
        name(held.particles, built.particles);
        name(held.links, built.links);
        name(held.panels, built.panels);
    }

    const Entry* sameBefore(const Entry& after) const
    {
        for (const Entry& entry : m_before.items)
            if (entry.item.index() == after.item.index()
                && nameOf(entry.item) == nameOf(after.item))
                return &entry;
        return nullptr;
    }

    // The item of the scene that stands for one that is built, or noId.
    Id heldFor(const Entry& after) const
    {
        const Entry* before = sameBefore(after);
        if (!before)
            return noId;
        const auto found = m_counterparts.heldAs.find(before->id);
        return found == m_counterparts.heldAs.end() ? noId : found->second;
    }

    void nameItems()
    {
        for (const Entry& entry : m_after.items) {
            if (std::holds_alternative<Part>(entry.item))
                continue;
            const Id held = heldFor(entry);
            const bool isWanted =
                std::holds_alternative<Material>(entry.item) || !sameBefore(entry);
            if (held != noId)
                m_ids[entry.id] = held;
            else if (isWanted) // what the author has removed stays away
                m_ids[entry.id] = fresh();
        }
    }

    // The item as it will stand in the scene: a collider goes where the part has gone.
    Item placedItem(const Item& item) const
    {
        Item copy = item;
        if (Collider* collider = std::get_if<Collider>(&copy);
            collider && collider->shape != ColliderShape::Plane)
            *collider = placed(*collider, m_counterparts.motion);
        return copy;
    }

    Value mapped(Value value) const
    {
        if (Id* id = std::get_if<Id>(&value))
            *id = idOf(*id);
        if (auto* list = std::get_if<std::vector<Id>>(&value)) {
            for (Id& id : *list)
                id = idOf(id);
            std::erase(*list, noId);
            std::sort(list->begin(), list->end());
        }
        return value;
    }

    // Lists of what is pointed at have no order of their own.
    static Value inOrder(Value value)
    {
        if (auto* list = std::get_if<std::vector<Id>>(&value))
            std::sort(list->begin(), list->end());
        return value;
    }

    void add(const Entry& built)
    {
        Entry entry{idOf(built.id), placedItem(built.item)};
        std::visit(
            [&](auto& item) {
                for (const Property& property : propertiesOf(kindOf(ConstRef(&item))))
                    if (!property.pointsAt.empty())
                        property.set(&item, mapped(property.get(&item)));
                item.name = freeName(m_scene, item.name);
            },
            entry.item);
        m_rebuilt.edit.changes.emplace_back(AddItem{m_end++, std::move(entry)});
    }

    void addMaterials()
    {
        for (const Entry& entry : m_after.items)
            if (std::holds_alternative<Material>(entry.item) && heldFor(entry) == noId)
                add(entry);
    }

    void replacePart(const Entry& held)
    {
        Entry entry = held;
        Part& part = std::get<Part>(entry.item);
        const Part& built = partOf(partEntry(m_after));
        part.parameters = built.parameters;
        part.particles = built.particles;
        part.links = built.links;
        part.panels = built.panels;
        const Eigen::Matrix3d turn = m_counterparts.motion.map.linear();
        for (Particle& row : part.particles) {
            row.id = idOf(row.id);
            row.position = m_counterparts.motion.map * row.position;
            row.velocity = turn * row.velocity;
        }
        for (Link& row : part.links) {
            row.id = idOf(row.id);
            row.from = idOf(row.from);
            row.to = idOf(row.to);
            row.material = idOf(row.material);
        }
        for (Panel& row : part.panels) {
            row.id = idOf(row.id);
            row.a = idOf(row.a);
            row.b = idOf(row.b);
            row.c = idOf(row.c);
            row.material = idOf(row.material);
        }
        const auto byId = [](const auto& a, const auto& b) { return a.id < b.id; };
        std::sort(part.particles.begin(), part.particles.end(), byId);
        std::sort(part.links.begin(), part.links.end(), byId);
        std::sort(part.panels.begin(), part.panels.end(), byId);
        mergeValues(sameBefore(partEntry(m_after))->item, partEntry(m_after).item, entry);
        const auto place = std::size_t(entryOf(m_scene, m_part) - m_scene.items.data());
        removeLinksToGone();
        m_rebuilt.edit.changes.emplace_back(RemoveItem{m_part});
        m_rebuilt.edit.changes.emplace_back(AddItem{place, std::move(entry)});
    }

    // Numbers of the part itself, which the builder sets and the author may have set since.
    static void mergeValues(const Item& before, const Item& after, Entry& held)
    {
        const Part& old = std::get<Part>(before);
        const Part& now = std::get<Part>(after);
        Part& part = std::get<Part>(held.item);
        for (const Property& property : propertiesOf(Kind::Part))
            if (property.get(&old) != property.get(&now))
                property.set(&part, property.get(&now));
    }

    // Links and panels of other parts that were tied to particles which are no more.
    void removeLinksToGone()
    {
        const auto gone = [&](Id id) { return m_gone.contains(id); };
        forEachPart(m_scene, [&](Id id, const Part& part) {
            if (id == m_part)
                return;
            RemoveRows rows{id, {}, {}, {}};
            for (const Link& row : part.links)
                if (gone(row.from) || gone(row.to))
                    rows.links.push_back(row.id);
            for (const Panel& row : part.panels)
                if (gone(row.a) || gone(row.b) || gone(row.c))
                    rows.panels.push_back(row.id);
            m_rebuilt.letGo += rows.links.size() + rows.panels.size();
            if (!rows.links.empty() || !rows.panels.empty())
                m_rebuilt.edit.changes.emplace_back(std::move(rows));
        });
    }

    void mergeItems()
    {
        std::set<Id> ours;
        for (const Entry& entry : m_after.items) {
            const Id held = heldFor(entry);
            if (std::holds_alternative<Part>(entry.item) || idOf(entry.id) == noId)
                continue;
            if (held != noId) {
                merge(*sameBefore(entry), entry, held);
                ours.insert(held);
            } else if (!std::holds_alternative<Material>(entry.item)) {
                add(entry);
            }
        }
        const std::set<Id> left = removeWhatIsNoMore();
        ours.insert(left.begin(), left.end());
        for (const Entry& entry : m_scene.items)
            if (!ours.contains(entry.id) && entry.id != m_part)
                letGo(entry);
    }

    // The scene follows where the parameters make a difference, and in what the item points at.
    void merge(const Entry& before, const Entry& after, Id held)
    {
        const Item then = placedItem(before.item);
        const Item now = placedItem(after.item);
        const Item& there = entryOf(m_scene, held)->item;
        for (const Property& property : propertiesOf(kindOf(there))) {
            const Value wanted = valueOf(property, now);
            const Value current = valueOf(property, there);
            const bool points = !property.pointsAt.empty();
            if (points ? mapped(wanted) == inOrder(current)
                       : wanted == valueOf(property, then) || wanted == current)
                continue;
            m_rebuilt.edit.changes.emplace_back(
                SetValues{&property, {held}, {points ? mapped(wanted) : wanted}});
        }
    }

    // Removes the items that the builder makes no more and returns their ids. Materials stay, since
    // something else may be made of them.
    std::set<Id> removeWhatIsNoMore()
    {
        std::set<Id> removed;
        for (const auto& [built, held] : m_counterparts.heldAs) {
            const Entry* before = entryOf(m_before, built);
            if (!before || std::holds_alternative<Material>(before->item)
                || std::holds_alternative<Part>(before->item))
                continue;
            const bool isThere = std::ranges::any_of(
                m_after.items, [&](const Entry& entry) { return sameBefore(entry) == before; });
            if (!isThere && removed.insert(held).second)
                m_rebuilt.edit.changes.emplace_back(RemoveItem{held});
        }
        return removed;
    }

    // Clears the references of what the author made to rows that are no more.
    void letGo(const Entry& entry)
    {
        for (const Property& property : propertiesOf(kindOf(entry.item))) {
            if (property.pointsAt.empty())
                continue;
            Value value = valueOf(property, entry.item);
            const Value before = value;
            if (Id* id = std::get_if<Id>(&value); id && m_gone.contains(*id))
                *id = noId;
            if (auto* list = std::get_if<std::vector<Id>>(&value))
                std::erase_if(*list, [&](Id id) { return m_gone.contains(id); });
            if (value == before)
                continue;
            ++m_rebuilt.letGo;
            m_rebuilt.edit.changes.emplace_back(SetValues{&property, {entry.id}, {value}});
        }
    }

    void mergeSettings()
    {
        for (const Property& property : propertiesOf(Kind::Settings)) {
            const Value wanted = property.get(&m_after.settings);
            const Value before = property.get(&m_before.settings);
            const Value held = property.get(&m_scene.settings);
            const bool isTuned = held != before;
            const bool isShort = isOneOf<&Settings::substeps>(property)
                                 && std::get<int>(held) < std::get<int>(wanted);
            if (wanted != before && wanted != held && (!isTuned || isShort))
                m_rebuilt.edit.changes.emplace_back(SetValues{&property, {settingsId}, {wanted}});
        }
    }

    static Kind kindOf(const Item& item)
    {
        return std::visit([](const auto& one) { return ripstop::kindOf(ConstRef(&one)); }, item);
    }
    static Kind kindOf(const ConstRef& ref) { return ripstop::kindOf(ref); }
    static Value valueOf(const Property& property, const Item& item)
    {
        return std::visit([&](const auto& one) { return property.get(&one); }, item);
    }

    const Scene& m_scene;
    Id m_part;
    const Scene& m_before;
    const Scene& m_after;
    Counterparts m_counterparts;
    std::map<Id, Id> m_ids; // of what is built now: where it will stand in the scene
    std::set<Id> m_gone;    // rows that are no more
    Id m_next;
    std::size_t m_end;
    Rebuilt m_rebuilt;
};

} // namespace

const Builder* builderOf(const Part& part)
{
    return part.builder.empty() ? nullptr : findBuilder(part.builder);
}

std::vector<Id> builtParts(const Scene& scene, const std::vector<Id>& selected)
{
    const std::set<Id> ids(selected.begin(), selected.end());
    const auto isIn = [&](const auto& row) { return ids.contains(row.id); };
    std::vector<Id> parts;
    forEachPart(scene, [&](Id id, const Part& part) {
        if (builderOf(part)
            && (ids.contains(id) || std::ranges::any_of(part.particles, isIn)
                || std::ranges::any_of(part.links, isIn) || std::ranges::any_of(part.panels, isIn)))
            parts.push_back(id);
    });
    std::sort(parts.begin(), parts.end());
    return parts;
}

Result<Rebuilt> rebuilt(const Scene& scene, Id id, const Parameters& parameters,
                        std::optional<Id> nextId)
{
    const Part& part = *findItem<Part>(scene, id);
    const Builder& builder = *builderOf(part);
    ChosenNow now = chosenNow(scene, id);
    Result<Scene> before = build(builder, now.parameters);
    if (!before)
        return before.failure();
    Result<Scene> after = build(builder, parameters);
    if (!after)
        return after.failure();
    Counterparts counterparts = counterpartsOf(scene, id, *before);
    weighAsTuned(scene, counterparts, *before, *after);
    // last, as the other one needs it as it was
    weighAsTuned(scene, counterparts, *before, *before);
    const CarriedPaint paint = carryPaint(part, counterparts, *before, *after);
    Rebuilt outcome = Rebuilding(scene, id, *before, *after, std::move(counterparts),
                                 nextId.value_or(scene.nextId))
                          .run();
    outcome.lost.painted = paint.lost;
    outcome.painted = paint.kept;
    outcome.built = std::move(*after);
    std::erase_if(now.others, [&](const OtherMaterial& other) {
        const auto wanted = parameters.find(std::string(other.parameter));
        return wanted == parameters.end() || wanted->second != now.parameters[wanted->first];
    });
    outcome.staying = std::move(now.others);
    return outcome;
}

Edit detached(const Scene& scene, const std::vector<Id>& parts)
{
    SetValues change{&propertyOf<&Part::builder>(), {}, {std::string()}};
    for (const Id id : parts)
        if (const Part* part = findItem<Part>(scene, id); part && builderOf(*part))
            change.targets.push_back(id);
    Edit edit{Message("Detach from builder"), {}};
    if (!change.targets.empty())
        edit.changes.emplace_back(std::move(change));
    return edit;
}

} // namespace ripstop
