// Finds the rods for direct blocks, in the order of the header.
//
// riggings(): particlesOfLines() leaves out what is of a mesh or heavy; Groups joins the rest into
// riggings and everything else into clusters; loads and numbers of particles give the sweeps that
// each would need. frames(): Networks finds what rods join without passing a pin, and isSmall()
// prepares a solver on trial to count the products of blocks. rodsForDirect() then takes
// candidates, the slowest first, until there are enough particles. The other two ask Networks
// alone.
//
// All of it looks at the system and never at the clock, so that every machine chooses alike.
#include "constraints/direct_choice.h"

#include "constraints/block_cholesky.h"
#include "constraints/direct_solver.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <unordered_map>

namespace ripstop {
namespace {

constexpr int mostParticles = 500;
constexpr std::size_t mostProducts = 20000;
constexpr double mostProductsOfThin = 20.0; // for each particle
constexpr double manySweeps = 200.0;
constexpr double heavyLoad = 30.0;   // over the median mass
constexpr double heavyInLine = 10.0; // over the median mass of its neighbours
constexpr double alikeMasses = 5.0;
constexpr std::size_t mostTies = 8; // to other particles, in a line
constexpr double straight = 0.99;   // twice the longest side over the circumference

struct Candidate
{
    double sweeps;
    int particles; // how many of them are free
    std::vector<int> rods;
};

// Numbers for groups of particles that rods join, -1 for particles that are left out.
class Groups
{
public:
    template <typename Joins> // joins(rod) whether a rod counts
    Groups(const System& system, std::vector<std::uint8_t> member, Joins joins)
        : m_group(member.size(), -1)
    {
        std::vector<int> reached;
        for (std::size_t i = 0; i < member.size(); ++i) {
            if (!member[i] || m_group[i] >= 0)
                continue;
            m_group[i] = m_count;
            reached.assign(1, int(i));
            while (!reached.empty()) {
                const auto from = std::size_t(reached.back());
                reached.pop_back();
                for (int k = system.rodsAt.start[from]; k < system.rodsAt.start[from + 1]; ++k) {
                    const int rod = system.rodsAt.items[std::size_t(k)];
                    const Rod& r = system.rods[std::size_t(rod)];
                    const auto to = std::size_t(std::size_t(r.a) == from ? r.b : r.a);
                    if (!member[to] || m_group[to] >= 0 || !joins(rod))
                        continue;
                    m_group[to] = m_count;
                    reached.push_back(int(to));
                }
            }
            ++m_count;
        }
    }
    int count() const { return m_count; }
    int operator[](int particle) const { return m_group[std::size_t(particle)]; }

private:
    int m_count = 0;
    std::vector<int> m_group; // [particles]
};

double median(std::vector<double> values)
{
    if (values.empty())
        return 0.0;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// The particles that rods tie to each particle, in ascending order.
class Neighbours
{
public:
    explicit Neighbours(const System& system)
        : m_others(system.inverseMass.size())
    {
        for (const Rod& rod : system.rods) {
            m_others[std::size_t(rod.a)].push_back(rod.b);
            m_others[std::size_t(rod.b)].push_back(rod.a);
        }
        for (auto& others : m_others) {
            std::sort(others.begin(), others.end());
            others.erase(std::unique(others.begin(), others.end()), others.end());
        }
    }
    const std::vector<int>& operator[](int particle) const
    {
        return m_others[std::size_t(particle)];
    }
    bool areTied(int a, int b) const
    {
        const auto& others = (*this)[a];
        return std::binary_search(others.begin(), others.end(), b);
    }

private:
    std::vector<std::vector<int>> m_others; // [particles]
};

bool alike(const System& system, int a, int b)
{
    const double u = system.inverseMass[std::size_t(a)];
    const double w = system.inverseMass[std::size_t(b)];
    return u < alikeMasses * w && w < alikeMasses * u;
}

// Rest length, m, of the rod between two particles that are tied.
double lengthBetween(const System& system, int a, int b)
{
    for (int k = system.rodsAt.start[std::size_t(a)]; k < system.rodsAt.start[std::size_t(a) + 1];
         ++k) {
        const Rod& rod = system.rods[std::size_t(system.rodsAt.items[std::size_t(k)])];
        if (rod.a == b || rod.b == b)
            return rod.restLength;
    }
    return 0.0;
}

// Whether three particles that are tied to each other lie in a row, as in a line with rods to
// second neighbours against folds.
bool inRow(const System& system, int a, int b, int c)
{
    const double ab = lengthBetween(system, a, b);
    const double bc = lengthBetween(system, b, c);
    const double ca = lengthBetween(system, c, a);
    return 2.0 * std::max({ab, bc, ca}) > straight * (ab + bc + ca);
}

// Whether a rod is an edge of a mesh: of a triangle or square of rods between particles alike.
bool isInMesh(const System& system, const Neighbours& neighbours, const Rod& rod)
{
    const auto [a, b] = std::pair(rod.a, rod.b);
    if (!alike(system, a, b))
        return false;
    for (const int c : neighbours[a]) {
        if (c == b || !alike(system, a, c))
            continue;
        if (neighbours.areTied(c, b)) {
            if (!inRow(system, a, b, c))
                return true;
            continue;
        }
        for (const int d : neighbours[b])
            if (d != a && alike(system, b, d) && neighbours.areTied(c, d)
                && !neighbours.areTied(a, d))
                return true;
    }
    return false;
}

std::vector<std::uint8_t> particlesOfLines(const System& system)
{
    const std::size_t count = system.inverseMass.size();
    const Neighbours neighbours(system);
    std::vector<std::uint8_t> inLine(count, 0);
    std::vector<double> masses;
    for (std::size_t i = 0; i < count; ++i) {
        const double w = system.inverseMass[i];
        if (w == 0.0 || neighbours[int(i)].empty() || neighbours[int(i)].size() > mostTies)
            continue;
        masses.clear();
        for (const int other : neighbours[int(i)])
            if (system.inverseMass[std::size_t(other)] > 0.0)
                masses.push_back(1.0 / system.inverseMass[std::size_t(other)]);
        const bool heavy = !masses.empty() && 1.0 > heavyInLine * median(masses) * w;
        inLine[i] = !heavy;
    }
    for (const FabricPanel& panel : system.panels) {
        const auto [a, b, c] = panel.corner;
        if (alike(system, a, b) && alike(system, b, c) && alike(system, c, a))
            inLine[std::size_t(a)] = inLine[std::size_t(b)] = inLine[std::size_t(c)] = 0;
    }
    for (const Rod& rod : system.rods)
        if ((inLine[std::size_t(rod.a)] || inLine[std::size_t(rod.b)])
            && isInMesh(system, neighbours, rod))
            inLine[std::size_t(rod.a)] = inLine[std::size_t(rod.b)] = 0;
    return inLine;
}

// Clusters that a rigging ties together, and its ends in them.
struct Ties
{
    int ends = 0;
    std::vector<int> clusters;
};

// Mass of all clusters but the heaviest, kg; what is pinned is the heaviest.
double loadOf(Ties& ties, std::span<const double> mass, std::span<const std::uint8_t> pinned)
{
    auto& clusters = ties.clusters;
    std::sort(clusters.begin(), clusters.end());
    clusters.erase(std::unique(clusters.begin(), clusters.end()), clusters.end());
    double load = 0.0;
    double heaviest = 0.0;
    bool held = false;
    for (const int c : clusters) {
        if (pinned[std::size_t(c)]) {
            held = true;
            continue;
        }
        load += mass[std::size_t(c)];
        heaviest = std::max(heaviest, mass[std::size_t(c)]);
    }
    return held ? load : load - heaviest;
}

std::vector<Candidate> riggings(const System& system)
{
    const std::vector<std::uint8_t> inLine = particlesOfLines(system);
    std::vector<std::uint8_t> other(inLine.size());
    std::transform(inLine.begin(), inLine.end(), other.begin(),
                   [](std::uint8_t line) { return std::uint8_t(!line); });
    const Groups rigging(system, inLine, [&](int r) {
        const Rod& rod = system.rods[std::size_t(r)];
        return alike(system, rod.a, rod.b);
    });
    const Groups cluster(system, other, [](int) { return true; });

    std::vector<double> clusterMass(std::size_t(cluster.count()), 0.0);
    std::vector<std::uint8_t> pinned(std::size_t(cluster.count()), 0);
    std::vector<Candidate> found(std::size_t(rigging.count()));
    std::vector<double> ownMass(found.size(), 0.0);
    for (int i = 0; i < int(inLine.size()); ++i) {
        const double w = system.inverseMass[std::size_t(i)];
        if (rigging[i] >= 0) {
            ++found[std::size_t(rigging[i])].particles;
            ownMass[std::size_t(rigging[i])] += 1.0 / w;
        } else if (w > 0.0) {
            clusterMass[std::size_t(cluster[i])] += 1.0 / w;
        } else {
            pinned[std::size_t(cluster[i])] = 1;
        }
    }

    std::vector<Ties> ties(found.size());
    for (int r = 0; r < int(system.rods.size()); ++r) {
        const Rod& rod = system.rods[std::size_t(r)];
        const int mine = std::max(rigging[rod.a], rigging[rod.b]);
        if (mine < 0)
            continue;
        found[std::size_t(mine)].rods.push_back(r);
        for (const int end : {rod.a, rod.b})
            if (cluster[end] >= 0) {
                ++ties[std::size_t(mine)].ends;
                ties[std::size_t(mine)].clusters.push_back(cluster[end]);
            }
    }
    for (std::size_t g = 0; g < found.size(); ++g) {
        const double load = loadOf(ties[g], clusterMass, pinned);
        const double n = double(found[g].particles) / std::max(1, ties[g].ends - 1);
        const double mass = ownMass[g] / found[g].particles;
        found[g].sweeps = n * n / 10.0 + 2.0 * n * load / mass;
    }
    return found;
}

// Networks as a whole: what rods join without passing a pin.
class Networks
{
public:
    explicit Networks(const System& system)
        : m_system(system)
        , m_network(system, freeParticles(system), [](int) { return true; })
        , m_rods(std::size_t(m_network.count()))
        , m_masses(m_rods.size())
        , m_traits(m_rods.size())
    {
        for (int i = 0; i < int(system.inverseMass.size()); ++i)
            if (m_network[i] >= 0)
                m_masses[std::size_t(m_network[i])].push_back(1.0
                                                              / system.inverseMass[std::size_t(i)]);
        for (int r = 0; r < int(system.rods.size()); ++r) {
            if (ofRod(r) < 0)
                continue;
            const Rod& rod = system.rods[std::size_t(r)];
            m_rods[std::size_t(ofRod(r))].push_back(r);
            m_traits[std::size_t(ofRod(r))].endsInPins |=
                m_network[rod.a] < 0 || m_network[rod.b] < 0;
        }
        for (const FabricPanel& panel : system.panels) {
            const bool isPinned =
                std::ranges::any_of(panel.corner, [&](int p) { return m_network[p] < 0; });
            for (const int corner : panel.corner)
                if (m_network[corner] >= 0) {
                    Traits& traits = m_traits[std::size_t(m_network[corner])];
                    traits.hasPanels = true;
                    traits.hasPinnedPanels |= isPinned;
                }
        }
    }
    std::size_t count() const { return m_rods.size(); }
    int operator[](int particle) const { return m_network[particle]; }
    int ofRod(int rod) const
    {
        const Rod& r = m_system.rods[std::size_t(rod)];
        return std::max(m_network[r.a], m_network[r.b]);
    }
    const std::vector<int>& rods(std::size_t n) const { return m_rods[n]; }
    const std::vector<double>& masses(std::size_t n) const { return m_masses[n]; }
    bool hasPanels(std::size_t n) const { return m_traits[n].hasPanels; }
    bool hasPinnedPanels(std::size_t n) const { return m_traits[n].hasPinnedPanels; }
    bool endsInPins(std::size_t n) const { return m_traits[n].endsInPins; }

    // Those of all networks that are like this, ascending.
    template <typename IsOne> // isOne(network)
    std::vector<int> rodsOf(IsOne isOne) const
    {
        std::vector<int> rods;
        for (std::size_t n = 0; n < count(); ++n)
            if (isOne(n))
                rods.insert(rods.end(), m_rods[n].begin(), m_rods[n].end());
        std::ranges::sort(rods);
        return rods;
    }

    bool isHeavilyLoaded(std::size_t n) const
    {
        return *std::ranges::max_element(m_masses[n]) >= heavyLoad * median(m_masses[n]);
    }

    // Whether an iteration of the direct solver over all of a network is worth its time.
    bool isSmall(std::size_t n) const
    {
        DirectSolver trial;
        if (int(m_masses[n].size()) <= mostParticles)
            trial.prepare(m_system, m_rods[n]);
        return !trial.rods().empty() && trial.products() <= mostProducts;
    }

    // Whether a factorisation takes a time that grows as the particles do.
    bool isThin(std::size_t n) const
    {
        std::unordered_map<int, int> places; // of particles, in the order of the rods
        const auto placeOf = [&](int particle) {
            return places.try_emplace(particle, int(places.size())).first->second;
        };
        std::vector<std::pair<int, int>> pairs;
        for (const int r : m_rods[n]) {
            const Rod& rod = m_system.rods[std::size_t(r)];
            if (m_network[rod.a] < 0 || m_network[rod.b] < 0)
                continue;
            const int a = placeOf(rod.a), b = placeOf(rod.b);
            pairs.emplace_back(a, b);
        }
        return BlockCholesky::countProducts(places.size(), pairs)
               <= mostProductsOfThin * double(m_masses[n].size());
    }

private:
    struct Traits
    {
        bool hasPanels = false;
        bool hasPinnedPanels = false; // a corner of one
        bool endsInPins = false;      // a rod does
    };

    static std::vector<std::uint8_t> freeParticles(const System& system)
    {
        std::vector<std::uint8_t> free(system.inverseMass.size());
        std::transform(system.inverseMass.begin(), system.inverseMass.end(), free.begin(),
                       [](double w) { return std::uint8_t(w > 0.0); });
        return free;
    }

    const System& m_system;
    Groups m_network;
    std::vector<std::vector<int>> m_rods;      // [networks]
    std::vector<std::vector<double>> m_masses; // [networks] kg, of what is free
    std::vector<Traits> m_traits;              // [networks]
};

// Networks that are small enough and slow; others have no sweeps here.
std::vector<Candidate> frames(const System& system, std::span<const Candidate> rigged)
{
    const Networks networks(system);
    std::vector<Candidate> found(networks.count());
    for (const Candidate& rigging : rigged) {
        if (rigging.rods.empty()) // its rods went with a rigging that it is tied to
            continue;
        double& sweeps = found[std::size_t(networks.ofRod(rigging.rods[0]))].sweeps;
        sweeps = std::max(sweeps, rigging.sweeps);
    }
    for (std::size_t n = 0; n < found.size(); ++n) {
        found[n].rods = networks.rods(n);
        found[n].particles = int(networks.masses(n).size());
        if (networks.isHeavilyLoaded(n))
            found[n].sweeps = std::max(found[n].sweeps, manySweeps);
        if (found[n].sweeps < manySweeps || !networks.isSmall(n))
            found[n].sweeps = 0.0;
    }
    return found;
}

} // namespace

std::vector<int> rodsForDirect(const System& system)
{
    std::vector<Candidate> candidates = riggings(system);
    std::vector<Candidate> whole = frames(system, candidates);
    // a network comes before the riggings that it contains
    whole.insert(whole.end(), candidates.begin(), candidates.end());
    std::stable_sort(whole.begin(), whole.end(),
                     [](const Candidate& a, const Candidate& b) { return a.sweeps > b.sweeps; });

    std::vector<std::uint8_t> chosen(system.rods.size(), 0);
    int particles = 0;
    for (const Candidate& candidate : whole) {
        if (candidate.sweeps < manySweeps || particles + candidate.particles > mostParticles
            || candidate.rods.empty() || chosen[std::size_t(candidate.rods[0])])
            continue;
        particles += candidate.particles;
        for (const int rod : candidate.rods)
            chosen[std::size_t(rod)] = 1;
    }
    std::vector<int> rods;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i])
            rods.push_back(int(i));
    return rods;
}

std::vector<int> rodsOfCheapNetworks(const System& system)
{
    const Networks networks(system);
    return networks.rodsOf([&](std::size_t n) {
        return networks.hasPanels(n) ? networks.isSmall(n) : networks.isThin(n);
    });
}

std::vector<int> rodsOfFlyingFabric(const System& system)
{
    const Networks networks(system);
    return networks.rodsOf([&](std::size_t n) {
        return networks.hasPanels(n) && !networks.hasPinnedPanels(n)
               && (networks.endsInPins(n) || networks.isHeavilyLoaded(n));
    });
}

std::vector<int> rodsOfNetworks(const System& system, const std::function<bool(const Rod&)>& isOne)
{
    if (std::ranges::none_of(system.rods, isOne))
        return {};
    const Networks networks(system);
    std::vector<std::uint8_t> has(networks.count(), 0);
    for (int r = 0; r < int(system.rods.size()); ++r)
        if (networks.ofRod(r) >= 0 && isOne(system.rods[std::size_t(r)]))
            has[std::size_t(networks.ofRod(r))] = 1;
    std::vector<int> rods;
    for (int r = 0; r < int(system.rods.size()); ++r)
        if (networks.ofRod(r) >= 0 && has[std::size_t(networks.ofRod(r))])
            rods.push_back(r);
    return rods;
}

} // namespace ripstop
