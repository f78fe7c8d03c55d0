// Sets that grow together (Tarjan 1975, with path halving): what hangs together, what becomes one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ripstop {

class JoinedSets
{
public:
    explicit JoinedSets(std::size_t count) // each alone
        : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), 0);
    }

    int of(int member) // the smallest of its set
    {
        while (m_parent[std::size_t(member)] != member) {
            int& parent = m_parent[std::size_t(member)];
            parent = m_parent[std::size_t(parent)];
            member = parent;
        }
        return member;
    }

    // The smaller one stands for both, so that long rows do not become deep trees.
    void join(int a, int b)
    {
        const auto [low, high] = std::minmax({of(a), of(b)});
        m_parent[std::size_t(high)] = low;
    }

private:
    std::vector<int> m_parent;
};

} // namespace ripstop
