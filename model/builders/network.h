// Networks: the bricks that builders lay.
//
// A Network grows one part of a scene. Rest lengths follow from where the particles are, so a
// network is free of load as it is built; ids come from the scene in the order of the calls, which
// keeps every table in ascending order.
#pragma once

#include "derived/link_stiffness.h"
#include "scene/scene.h"

#include <functional>
#include <span>
#include <vector>

namespace ripstop {

// Appends an item under a fresh id; no group where there is nothing for it.
Id addItem(Scene& scene, Item item);
Id addGround(Scene& scene); // the plane y = 0
Id addGroup(Scene& scene, std::string name, std::vector<Id> members);
Id addWind(Scene& scene, const Vec3& velocity); // m/s
Id addProbe(Scene& scene, std::string name, Quantity quantity, Id target = noId, Id from = noId);

// Substeps that springs and bending of the scene are stable in, four at least.
void takeShortSubsteps(Scene& scene);

class Network
{
public:
    Network(Scene& scene, std::string name);

    Id particle(const Vec3& position, double mass = 0.0); // m, kg
    Id rod(Id from, Id to, Id material, Resists resists = Resists::Both);
    Id spring(Id from, Id to, Id material);
    Id panel(Id a, Id b, Id c, Id material);

    // Of the link laid last, m; it is under load or slack then.
    void setRestLength(double length) { m_part.links.back().restLength = length; }

    // Says of the link laid last what of a fabric it stands for.
    void asFabric(const FabricStrip& strip);

    std::span<Panel> panels() { return m_part.panels; }
    Particle& row(Id particle) { return *findRow(m_part.particles, particle); }
    void texture(Id particle, double u, double v);

    // Gives each corner of the panel its third of the fabric's mass; density in kg/m^2. Of panels
    // of one material only where that is said.
    void addFabricMass(double density, Id material = noId);

    Link* linkBetween(Id a, Id b);      // the first; null for none
    double lengthOf(Id material) const; // m, of all links of this material

    // Gives both ends of each link of this material half of what it weighs; density in kg/m.
    void addLinkMass(Id material, double density);

    // Has the panels so far carry the pull of the fabric, cut as they lie: the warp along the
    // textures' v, or along what `warp` answers for the middle of a panel, or along `warps`
    // [panels], projected onto it and turned by an angle, degrees.
    void carryByPanels();
    void carryByPanels(std::span<const Vec3> warps, double turn = 0.0);
    void carryByPanels(const std::function<Vec3(const Vec3& middle)>& warp);

    // Takes all links of these materials away.
    void dropLinks(const std::vector<Id>& materials);

    // Gives all particles so far an equal share of what they weigh together, but for `apart`, which
    // keeps its mass.
    void shareMass(Id apart = noId);

    // `count` - 1 new particles at equal steps from `from` to `to`, tied in a row; the ends are in
    // the answer. `mass` is that of the whole line, kg, shared out by length, ends included.
    std::vector<Id> line(Id from, Id to, int count, double mass, Id material, Resists resists);

    // A rod from `hub` to each of `nodes`.
    std::vector<Id> spokes(Id hub, const std::vector<Id>& nodes, Id material);

    // Turns and then moves everything, and sets everything going with one velocity, m/s.
    void place(const Eigen::Matrix3d& turn, const Vec3& shift, const Vec3& velocity);

    const Vec3& position(Id particle) const
    {
        return findRow(m_part.particles, particle)->position;
    }
    const Part& part() const { return m_part; }

    // Puts the part into the scene; the network is empty afterwards. Answers the part's id.
    Id finish(std::string builder, std::map<std::string, double> parameters);

private:
    Scene& m_scene;
    Part m_part;
};

// A triangular lattice of n segments per side: row i has i + 1 nodes, row 0 is the tip.
// (n+1)(n+2)/2 nodes, 3n(n+1)/2 edges, n^2 panels.
class Lattice
{
public:
    // `node` answers the particle of a place; it may make one or reuse one.
    Lattice(int segments, const std::function<Id(int row, int column)>& node);

    struct Edge
    {
        Id from;
        Id to;
        int row;                                   // of the end nearer to the tip, or of both
        enum class Sort { Left, Right, Row } sort; // along the left or right side, or across
        bool onSide;                               // one of the two sides that meet in the tip
    };
    struct Cell
    {
        Id a;
        Id b;
        Id c;
        int row;    // of its corner nearest to the tip
        int column; // in half steps from the left side: even ones have a corner towards the tip
    };

    int segments() const { return m_segments; }
    Id at(int row, int column) const;

    std::vector<Edge> edges() const;
    std::vector<Cell> cells() const; // all wound the same way

    std::vector<Id> sides() const;     // both sides that meet in the tip: 2n + 1 nodes
    std::vector<Id> perimeter() const; // 3n nodes
    std::vector<Id> median() const;    // nodes on the axis, without the tip: n/2

private:
    int m_segments;
    std::vector<Id> m_nodes;
};

} // namespace ripstop
