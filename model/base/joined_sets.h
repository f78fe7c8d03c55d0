// Disjoint sets of the numbers 0 .. count - 1 that are joined step by step (union-find; Tarjan
// 1975, with path halving). It finds the pieces of a network: what hangs together, what becomes
// one.
//
// The smallest member stands for its set, so the answer does not depend on the order of the joins.
// Asking for a set shortens the way to it: an object belongs to one thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ripstop {

class JoinedSets
{
public:
    explicit JoinedSets(std::size_t count) // each number is a set of its own
        : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), 0);
    }

    int of(int member) // the smallest member of its set
    {
        while (m_parent[std::size_t(member)] != member) {
            int& parent = m_parent[std::size_t(member)];
            parent = m_parent[std::size_t(parent)];
            member = parent;
        }
        return member;
    }

    // The smaller of the two representatives stands for both sets.
    void join(int a, int b)
    {
        const auto [low, high] = std::minmax({of(a), of(b)});
        m_parent[std::size_t(high)] = low;
    }

private:
    std::vector<int> m_parent;
};

} // namespace ripstop
