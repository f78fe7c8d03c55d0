#include "author/movable.h"

#include "base/key_index.h"
#include "scene/property.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int whole = 1; // in an index: the thing itself is meant

struct Meant
{
    KeyIndex elements;              // that are named, by themselves or by an item
    std::vector<Id> materials;      // whose links and panels are meant
    std::vector<Id> parts;          // whose particles are meant
    std::vector<Id> colliders = {}; // ascending

    void add(const std::vector<Id>& ids)
    {
        for (const Id id : ids)
            elements.add(std::uint32_t(id), whole);
    }
    bool names(Id id) const { return elements(std::uint32_t(id)) != KeyIndex::none; }
};

Meant meantBy(const Scene& scene, const std::vector<Id>& ids)
{
    Meant meant{KeyIndex(std::size_t(scene.nextId)), {}, {}};
    meant.add(ids);
    for (const Entry& entry : scene.items) {
        if (!meant.names(entry.id))
            continue;
        if (std::get_if<Part>(&entry.item))
            meant.parts.push_back(entry.id);
        else if (std::get_if<Material>(&entry.item))
            meant.materials.push_back(entry.id);
        else if (std::get_if<Collider>(&entry.item))
            meant.colliders.push_back(entry.id);
        else if (const Group* group = std::get_if<Group>(&entry.item))
            meant.add(group->members);
        else if (const Control* control = std::get_if<Control>(&entry.item))
            meant.add(control->targets);
        else if (const Probe* probe = std::get_if<Probe>(&entry.item))
            meant.add({probe->target, probe->from});
    }
    return meant;
}

} // namespace

std::vector<Id> particlesOf(const Scene& scene, const std::vector<Id>& ids)
{
    const Meant meant = meantBy(scene, ids);
    const auto has = [](const std::vector<Id>& list, Id id) {
        return std::find(list.begin(), list.end(), id) != list.end();
    };
    std::vector<Id> found;
    forEachPart(scene, [&](Id id, const Part& part) {
        const bool all = has(meant.parts, id);
        for (const Particle& row : part.particles)
            if (all || meant.names(row.id))
                found.push_back(row.id);
        for (const Link& row : part.links)
            if (meant.names(row.id) || has(meant.materials, row.material))
                found.insert(found.end(), {row.from, row.to});
        for (const Panel& row : part.panels)
            if (meant.names(row.id) || has(meant.materials, row.material))
                found.insert(found.end(), {row.a, row.b, row.c});
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

Movable movableOf(const Scene& scene, const std::vector<Id>& ids, Ties ties)
{
    Movable movable;
    const std::vector<Id> wanted = particlesOf(scene, ids);
    KeyIndex wantedIndex(std::size_t(scene.nextId));
    for (const Id id : wanted)
        wantedIndex.add(std::uint32_t(id), whole);
    KeyIndex place(std::size_t(scene.nextId));
    KeyIndex everyPlace(std::size_t(scene.nextId)); // of all particles, in the order of the scene
    std::vector<Vec3> everyPosition;
    std::vector<const Particle*> rows;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& row : part.particles) {
            everyPlace.add(std::uint32_t(row.id), int(everyPosition.size()));
            everyPosition.push_back(row.position);
            if (wantedIndex(std::uint32_t(row.id)) != KeyIndex::none)
                rows.push_back(&row);
        }
    });
    std::sort(rows.begin(), rows.end(),
              [](const Particle* a, const Particle* b) { return a->id < b->id; });
    for (const Particle* row : rows) {
        place.add(std::uint32_t(row->id), int(movable.particles.size()));
        movable.particles.push_back(row->id);
        movable.position.push_back(row->position);
        movable.mass.push_back(row->mass);
    }
    forEachPart(scene, [&](Id, const Part& part) {
        if (ties == Ties::Left)
            return;
        for (const Link& row : part.links) {
            const int from = place(std::uint32_t(row.from));
            const int to = place(std::uint32_t(row.to));
            if (from == KeyIndex::none && to == KeyIndex::none)
                continue;
            const int a = everyPlace(std::uint32_t(row.from));
            const int b = everyPlace(std::uint32_t(row.to));
            if (a == KeyIndex::none || b == KeyIndex::none)
                continue; // the problem list says so
            const bool crosses = from == KeyIndex::none || to == KeyIndex::none;
            (crosses ? movable.crossing : movable.inside)
                .push_back({row.id, from, to, everyPosition[std::size_t(a)],
                            everyPosition[std::size_t(b)], row.restLength});
        }
    });
    for (const Id id : meantBy(scene, ids).colliders)
        movable.colliders.push_back({id, *findItem<Collider>(scene, id)});
    return movable;
}

Vec3 pivotOf(const Scene& scene, const Movable& movable, Pivot pivot, Id particle)
{
    if (movable.isEmpty())
        return Vec3::Zero();
    if (pivot == Pivot::Particle)
        if (const auto ref = find(scene, particle))
            if (const auto* row = std::get_if<const Particle*>(&*ref))
                return (*row)->position;

    std::vector<Vec3> places = movable.position;
    for (const MovableCollider& one : movable.colliders)
        places.push_back(one.collider.position);
    if (pivot == Pivot::Box) {
        Eigen::AlignedBox3d box;
        for (const Vec3& place : places)
            box.extend(place);
        return box.center();
    }
    Vec3 moment = Vec3::Zero();
    double mass = 0.0;
    for (std::size_t i = 0; i < movable.mass.size(); ++i) {
        moment += movable.mass[i] * movable.position[i];
        mass += movable.mass[i];
    }
    if (pivot == Pivot::Mass && mass > 0.0)
        return moment / mass;
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : places)
        sum += place;
    return sum / double(places.size());
}

} // namespace ripstop
