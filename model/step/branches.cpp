// Trees grow over rods and panels, breadth first; what hangs beyond each rod is summed from the
// tips.
#include "step/branches.h"

#include "base/joined_sets.h"
#include "constraints/guides.h"

namespace ripstop {
namespace {

class Trees
{
public:
    explicit Trees(const System& system)
        : m_system(system)
        , m_ground(int(system.inverseMass.size()))
        , m_edgesAt(system.inverseMass.size() + 1)
        , m_edgeTo(system.inverseMass.size() + 1, none)
    {
        JoinedSets sets(m_edgesAt.size());
        span(sets, [](const Rod& rod) { return rod.compliance == 0.0; });
        span(sets, [](const Rod& rod) { return rod.compliance > 0.0; });
        for (const Membrane& membrane : system.membranes) {
            const auto [a, b, c] = system.panels[std::size_t(membrane.panel)].corner;
            join(sets, {nodeOf(a), nodeOf(b), noRod});
            join(sets, {nodeOf(a), nodeOf(c), noRod});
        }
        growFrom(m_ground);
        for (int p = 0; p < m_ground; ++p)
            if (sets.of(p) != sets.of(m_ground) && sets.of(p) == p)
                growFrom(p);
    }

    std::vector<Branch> branches() const
    {
        std::vector<double> mass(m_edgesAt.size(), 0.0); // kg, of a node and of what is beyond it
        for (std::size_t p = 0; p < m_system.inverseMass.size(); ++p)
            if (nodeOf(int(p)) != m_ground)
                mass[p] = 1.0 / m_system.inverseMass[p];
        std::vector<Branch> result(m_steps.size());
        for (std::size_t s = m_steps.size(); s-- > 0;) {
            const Step& step = m_steps[s];
            result[s] = {step.rod, step.tree, mass[std::size_t(step.to)]};
            mass[std::size_t(step.from)] += mass[std::size_t(step.to)];
        }
        return result;
    }

private:
    static constexpr int none = -1;

    struct Edge
    {
        int a, b, rod;
    };
    struct Step
    {
        int rod, tree, from, to;
    };

    int nodeOf(int particle) const { return bears(m_system, particle) ? m_ground : particle; }

    template <typename Takes> // bool takes(rod)
    void span(JoinedSets& sets, Takes takes)
    {
        for (std::size_t r = 0; r < m_system.rods.size(); ++r)
            if (const Rod& rod = m_system.rods[r]; takes(rod))
                join(sets, {nodeOf(rod.a), nodeOf(rod.b), int(r)});
    }

    void join(JoinedSets& sets, const Edge& edge)
    {
        if (sets.of(edge.a) == sets.of(edge.b))
            return;
        sets.join(edge.a, edge.b);
        for (const int node : {edge.a, edge.b})
            m_edgesAt[std::size_t(node)].push_back(int(m_edges.size()));
        m_edges.push_back(edge);
    }

    void growFrom(int root)
    {
        std::vector<int> nodes{root};
        std::vector<int> trees{root};
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const int from = nodes[n];
            for (const int e : m_edgesAt[std::size_t(from)]) {
                if (e == m_edgeTo[std::size_t(from)])
                    continue;
                const Edge& edge = m_edges[std::size_t(e)];
                const int to = edge.a == from ? edge.b : edge.a;
                m_edgeTo[std::size_t(to)] = e;
                const int tree = from == m_ground ? to : trees[n];
                m_steps.push_back({edge.rod, tree, from, to});
                nodes.push_back(to);
                trees.push_back(tree);
            }
        }
    }

    const System& m_system;
    int m_ground;                            // the node of all that bears
    std::vector<Edge> m_edges;               // of trees
    std::vector<std::vector<int>> m_edgesAt; // [nodes]
    std::vector<int> m_edgeTo;               // [nodes] from nearer to the root
    std::vector<Step> m_steps;
};

} // namespace

bool bears(const System& system, int particle)
{
    return system.inverseMass[std::size_t(particle)] == 0.0 || guideOf(system, particle);
}

std::vector<Branch> branchesOf(const System& system) { return Trees(system).branches(); }

} // namespace ripstop
