// A drawing in three parts: orders of particles, where Neighbours walks along links and panel
// sides as long as they form one line or ring; the drawing calls, which collect new items and rows
// by part, and refuse double links and panels; and finish(), which makes one edit of items, rows
// and masses.
// What is linked to a particle is looked up when it is first asked for, so that one click on a
// large design does not sort all links.
#include "shaping/drawing.h"

#include "scene/particle_of.h"
#include "select/elements.h"
#include "shaping/movable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

std::array<Id, 3> tripleOf(Id a, Id b, Id c)
{
    std::array<Id, 3> triple{a, b, c};
    std::ranges::sort(triple);
    return triple;
}

// Which of some particles are tied to each other.
class Neighbours
{
public:
    Neighbours(const Scene& scene, const std::vector<Id>& particles)
    {
        for (const Id id : particles)
            m_next[id];
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Link& link : part.links)
                add(link.from, link.to);
        });
    }

    void addPanelSides(const Scene& scene)
    {
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Panel& panel : part.panels)
                for (const auto& [a, b] : {std::pair{panel.a, panel.b}, std::pair{panel.b, panel.c},
                                           std::pair{panel.c, panel.a}})
                    add(a, b);
        });
    }

    // One line or ring through all, from its lower end; empty when they do not form one.
    std::vector<Id> walk(bool asRing) const
    {
        Id start = noId;
        std::size_t ends = 0;
        for (const auto& [id, near] : m_next) {
            if (near.empty() || near.size() > 2)
                return {};
            ends += near.size() == 1;
            if (start == noId && (asRing || near.size() == 1))
                start = id;
        }
        if (start == noId || ends != (asRing ? 0U : 2U))
            return {};
        std::vector<Id> path{start};
        for (Id before = noId, at = start;;) {
            const auto& near = m_next.at(at);
            const auto on = std::ranges::find_if(near, [&](Id id) { return id != before; });
            if (on == near.end() || *on == start)
                break;
            before = std::exchange(at, *on);
            path.push_back(at);
        }
        return path.size() == m_next.size() ? path : std::vector<Id>();
    }

private:
    void add(Id a, Id b)
    {
        const auto from = m_next.find(a);
        const auto to = m_next.find(b);
        if (a == b || from == m_next.end() || to == m_next.end())
            return;
        from->second.insert(b);
        to->second.insert(a);
    }

    std::map<Id, std::set<Id>> m_next;
};

// The material that most elements of a table have that touch the particles;
// noId without one.
template <typename Rows, typename Touches>
Id commonest(const Scene& scene, Rows Part::*rows, Touches touches)
{
    std::map<Id, int> counts;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const auto& row : part.*rows)
            if (touches(row))
                ++counts[row.material];
    });
    const auto most = std::ranges::max_element(
        counts, [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? noId : most->first;
}

} // namespace

Id linkMaterialAt(const Scene& scene, const std::vector<Id>& particles)
{
    return commonest(scene, &Part::links, [&](const Link& link) {
        return std::ranges::binary_search(particles, link.from)
               || std::ranges::binary_search(particles, link.to);
    });
}

Id panelMaterialAt(const Scene& scene, const std::vector<Id>& particles)
{
    return commonest(scene, &Part::panels, [&](const Panel& panel) {
        return std::ranges::any_of(std::array{panel.a, panel.b, panel.c}, [&](Id corner) {
            return std::ranges::binary_search(particles, corner);
        });
    });
}

Drawing::Drawing(const Scene& scene)
    : m_scene(scene)
    , m_next(scene.nextId)
{}

// The particles linked to this one, in the scene and by this drawing. It takes one pass over the
// links for each particle that is asked about, so that a click on a large design does not sort them
// all.
std::set<Id>& Drawing::linkedTo(Id particle)
{
    const auto [place, isNew] = m_linkedTo.try_emplace(particle);
    std::set<Id>& linked = place->second;
    if (isNew && particle < m_scene.nextId)
        forEachPart(m_scene, [&](Id, const Part& part) {
            for (const Link& link : part.links) {
                if (link.from == particle)
                    linked.insert(link.to);
                if (link.to == particle)
                    linked.insert(link.from);
            }
        });
    return linked;
}

// The other corners of the panels of which it is the lowest, in ascending order.
std::set<std::array<Id, 2>>& Drawing::coveredBy(Id lowest)
{
    const auto [place, isNew] = m_coveredBy.try_emplace(lowest);
    auto& covered = place->second;
    if (isNew && lowest < m_scene.nextId)
        forEachPart(m_scene, [&](Id, const Part& part) {
            for (const Panel& panel : part.panels)
                if (panel.a == lowest || panel.b == lowest || panel.c == lowest)
                    if (const auto corners = tripleOf(panel.a, panel.b, panel.c);
                        corners[0] == lowest)
                        covered.insert({corners[1], corners[2]});
        });
    return covered;
}

Id Drawing::fresh() { return std::exchange(m_next, Id{std::uint32_t(m_next) + 1}); }

Id Drawing::material(Material material)
{
    const Id id = fresh();
    m_items.push_back({m_scene.items.size() + m_items.size(), {id, std::move(material)}});
    return id;
}

Material plainCord(std::string name)
{
    Material plain;
    plain.name = std::move(name);
    plain.linearDensity = 0.0;
    return plain;
}

Material plainCloth(std::string name)
{
    Material plain;
    plain.name = std::move(name);
    plain.arealDensity = 0.0;
    return plain;
}

Id Drawing::part(const std::string& name)
{
    Part part;
    part.name = name;
    const Id id = fresh();
    m_items.push_back({m_scene.items.size() + m_items.size(), {id, std::move(part)}});
    return id;
}

Id Drawing::group(const std::string& name, std::vector<Id> members)
{
    const Id id = fresh();
    m_items.push_back(
        {m_scene.items.size() + m_items.size(), {id, Group{name, std::move(members)}}});
    return id;
}

AddRows& Drawing::rowsOf(Id part)
{
    AddRows& rows = m_rows[part];
    rows.part = part;
    return rows;
}

Id Drawing::particle(Id part, const Vec3& position, double mass)
{
    Particle row;
    row.id = fresh();
    row.position = position;
    row.mass = mass;
    rowsOf(part).particles.push_back(row);
    m_partOf[row.id] = part;
    m_made.push_back(row.id);
    return row.id;
}

double Drawing::densityOf(Id material, std::optional<double> Material::*density) const
{
    const Material* const known = findItem<Material>(m_scene, material);
    return known ? (known->*density).value_or(0.0) : 0.0;
}

Id Drawing::link(Id from, Id to, const LinkStroke& stroke)
{
    return tie(from, to, (position(to) - position(from)).norm(), stroke);
}

Id Drawing::tie(Id from, Id to, double length, const LinkStroke& stroke)
{
    const auto [low, high] = std::minmax(from, to);
    if (from == to || length == 0.0 || !linkedTo(low).insert(high).second)
        return noId;
    Link row;
    row.id = fresh();
    row.from = from;
    row.to = to;
    row.material = stroke.material;
    row.kind = stroke.kind;
    row.resists = stroke.resists;
    row.restLength = length;
    const Id part = partOf(from);
    rowsOf(part).links.push_back(row);
    m_partOf[row.id] = part;
    m_made.push_back(row.id);
    const double mass = densityOf(stroke.material, &Material::linearDensity) * length;
    for (const Id end : {from, to})
        addMass(end, 0.5 * mass);
    return row.id;
}

std::vector<Id> Drawing::rope(Id from, Id to, int count, double mass, double slack,
                              const LinkStroke& stroke)
{
    const Vec3 start = position(from);
    const Vec3 step = (position(to) - start) / count;
    const Id part = partOf(from);
    if (densityOf(stroke.material, &Material::linearDensity) > 0.0)
        mass = 0.0; // its links bring their own
    std::vector<Id> nodes{from};
    for (int i = 1; i < count; ++i)
        nodes.push_back(particle(part, start + i * step, mass / count));
    nodes.push_back(to);
    for (std::size_t i = 1; i < nodes.size(); ++i)
        tie(nodes[i - 1], nodes[i],
            (position(nodes[i]) - position(nodes[i - 1])).norm() * (1.0 + slack), stroke);
    for (const Id end : {from, to})
        addMass(end, 0.5 * mass / count);
    return nodes;
}

Id Drawing::panel(Id a, Id b, Id c, Id material)
{
    const auto [low, middle, high] = tripleOf(a, b, c);
    if (a == b || b == c || c == a || !coveredBy(low).insert({middle, high}).second)
        return noId;
    const Id part = partOf(a);
    const Id id = fresh();
    rowsOf(part).panels.push_back({id, a, b, c, material});
    m_partOf[id] = part;
    m_made.push_back(id);
    const double area = 0.5 * (position(b) - position(a)).cross(position(c) - position(a)).norm();
    const double mass = densityOf(material, &Material::arealDensity) * area;
    for (const Id corner : {a, b, c})
        addMass(corner, mass / 3.0);
    return id;
}

Particle* Drawing::drawn(Id particle)
{
    const auto part = m_partOf.find(particle);
    return part == m_partOf.end() ? nullptr : findRow(m_rows.at(part->second).particles, particle);
}

const Particle* Drawing::row(Id particle) const
{
    const Particle* drawn = const_cast<Drawing*>(this)->drawn(particle);
    return drawn ? drawn : particleOf(m_scene, particle);
}

void Drawing::addMass(Id particle, double mass)
{
    if (Particle* row = drawn(particle))
        row->mass += mass;
    else if (mass != 0.0)
        m_mass.try_emplace(particle, particleOf(m_scene, particle)->mass).first->second += mass;
}

Vec3 Drawing::position(Id particle) const { return row(particle)->position; }

Id Drawing::partOf(Id element) const
{
    if (const auto drawn = m_partOf.find(element); drawn != m_partOf.end())
        return drawn->second;
    Id found = noId;
    forEachPart(m_scene, [&](Id id, const Part& part) {
        if (findRow(part.particles, element) || findRow(part.links, element)
            || findRow(part.panels, element))
            found = id;
    });
    return found;
}

Edit Drawing::finish(Message label)
{
    Edit edit{std::move(label), {}};
    for (AddItem& item : m_items)
        edit.changes.emplace_back(std::move(item));
    for (auto& [part, rows] : m_rows)
        edit.changes.emplace_back(std::move(rows));
    SetValues masses{&propertyOf<&Particle::mass>(), {}, {}};
    for (const auto& [id, mass] : m_mass) {
        masses.targets.push_back(id);
        masses.values.emplace_back(mass);
    }
    if (!masses.targets.empty())
        edit.changes.emplace_back(std::move(masses));
    return edit;
}

std::vector<Id> inLine(const Scene& scene, const std::vector<Id>& particles)
{
    Neighbours ties(scene, particles);
    if (std::vector<Id> line = ties.walk(false); !line.empty())
        return line;
    ties.addPanelSides(scene);
    for (const bool isRing : {false, true})
        if (std::vector<Id> line = ties.walk(isRing); !line.empty())
            return line;
    const Movable movable = movableOf(scene, particles, Ties::Left);
    const Vec3 along = ownAxes(movable).col(0);
    std::vector<std::pair<double, Id>> places;
    for (std::size_t i = 0; i < movable.particles.size(); ++i)
        places.emplace_back(movable.position[i].dot(along), movable.particles[i]);
    std::ranges::sort(places);
    std::vector<Id> line;
    for (const auto& [place, id] : places)
        line.push_back(id);
    return line;
}

std::vector<Id> inRing(const Scene& scene, const std::vector<Id>& particles)
{
    Neighbours ties(scene, particles);
    if (std::vector<Id> ring = ties.walk(true); !ring.empty())
        return ring;
    ties.addPanelSides(scene);
    if (std::vector<Id> ring = ties.walk(true); !ring.empty())
        return ring;
    const Movable movable = movableOf(scene, particles, Ties::Left);
    const Eigen::Matrix3d axes = ownAxes(movable);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : movable.position)
        middle += place / double(movable.position.size());
    std::vector<std::pair<double, Id>> angles;
    for (std::size_t i = 0; i < movable.particles.size(); ++i) {
        const Vec3 arm = axes.transpose() * (movable.position[i] - middle);
        angles.emplace_back(std::atan2(arm.y(), arm.x()), movable.particles[i]);
    }
    std::ranges::sort(angles);
    std::vector<Id> ring;
    for (const auto& [angle, id] : angles)
        ring.push_back(id);
    return ring;
}

} // namespace ripstop
