// Finds the bends of a network as it was built, and what they ask of the step.
//
// Fabric cuts the panels that bend into triangles by their rest lengths, sorts the sides so that
// the two panels of a side come together, makes a bend of each such pair, and couples the bends of
// each panel; bentPanels() says the same from the side of the panels. The sorting makes the order
// of the bends depend on the network alone. bendSums() goes over the stiffness matrix of all bends
// one row at a time, since bends that overlap share entries, whose sum may be smaller than the sum
// of their magnitudes.
#include "laws/bend.h"

#include "laws/joined_spars.h"
#include "laws/step_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

namespace ripstop {
namespace {

using Ends = std::pair<int, int>; // in ascending order

Ends ends(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

// Rest lengths by the particles that a link joins.
class RestLengths
{
public:
    explicit RestLengths(const BendingNet& net)
        : m_net(net)
    {
        m_rows.reserve(net.links.size());
        for (const BendingNet::Link& link : net.links)
            if (link.restLength > 0.0)
                m_rows.push_back({ends(link.a, link.b), link.restLength});
        std::stable_sort(m_rows.begin(), m_rows.end(),
                         [](const Row& one, const Row& other) { return one.ends < other.ends; });
    }

    double distance(int a, int b) const // m, as built
    {
        return (m_net.position[std::size_t(b)] - m_net.position[std::size_t(a)]).norm();
    }

    // The rest length of the first link between them; the distance where there is no link.
    double operator()(int a, int b) const
    {
        const auto found =
            std::lower_bound(m_rows.begin(), m_rows.end(), ends(a, b),
                             [](const Row& row, const Ends& pair) { return row.ends < pair; });
        return found != m_rows.end() && found->ends == ends(a, b) ? found->length : distance(a, b);
    }

private:
    struct Row
    {
        Ends ends;
        double length; // m
    };
    const BendingNet& m_net;
    std::vector<Row> m_rows;
};

struct Triangle // a panel as it is cut
{
    double area = 0.0;               // m^2, 0 when there is no such triangle
    std::array<double, 3> cotangent; // at its corners
    bool clamped = false;            // all corners are pinned
};

Triangle triangleOf(const std::array<double, 3>& side) // m, across from the corners
{
    const auto [a, b, c] = side;
    const double s = 0.5 * (a + b + c);
    const double square = s * (s - a) * (s - b) * (s - c); // Heron
    const double longest = std::max({a, b, c});
    Triangle triangle;
    if (!(square > 1e-12 * longest * longest * longest * longest))
        return triangle;
    triangle.area = std::sqrt(square);
    for (std::size_t k = 0; k < 3; ++k) {
        const double p = side[(k + 1) % 3];
        const double q = side[(k + 2) % 3];
        triangle.cotangent[k] = (p * p + q * q - side[k] * side[k]) / (4.0 * triangle.area);
    }
    return triangle;
}

class Fabric
{
public:
    Fabric(const BendingNet& net, std::vector<Bend>& bends)
        : m_net(net)
        , m_bends(bends)
    {}

    // [panels that bend] with what they share with those beside them
    std::vector<BentPanel> bentPanels() const
    {
        std::vector<BentPanel> bent;
        std::vector<int> row(m_bendAt.size(), -1);
        for (std::size_t panel = 0; panel < m_bendAt.size(); ++panel)
            if (std::ranges::max(m_bendAt[panel]) >= 0) {
                row[panel] = int(bent.size());
                bent.push_back(alone(panel));
            }
        for (BentPanel& one : bent) {
            one.beside.fill(row[std::size_t(one.panel)]);
            for (std::size_t k = 0; k < 3; ++k)
                if (const int bend = m_bendAt[std::size_t(one.panel)][k]; bend >= 0) {
                    const auto& of = m_bends[std::size_t(bend)].of;
                    const int other = of[0] == one.panel ? of[1] : of[0];
                    one.beside[k] = row[std::size_t(other)];
                    lookBeside(one, k, bent[std::size_t(one.beside[k])]);
                }
        }
        return bent;
    }

    void addBends()
    {
        cut();
        if (m_sides.empty())
            return;
        std::sort(m_sides.begin(), m_sides.end(), [](const Side& one, const Side& other) {
            return std::tie(one.ends, one.panel) < std::tie(other.ends, other.panel);
        });
        for (auto first = m_sides.begin(); first != m_sides.end();) {
            const auto last = std::find_if(
                first, m_sides.end(), [&](const Side& side) { return side.ends != first->ends; });
            if (last - first == 2)
                addBend(*first, *std::next(first));
            first = last;
        }
        for (std::size_t panel = 0; panel < m_triangles.size(); ++panel)
            couple(panel);
    }

private:
    struct Side
    {
        Ends ends;
        int panel;
        int across; // number of the corner across from it
    };

    void cut()
    {
        const auto bendable = [](const BendingNet::Panel& p) { return p.bending.fabric > 0.0; };
        if (std::none_of(m_net.panels.begin(), m_net.panels.end(), bendable))
            return;
        const RestLengths length(m_net);
        m_triangles.resize(m_net.panels.size());
        m_bendAt.resize(m_net.panels.size(), {-1, -1, -1});
        for (std::size_t i = 0; i < m_net.panels.size(); ++i) {
            if (!bendable(m_net.panels[i]))
                continue;
            const auto [a, b, c] = m_net.panels[i].corner;
            Triangle& triangle = m_triangles[i];
            triangle = triangleOf({length(b, c), length(c, a), length(a, b)});
            if (triangle.area == 0.0) // no triangle has these rest lengths
                triangle = triangleOf(
                    {length.distance(b, c), length.distance(c, a), length.distance(a, b)});
            if (triangle.area == 0.0)
                continue;
            const auto pinned = [&](int p) { return m_net.pinned[std::size_t(p)] != 0; };
            triangle.clamped = pinned(a) && pinned(b) && pinned(c);
            m_sides.push_back({ends(b, c), int(i), 0});
            m_sides.push_back({ends(c, a), int(i), 1});
            m_sides.push_back({ends(a, b), int(i), 2});
        }
    }

    double cotangentAt(const Side& side, int particle) const
    {
        const auto& corner = m_net.panels[std::size_t(side.panel)].corner;
        const auto k = std::find(corner.begin(), corner.end(), particle) - corner.begin();
        return m_triangles[std::size_t(side.panel)].cotangent[std::size_t(k)];
    }

    void addBend(const Side& one, const Side& other)
    {
        if (m_triangles[std::size_t(one.panel)].clamped
            && m_triangles[std::size_t(other.panel)].clamped)
            return;
        const auto [a, b] = one.ends;
        const double a1 = cotangentAt(one, a), b1 = cotangentAt(one, b);
        const double a2 = cotangentAt(other, a), b2 = cotangentAt(other, b);
        Bend bend{};
        bend.corner = {a, b, cornerAcross(one), cornerAcross(other)};
        bend.weight = {b1 + b2, a1 + a2, -(a1 + b1), -(a2 + b2)};
        bend.of = {one.panel, other.panel};
        bend.beside.fill(-1);
        for (const Side& side : {one, other})
            m_bendAt[std::size_t(side.panel)][std::size_t(side.across)] = int(m_bends.size());
        m_bends.push_back(bend);
    }

    int cornerAcross(const Side& side) const
    {
        return m_net.panels[std::size_t(side.panel)].corner[std::size_t(side.across)];
    }

    // The share of the turn of a bend that is this panel's.
    double share(std::size_t panel, const Bend& bend) const
    {
        const int other = bend.of[0] == int(panel) ? bend.of[1] : bend.of[0];
        const Triangle& beside = m_triangles[std::size_t(other)];
        const double area = m_triangles[panel].area;
        return beside.clamped ? 1.0 : area / (area + beside.area);
    }

    void couple(std::size_t panel)
    {
        const Triangle& triangle = m_triangles[panel];
        if (triangle.area == 0.0 || triangle.clamped)
            return;
        const Bending& bending = m_net.panels[panel].bending;
        for (std::size_t e = 0; e < 3; ++e) {
            const int first = m_bendAt[panel][e];
            if (first < 0)
                continue;
            Bend& bend = m_bends[std::size_t(first)];
            const double own = bending.fabric * share(panel, bend) / triangle.area;
            bend.stiffness += own * share(panel, bend);
            for (std::size_t f = 0; f < 3; ++f) {
                const int second = m_bendAt[panel][f];
                if (f == e || second < 0)
                    continue;
                const double cot = triangle.cotangent[3 - e - f]; // at the corner that they share
                const auto place = std::find(bend.beside.begin(), bend.beside.end(), -1);
                *place = second;
                bend.coupling[std::size_t(place - bend.beside.begin())] =
                    own * share(panel, m_bends[std::size_t(second)]) * cot * cot
                    / (1.0 + cot * cot);
            }
        }
    }

    // Its axes start from the first corner, towards the second one.
    BentPanel alone(std::size_t panel) const
    {
        const Triangle& triangle = m_triangles[panel];
        BentPanel bent;
        bent.corner = m_net.panels[panel].corner;
        bent.panel = int(panel);
        if (!triangle.clamped)
            bent.stiffness = m_net.panels[panel].bending.fabric * triangle.area;
        const auto [a, b, c] = triangle.cotangent;
        const double height = std::sqrt(2.0 * triangle.area / (a + b)); // m, of the third corner
        const std::array<BentPanel::Plane, 3> outwards{{                // |e| n_e
                                                        {height, b * height},
                                                        {-height, a * height},
                                                        {0.0, -(a + b) * height}}};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [x, y] = outwards[k];
            bent.leastHeight[k] = leastShare * 2.0 * triangle.area / std::hypot(x, y);
            if (m_bendAt[panel][k] < 0)
                continue;
            const Bend& bend = m_bends[std::size_t(m_bendAt[panel][k])];
            const double spread = share(panel, bend) / triangle.area; // 1/m^2
            bent.share[k] = {spread * x, spread * y};
            bent.own = {bent.own[0] - spread * x, bent.own[1] - spread * y};
        }
        return bent;
    }

    // Panels that go round alike go along a side that they share in opposite ways.
    void lookBeside(BentPanel& one, std::size_t k, const BentPanel& other) const
    {
        const auto& bends = m_bendAt[std::size_t(one.panel)];
        const auto& theirs = m_bendAt[std::size_t(other.panel)];
        const auto there = std::size_t(std::ranges::find(theirs, bends[k]) - theirs.begin());
        if (one.corner[(k + 1) % 3] == other.corner[(there + 1) % 3])
            one.sign[k] = -1.0;
        for (std::size_t axis = 0; axis < 2; ++axis)
            one.shareBeside[k][axis] = one.sign[k] * other.share[there][axis];
    }

    const BendingNet& m_net;
    std::vector<Bend>& m_bends;
    std::vector<Triangle> m_triangles;        // [panels]
    std::vector<std::array<int, 3>> m_bendAt; // [panels] across from each corner, -1 for none
    std::vector<Side> m_sides;
};

} // namespace

BendsAndPanels bendsAndPanelsOf(const BendingNet& net)
{
    BendsAndPanels found;
    Fabric fabric(net, found.bends);
    fabric.addBends();
    found.panels = fabric.bentPanels();
    addSparBends(net, found.bends);
    std::stable_partition(found.bends.begin(), found.bends.end(),
                          [](const Bend& bend) { return !bend.withRods; });
    return found;
}

std::vector<Bend> bendsOf(const BendingNet& net) { return bendsAndPanelsOf(net).bends; }

std::size_t countOfFabric(const std::vector<Bend>& bends)
{
    const auto isOfFabric = [](const Bend& bend) { return !bend.ofSpar; };
    return std::size_t(std::ranges::partition_point(bends, isOfFabric) - bends.begin());
}

std::size_t countOfForces(const std::vector<Bend>& bends)
{
    const auto isForce = [](const Bend& bend) { return !bend.withRods; };
    return std::size_t(std::ranges::partition_point(bends, isForce) - bends.begin());
}

std::vector<double> bendSums(std::span<const Bend> bends, std::size_t particles)
{
    std::vector<double> sums(particles, 0.0);
    if (bends.empty())
        return sums;
    std::vector<int> start(particles + 1, 0); // bends at each particle
    for (const Bend& bend : bends)
        for (const int corner : bend.corner)
            ++start[std::size_t(corner) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> items(std::size_t(start.back()));
    std::vector<int> next(start.begin(), start.end() - 1);
    for (std::size_t e = 0; e < bends.size(); ++e)
        for (std::size_t k = 0; k < 4; ++k)
            items[std::size_t(next[std::size_t(bends[e].corner[k])]++)] = int(4 * e + k);

    // a row of the stiffness matrix at a time
    std::vector<double> row(particles, 0.0);
    std::vector<int> columns;
    const auto add = [&](const Bend& bend, double factor) {
        for (std::size_t k = 0; k < 4; ++k) {
            row[std::size_t(bend.corner[k])] += factor * bend.weight[k];
            columns.push_back(bend.corner[k]);
        }
    };
    for (std::size_t i = 0; i < particles; ++i) {
        columns.clear();
        for (int n = start[i]; n < start[i + 1]; ++n) {
            const int item = items[std::size_t(n)];
            const Bend& bend = bends[std::size_t(item / 4)];
            const double weight = bend.weight[std::size_t(item % 4)];
            add(bend, weight * bend.stiffness);
            for (std::size_t k = 0; k < 4; ++k)
                if (bend.coupling[k] != 0.0)
                    add(bends[std::size_t(bend.beside[k])], weight * bend.coupling[k]);
        }
        // the row of a spring is twice its stiffness
        for (const int column : columns)
            sums[i] += 0.5 * std::abs(std::exchange(row[std::size_t(column)], 0.0));
    }
    return sums;
}

bool fabricBendsStiffly(const std::vector<Bend>& bends, std::span<const double> mass,
                        double timeStep)
{
    const std::vector<double> sums =
        bendSums(std::span(bends).first(countOfFabric(bends)), mass.size());
    for (std::size_t i = 0; i < mass.size(); ++i)
        if (mass[i] > 0.0
            && springStepLimit(mass[i], sums[i], 0.0, Integrator::SemiImplicitEuler)
                   < slowBends * timeStep)
            return true;
    return false;
}

} // namespace ripstop
