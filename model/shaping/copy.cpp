// Copies rows and items under fresh ids:
// 1. Copier keeps which id became which; shared ones stand for themselves, so that a mirrored half
//    hangs on the same particles on the plane.
// 2. addCopy() makes one copy of a selection: whole parts as new items, rows into their own part,
//    then the selected items with their references renewed.
// 3. Arrays are copies by a list of motions; a mirror turns windings, puts near particles onto the
//    plane and lets copies join groups.
// 4. excerpt() and pasted() carry a selection between scenes; a material that is there already is
//    used again, so materials come first.
#include "shaping/copy.h"

#include "base/key_index.h"
#include "derived/flat_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

namespace ripstop {
namespace {

bool isIn(const std::vector<Id>& sorted, Id id)
{
    return std::binary_search(sorted.begin(), sorted.end(), id);
}

std::vector<Id> sortedOf(std::vector<Id> ids)
{
    std::sort(ids.begin(), ids.end());
    return ids;
}

// The rows of a part whose particles are all in `particles`.
Part rowsAmong(const Part& part, const std::vector<Id>& particles)
{
    Part some = part;
    std::erase_if(some.particles, [&](const Particle& row) { return !isIn(particles, row.id); });
    std::erase_if(some.links, [&](const Link& row) {
        return !isIn(particles, row.from) || !isIn(particles, row.to);
    });
    std::erase_if(some.panels, [&](const Panel& row) {
        return !isIn(particles, row.a) || !isIn(particles, row.b) || !isIn(particles, row.c);
    });
    return some;
}

bool hasRows(const Part& part)
{
    return !part.particles.empty() || !part.links.empty() || !part.panels.empty();
}

enum class PanelWinding { Kept, Turned };

// Cut like the panel, seen from the other side. Where panels carry no pull they have no cut.
Panel turned(const Panel& row, const Part& part)
{
    const auto at = [&](Id id) {
        const auto found = std::ranges::lower_bound(part.particles, id, {}, &Particle::id);
        return found == part.particles.end() ? Vec3(Vec3::Zero()) : found->position;
    };
    if (part.carrier == FabricKind::Panels)
        return turnedOver(row, at(row.a), at(row.b), at(row.c));
    Panel turned = row;
    std::swap(turned.b, turned.c);
    return turned;
}

// Makes the rows and items of one copy after another, under fresh ids.
class Copier
{
public:
    explicit Copier(Id nextId)
        : m_next(nextId)
    {}

    // Lets a thing stand for itself in the copies.
    void share(Id id)
    {
        m_copyOf[id] = id;
        m_shared.insert(id);
    }
    void use(Id original, Id copy) { m_copyOf[original] = copy; }

    // Forgets the copies made so far, since another copy of the same things follows.
    void begin()
    {
        m_copyOf.clear();
        m_shared.clear();
    }

    Id take(Id original)
    {
        const Id id = fresh();
        m_copyOf[original] = id;
        return id;
    }

    Id fresh()
    {
        const Id id = m_next;
        m_next = Id{std::uint32_t(m_next) + 1};
        return id;
    }

    // A copy in another scene may happen to have the number of its original, and is no shared one.
    bool isShared(Id id) const { return m_shared.contains(id); }
    bool isCopied(Id id) const { return m_copyOf.contains(id) && !isShared(id); }
    Id operator()(Id id) const // itself where there is no copy
    {
        const auto found = m_copyOf.find(id);
        return found == m_copyOf.end() ? id : found->second;
    }

    // Copies of all rows but of what is shared entirely.
    AddRows rowsOf(const Part& part, const Motion& motion, PanelWinding winding)
    {
        AddRows rows{};
        const Eigen::Matrix3d linear = motion.map.linear();
        for (const Particle& row : part.particles) {
            if (isShared(row.id))
                continue;
            Particle copy = row;
            copy.id = take(row.id);
            copy.position = motion.map * row.position;
            copy.velocity = linear * row.velocity;
            copy.guideAxis = turnedAxis(row.guide, row.guideAxis, linear);
            rows.particles.push_back(copy);
        }
        for (const Link& row : part.links) {
            if (isShared(row.from) && isShared(row.to))
                continue;
            Link copy = row;
            copy.id = take(row.id);
            copy.from = (*this)(row.from);
            copy.to = (*this)(row.to);
            copy.material = (*this)(row.material);
            rows.links.push_back(copy);
        }
        for (const Panel& row : part.panels) {
            if (isShared(row.a) && isShared(row.b) && isShared(row.c))
                continue;
            Panel copy = winding == PanelWinding::Turned ? turned(row, part) : row;
            copy.id = take(row.id);
            copy.a = (*this)(copy.a);
            copy.b = (*this)(copy.b);
            copy.c = (*this)(copy.c);
            copy.material = (*this)(row.material);
            rows.panels.push_back(copy);
        }
        return rows;
    }

    // A copy of an item whose references lead to copies where there are some.
    Item itemOf(const Item& item, const Motion& motion) const
    {
        Item copy = item;
        const auto renew = [&](std::vector<Id>& list) {
            for (Id& id : list)
                id = (*this)(id);
            std::sort(list.begin(), list.end());
        };
        if (Group* group = std::get_if<Group>(&copy))
            renew(group->members);
        else if (Control* control = std::get_if<Control>(&copy))
            renew(control->targets);
        else if (Probe* probe = std::get_if<Probe>(&copy)) {
            probe->target = (*this)(probe->target);
            probe->from = (*this)(probe->from);
        } else if (Plot* plot = std::get_if<Plot>(&copy)) {
            renew(plot->probes);
            plot->against = (*this)(plot->against);
        } else if (Collider* collider = std::get_if<Collider>(&copy))
            *collider = placed(*collider, motion);
        else if (Wind* wind = std::get_if<Wind>(&copy))
            wind->position = motion.map * wind->position;
        return copy;
    }

private:
    Id m_next;
    std::unordered_map<Id, Id> m_copyOf;
    std::unordered_set<Id> m_shared;
};

void rename(Item& item)
{
    std::visit([](auto& one) { one.name += " copy"; }, item);
}

void note(Copies& copies, const AddRows& rows)
{
    for (const Particle& row : rows.particles)
        copies.ids.push_back(row.id);
    for (const Link& row : rows.links)
        copies.ids.push_back(row.id);
    for (const Panel& row : rows.panels)
        copies.ids.push_back(row.id);
}

Entry wholePart(Copier& copier, const Entry& original, const Motion& motion, PanelWinding winding)
{
    Entry entry{copier.take(original.id), original.item};
    Part& part = std::get<Part>(entry.item);
    AddRows rows = copier.rowsOf(part, motion, winding);
    part.particles = std::move(rows.particles);
    part.links = std::move(rows.links);
    part.panels = std::move(rows.panels);
    return entry;
}

// One copy of what is selected. `end` is where new items go.
void addCopy(Copies& copies, Copier& copier, const Scene& scene, const std::vector<Id>& ids,
             const std::vector<Id>& particles, const Motion& motion, PanelWinding winding,
             std::size_t& end)
{
    const auto add = [&](Entry entry) {
        rename(entry.item);
        copies.ids.push_back(entry.id);
        copies.edit.changes.emplace_back(AddItem{end++, std::move(entry)});
    };
    for (const Entry& entry : scene.items) {
        const Part* part = std::get_if<Part>(&entry.item);
        const bool isWhole = isIn(ids, entry.id);
        if (!part)
            continue;
        const bool sharesSome = std::ranges::any_of(
            part->particles, [&](const Particle& row) { return copier.isShared(row.id); });
        if (isWhole && !sharesSome) {
            // without links to what is not copied
            add(wholePart(copier, {entry.id, rowsAmong(*part, particles)}, motion, winding));
            continue;
        }
        const Part some = rowsAmong(*part, particles);
        AddRows rows = copier.rowsOf(some, motion, winding);
        rows.part = entry.id;
        note(copies, rows);
        if (!rows.particles.empty() || !rows.links.empty() || !rows.panels.empty())
            copies.edit.changes.emplace_back(std::move(rows));
    }
    for (const Entry& entry : scene.items) {
        const bool isPlain = !std::get_if<Part>(&entry.item);
        if (isPlain && isIn(ids, entry.id))
            add({copier.take(entry.id), copier.itemOf(entry.item, motion)});
    }
}

} // namespace

Copies duplicated(const Scene& scene, const std::vector<Id>& selected,
                  const std::vector<Motion>& motions, Message label)
{
    Copies copies{{std::move(label), {}}, {}};
    const std::vector<Id> ids = sortedOf(selected);
    // a group, control or probe is copied as such and not with what it points at
    std::vector<Id> meant = ids;
    std::erase_if(meant, [&](Id id) {
        const Item* item = findItem(scene, id);
        return item && !std::get_if<Part>(item);
    });
    const std::vector<Id> particles = particlesOf(scene, meant);
    Copier copier(scene.nextId);
    std::size_t end = scene.items.size();
    for (const Motion& motion : motions) {
        copier.begin();
        addCopy(copies, copier, scene, ids, particles, motion, PanelWinding::Kept, end);
    }
    std::sort(copies.ids.begin(), copies.ids.end());
    return copies;
}

Copies linearArray(const Scene& scene, const std::vector<Id>& ids, int count, const Vec3& step)
{
    std::vector<Motion> motions;
    for (int i = 1; i < count; ++i)
        motions.push_back(shifted(i * step));
    return duplicated(scene, ids, motions, Message("Array in a row"));
}

Copies radialArray(const Scene& scene, const std::vector<Id>& ids, int count, const Vec3& pivot,
                   const Vec3& axis, double angle)
{
    const bool closes = std::abs(std::abs(angle) - 2.0 * std::numbers::pi) < 1e-9;
    const double step = angle / std::max(closes ? count : count - 1, 1);
    std::vector<Motion> motions;
    for (int i = 1; i < count; ++i)
        motions.push_back(turned(pivot, axis, i * step));
    return duplicated(scene, ids, motions, Message("Array in a ring"));
}

Copies mirrored(const Scene& scene, const std::vector<Id>& selected, const Vec3& point, int axis,
                double tolerance)
{
    Copies copies{{Message("Mirror"), {}}, {}};
    const std::vector<Id> ids = sortedOf(selected);
    const std::vector<Id> particles = particlesOf(scene, ids);
    Motion motion;
    motion.map.linear()(axis, axis) = -1.0;
    motion.map.translation()[axis] = 2.0 * point[axis];

    Copier copier(scene.nextId);
    SetValues onPlane{&propertyOf<&Particle::position>(), {}, {}};
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& row : part.particles) {
            const double away = row.position[axis] - point[axis];
            if (std::abs(away) > tolerance || !isIn(particles, row.id))
                continue;
            copier.share(row.id);
            if (away == 0.0)
                continue;
            Vec3 place = row.position;
            place[axis] = point[axis];
            onPlane.targets.push_back(row.id);
            onPlane.values.emplace_back(place);
        }
    });
    if (!onPlane.targets.empty())
        copies.edit.changes.emplace_back(std::move(onPlane));
    // a mirrored part stays one part: its halves hang together
    std::vector<Id> plain = ids;
    std::erase_if(plain, [&](Id id) {
        const Item* item = findItem(scene, id);
        return item && !std::get_if<Collider>(item);
    });
    std::size_t end = scene.items.size();
    addCopy(copies, copier, scene, plain, particles, motion, PanelWinding::Turned, end);
    for (const Entry& entry : scene.items)
        if (const Group* group = std::get_if<Group>(&entry.item)) {
            std::vector<Id> members = group->members;
            for (const Id id : group->members)
                if (copier.isCopied(id))
                    members.push_back(copier(id));
            if (members.size() > group->members.size())
                copies.edit.changes.emplace_back(SetValues{
                    &propertyOf<&Group::members>(), {entry.id}, {sortedOf(std::move(members))}});
        }
    std::sort(copies.ids.begin(), copies.ids.end());
    return copies;
}

// --- from scene to scene -----------------------------------------------------------------------

Scene excerpt(const Scene& scene, const std::vector<Id>& selected)
{
    const std::vector<Id> ids = sortedOf(selected);
    std::vector<Id> meant = ids;
    std::erase_if(meant, [&](Id id) {
        const Item* item = findItem(scene, id);
        return item && !std::get_if<Part>(item);
    });
    const std::vector<Id> particles = particlesOf(scene, meant);
    Scene some;
    some.nextId = scene.nextId;
    some.folder = scene.folder;
    KeyIndex kept(std::size_t(scene.nextId)); // elements and items that come along
    const auto keep = [&](Id id) { kept.add(std::uint32_t(id), 1); };
    forEachPart(scene, [&](Id id, const Part& part) {
        Part rows = rowsAmong(part, particles);
        if (!hasRows(rows) && !isIn(ids, id))
            return;
        keep(id);
        for (const Particle& row : rows.particles)
            keep(row.id);
        for (const Link& row : rows.links) {
            keep(row.id);
            keep(row.material);
        }
        for (const Panel& row : rows.panels) {
            keep(row.id);
            keep(row.material);
        }
        some.items.push_back({id, std::move(rows)});
    });
    for (const Entry& entry : scene.items)
        if (!std::get_if<Part>(&entry.item) && isIn(ids, entry.id))
            keep(entry.id);
    const auto isKept = [&](Id id) { return kept(std::uint32_t(id)) != KeyIndex::none; };
    for (const Entry& entry : scene.items) {
        if (std::get_if<Part>(&entry.item) || !isKept(entry.id))
            continue;
        Item item = entry.item;
        if (Group* group = std::get_if<Group>(&item))
            std::erase_if(group->members, [&](Id id) { return !isKept(id); });
        if (Control* control = std::get_if<Control>(&item))
            std::erase_if(control->targets, [&](Id id) { return !isKept(id); });
        if (Probe* probe = std::get_if<Probe>(&item)) {
            probe->target = isKept(probe->target) ? probe->target : noId;
            probe->from = isKept(probe->from) ? probe->from : noId;
        }
        if (Plot* plot = std::get_if<Plot>(&item)) {
            std::erase_if(plot->probes, [&](Id id) { return !isKept(id); });
            plot->against = isKept(plot->against) ? plot->against : noId;
        }
        some.items.push_back({entry.id, std::move(item)});
    }
    return some;
}

Copies pasted(const Scene& scene, const Scene& fragment)
{
    Copies copies{{Message("Paste"), {}}, {}};
    Copier copier(scene.nextId);
    std::size_t end = scene.items.size();
    const auto add = [&](Entry entry) {
        copies.edit.changes.emplace_back(AddItem{end++, std::move(entry)});
    };
    // materials first: links and panels refer to them
    for (const Entry& entry : fragment.items) {
        const Material* material = std::get_if<Material>(&entry.item);
        if (!material)
            continue;
        const auto same = std::ranges::find_if(scene.items, [&](const Entry& other) {
            const Material* held = std::get_if<Material>(&other.item);
            return held && *held == *material;
        });
        if (same != scene.items.end())
            copier.use(entry.id, same->id);
        else
            add({copier.take(entry.id), entry.item});
    }
    for (const Entry& entry : fragment.items)
        if (std::get_if<Part>(&entry.item)) {
            add(wholePart(copier, entry, {}, PanelWinding::Kept));
            copies.ids.push_back(copier(entry.id));
        }
    for (const Entry& entry : fragment.items)
        if (!std::get_if<Part>(&entry.item) && !std::get_if<Material>(&entry.item)) {
            const Item item = copier.itemOf(entry.item, {});
            add({copier.take(entry.id), item});
            copies.ids.push_back(copier(entry.id));
        }
    std::sort(copies.ids.begin(), copies.ids.end());
    return copies;
}

} // namespace ripstop
