// Trees grow over rods, breadth first; what hangs beyond each rod is summed from the tips.
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
        , m_rodsAt(system.inverseMass.size() + 1)
        , m_rodTo(system.inverseMass.size() + 1, none)
    {
        JoinedSets sets(m_rodsAt.size());
        span(sets, [](const Rod& rod) { return rod.compliance == 0.0; });
        span(sets, [](const Rod& rod) { return rod.compliance > 0.0; });
        growFrom(m_ground);
        for (int p = 0; p < m_ground; ++p)
            if (sets.of(p) != sets.of(m_ground) && sets.of(p) == p)
                growFrom(p);
    }

    std::vector<Branch> branches() const
    {
        std::vector<double> mass(m_rodsAt.size(), 0.0); // kg, of a node and of what is beyond it
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

    struct Step
    {
        int rod, tree, from, to;
    };

    int nodeOf(int particle) const { return bears(m_system, particle) ? m_ground : particle; }

    template <typename Takes> // bool takes(rod)
    void span(JoinedSets& sets, Takes takes)
    {
        for (std::size_t r = 0; r < m_system.rods.size(); ++r) {
            const Rod& rod = m_system.rods[r];
            const int a = nodeOf(rod.a), b = nodeOf(rod.b);
            if (!takes(rod) || sets.of(a) == sets.of(b))
                continue;
            sets.join(a, b);
            m_rodsAt[std::size_t(a)].push_back(int(r));
            m_rodsAt[std::size_t(b)].push_back(int(r));
        }
    }

    void growFrom(int root)
    {
        std::vector<int> nodes{root};
        std::vector<int> trees{root};
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const int from = nodes[n];
            for (const int r : m_rodsAt[std::size_t(from)]) {
                if (r == m_rodTo[std::size_t(from)])
                    continue;
                const Rod& rod = m_system.rods[std::size_t(r)];
                const int to = nodeOf(rod.a) == from ? nodeOf(rod.b) : nodeOf(rod.a);
                m_rodTo[std::size_t(to)] = r;
                const int tree = from == m_ground ? to : trees[n];
                m_steps.push_back({r, tree, from, to});
                nodes.push_back(to);
                trees.push_back(tree);
            }
        }
    }

    const System& m_system;
    int m_ground;                           // the node of all that bears
    std::vector<std::vector<int>> m_rodsAt; // [nodes] of trees
    std::vector<int> m_rodTo;               // [nodes] from nearer to the root
    std::vector<Step> m_steps;
};

} // namespace

bool bears(const System& system, int particle)
{
    return system.inverseMass[std::size_t(particle)] == 0.0 || guideOf(system, particle);
}

std::vector<Branch> branchesOf(const System& system) { return Trees(system).branches(); }

} // namespace ripstop
