// What a selection moves, found in three passes: particlesOf() resolves ids to particles, where a
// part means its own alone; movableOf() copies their places, masses and guides, and sorts links
// into those with both ends among them and those with one; colliders are those selected and those
// that a selected control moves. Pivots and principal axes are computed from that copy.
#include "shaping/movable.h"

#include "base/key_index.h"
#include "scene/property.h"
#include "select/elements.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int itself = 1; // in an index: the thing itself is meant

// The principal axes of the places of all particles about their middle; eigenvalues ascend.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(const Movable& movable)
{
    const double count = double(movable.position.size());
    Vec3 mean = Vec3::Zero();
    for (const Vec3& place : movable.position)
        mean += place / count;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& place : movable.position)
        spread += (place - mean) * (place - mean).transpose() / count;
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread);
}

} // namespace

std::vector<Id> particlesOf(const Scene& scene, const std::vector<Id>& ids)
{
    // a part means its particles, and not those of others that its links lead to
    std::vector<Id> others = ids;
    std::vector<const Part*> parts;
    forEachPart(scene, [&](Id id, const Part& part) {
        if (std::erase(others, id) > 0)
            parts.push_back(&part);
    });
    const Elements elements = sortedElements(scene, others);
    std::vector<Id> found;
    KeyIndex seen(std::size_t(scene.nextId));
    const auto add = [&](Id id) {
        if (seen.add(std::uint32_t(id), itself))
            found.push_back(id);
    };
    for (const Part* part : parts)
        for (const Particle& row : part->particles)
            add(row.id);
    for (const Particle* row : elements.particles)
        add(row->id);
    for (const Link* row : elements.links) {
        add(row->from);
        add(row->to);
    }
    for (const Panel* row : elements.panels) {
        add(row->a);
        add(row->b);
        add(row->c);
    }
    if (!std::is_sorted(found.begin(), found.end()))
        std::sort(found.begin(), found.end());
    return found;
}

Movable movableOf(const Scene& scene, const std::vector<Id>& ids, Ties ties)
{
    Movable movable;
    const std::vector<Id> wanted = particlesOf(scene, ids);
    KeyIndex wantedIndex(std::size_t(scene.nextId));
    for (const Id id : wanted)
        wantedIndex.add(std::uint32_t(id), itself);
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
        if (row->guide != Guide::None)
            movable.guides.push_back({row->id, row->guide, row->guideAxis});
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
    // those that are selected, and those that a selected control moves
    const std::vector<Id> elements = elementsOf(scene, ids);
    for (const Entry& entry : scene.items)
        if (const Collider* collider = std::get_if<Collider>(&entry.item))
            if (std::find(ids.begin(), ids.end(), entry.id) != ids.end()
                || std::binary_search(elements.begin(), elements.end(), entry.id))
                movable.colliders.push_back({entry.id, *collider});
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

Vec3 spreadOf(const Movable& movable)
{
    const Vec3 squares = principal(movable).eigenvalues().reverse();
    return squares.cwiseMax(0.0).cwiseSqrt();
}

Eigen::Matrix3d ownAxes(const Movable& movable)
{
    if (movable.position.size() < 2)
        return Eigen::Matrix3d::Identity();
    const auto solver = principal(movable); // ascending
    Eigen::Matrix3d axes;
    for (int i = 0; i < 2; ++i) {
        Vec3 axis = solver.eigenvectors().col(2 - i);
        Eigen::Index largest = 0;
        axis.cwiseAbs().maxCoeff(&largest);
        axes.col(i) = axis[largest] < 0.0 ? Vec3(-axis) : axis;
    }
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

} // namespace ripstop
