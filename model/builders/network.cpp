// Three groups of functions in the order of the header: items under fresh ids; Network, whose
// calls append rows to one part and derive rest lengths from the places; and Lattice, which
// numbers the nodes of a triangle row by row from the tip and lists its edges, cells and borders
// from these numbers alone.
#include "builders/network.h"

#include "check/step_check.h"
#include "derived/flat_panel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace ripstop {

Id addItem(Scene& scene, Item item)
{
    const Id id = takeId(scene);
    scene.items.push_back({id, std::move(item)});
    return id;
}

Id addGround(Scene& scene)
{
    Collider ground;
    ground.name = "ground";
    return addItem(scene, ground);
}

Id addGroup(Scene& scene, std::string name, std::vector<Id> members)
{
    if (members.empty())
        return noId;
    return addItem(scene, Group{std::move(name), std::move(members)});
}

Id addWind(Scene& scene, const Vec3& velocity) { return addItem(scene, Wind{"wind", velocity}); }

Id addProbe(Scene& scene, std::string name, Quantity quantity, Id target, Id from)
{
    Probe probe;
    probe.name = std::move(name);
    probe.quantity = quantity;
    probe.target = target;
    probe.from = from;
    return addItem(scene, std::move(probe));
}

void takeShortSubsteps(Scene& scene)
{
    if (const std::optional<StepLimit> limit = stepLimit(scene))
        scene.settings.substeps = std::max(4, substepsWithin(*limit, scene.settings));
}

Network::Network(Scene& scene, std::string name)
    : m_scene(scene)
{
    m_part.name = std::move(name);
}

Id Network::particle(const Vec3& position, double mass)
{
    Particle particle;
    particle.id = takeId(m_scene);
    particle.position = position;
    particle.mass = mass;
    m_part.particles.push_back(particle);
    return particle.id;
}

Id Network::rod(Id from, Id to, Id material, Resists resists)
{
    Link link;
    link.id = takeId(m_scene);
    link.from = from;
    link.to = to;
    link.material = material;
    link.resists = resists;
    link.restLength = (position(to) - position(from)).norm();
    m_part.links.push_back(link);
    return link.id;
}

Id Network::spring(Id from, Id to, Id material)
{
    const Id id = rod(from, to, material);
    m_part.links.back().kind = LinkKind::Spring;
    return id;
}

Id Network::panel(Id a, Id b, Id c, Id material)
{
    const Id id = takeId(m_scene);
    m_part.panels.push_back({id, a, b, c, material});
    return id;
}

void Network::asFabric(const FabricStrip& strip)
{
    m_part.links.back().role = strip.role;
    m_part.links.back().width = strip.width;
    m_part.links.back().cellAspect = strip.cellAspect;
}

void Network::texture(Id particle, double u, double v)
{
    row(particle).textureU = u;
    row(particle).textureV = v;
}

void Network::addFabricMass(double density, Id material)
{
    for (const Panel& panel : m_part.panels) {
        if (material != noId && panel.material != material)
            continue;
        const Vec3 ab = position(panel.b) - position(panel.a);
        const Vec3 ac = position(panel.c) - position(panel.a);
        const double share = density * 0.5 * ab.cross(ac).norm() / 3.0;
        for (const Id corner : {panel.a, panel.b, panel.c})
            row(corner).mass += share;
    }
}

Link* Network::linkBetween(Id a, Id b)
{
    const auto found = std::ranges::find_if(m_part.links, [&](const Link& link) {
        return (link.from == a && link.to == b) || (link.from == b && link.to == a);
    });
    return found == m_part.links.end() ? nullptr : &*found;
}

double Network::lengthOf(Id material) const
{
    double length = 0.0;
    for (const Link& link : m_part.links)
        if (link.material == material)
            length += link.restLength;
    return length;
}

void Network::addLinkMass(Id material, double density)
{
    for (const Link& link : m_part.links)
        if (link.material == material)
            for (const Id end : {link.from, link.to})
                row(end).mass += 0.5 * density * link.restLength;
}

void Network::carryByPanels()
{
    m_part.carrier = FabricKind::Panels;
    for (Panel& panel : m_part.panels)
        layFlat(panel, row(panel.a), row(panel.b), row(panel.c));
}

void Network::carryByPanels(std::span<const Vec3> warps, double turn)
{
    m_part.carrier = FabricKind::Panels;
    for (std::size_t i = 0; i < m_part.panels.size(); ++i) {
        Panel& panel = m_part.panels[i];
        layFlat(panel, position(panel.a), position(panel.b), position(panel.c), warps[i]);
        panel.grain = turnedGrain(panel.grain, turn);
    }
}

void Network::carryByPanels(const std::function<Vec3(const Vec3&)>& warp)
{
    std::vector<Vec3> warps;
    for (const Panel& panel : m_part.panels)
        warps.push_back(warp((position(panel.a) + position(panel.b) + position(panel.c)) / 3.0));
    carryByPanels(warps);
}

void Network::dropLinks(const std::vector<Id>& materials)
{
    std::erase_if(m_part.links, [&](const Link& link) {
        return std::ranges::find(materials, link.material) != materials.end();
    });
}

void Network::shareMass(Id apart)
{
    double mass = 0.0;
    double count = 0.0;
    for (const Particle& particle : m_part.particles)
        if (particle.id != apart) {
            mass += particle.mass;
            count += 1.0;
        }
    for (Particle& particle : m_part.particles)
        if (particle.id != apart)
            particle.mass = mass / count;
}

std::vector<Id> Network::line(Id from, Id to, int count, double mass, Id material, Resists resists)
{
    const Vec3 start = position(from);
    const Vec3 whole = position(to) - start;
    std::vector<Id> nodes{from};
    for (int i = 1; i < count; ++i)
        nodes.push_back(particle(start + (double(i) / count) * whole));
    nodes.push_back(to);
    for (int i = 0; i < count; ++i) {
        rod(nodes[i], nodes[i + 1], material, resists);
        row(nodes[i]).mass += 0.5 * mass / count;
        row(nodes[i + 1]).mass += 0.5 * mass / count;
    }
    return nodes;
}

std::vector<Id> Network::spokes(Id hub, const std::vector<Id>& nodes, Id material)
{
    std::vector<Id> rods;
    for (const Id node : nodes)
        rods.push_back(rod(hub, node, material));
    return rods;
}

void Network::place(const Eigen::Matrix3d& turn, const Vec3& shift, const Vec3& velocity)
{
    for (Particle& particle : m_part.particles) {
        particle.position = turn * particle.position + shift;
        particle.velocity = velocity;
    }
}

Id Network::finish(std::string builder, std::map<std::string, double> parameters)
{
    m_part.builder = std::move(builder);
    m_part.parameters = std::move(parameters);
    return addItem(m_scene, std::exchange(m_part, {}));
}

Lattice::Lattice(int segments, const std::function<Id(int, int)>& node)
    : m_segments(segments)
{
    for (int row = 0; row <= segments; ++row)
        for (int column = 0; column <= row; ++column)
            m_nodes.push_back(node(row, column));
}

Id Lattice::at(int row, int column) const { return m_nodes[row * (row + 1) / 2 + column]; }

std::vector<Lattice::Edge> Lattice::edges() const
{
    std::vector<Edge> edges;
    for (int row = 0; row < m_segments; ++row)
        for (int column = 0; column <= row; ++column) {
            const Id node = at(row, column);
            const Id left = at(row + 1, column);
            const Id right = at(row + 1, column + 1);
            edges.push_back({node, left, row, Edge::Sort::Left, column == 0});
            edges.push_back({node, right, row, Edge::Sort::Right, column == row});
            edges.push_back({left, right, row + 1, Edge::Sort::Row, false});
        }
    return edges;
}

std::vector<Lattice::Cell> Lattice::cells() const
{
    std::vector<Cell> cells;
    for (int row = 0; row < m_segments; ++row)
        for (int column = 0; column <= row; ++column) {
            const Id node = at(row, column);
            const Id right = at(row + 1, column + 1);
            cells.push_back({node, at(row + 1, column), right, row, 2 * column});
            if (column < row)
                cells.push_back({node, right, at(row, column + 1), row, 2 * column + 1});
        }
    return cells;
}

std::vector<Id> Lattice::sides() const
{
    std::vector<Id> nodes{at(0, 0)};
    for (int row = 1; row <= m_segments; ++row) {
        nodes.push_back(at(row, 0));
        nodes.push_back(at(row, row));
    }
    return nodes;
}

std::vector<Id> Lattice::perimeter() const
{
    std::vector<Id> nodes = sides();
    for (int column = 1; column < m_segments; ++column)
        nodes.push_back(at(m_segments, column));
    return nodes;
}

std::vector<Id> Lattice::median() const
{
    std::vector<Id> nodes;
    for (int row = 2; row <= m_segments; row += 2)
        nodes.push_back(at(row, row / 2));
    return nodes;
}

} // namespace ripstop
