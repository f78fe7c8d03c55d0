// Finds the places of numbers, such as ids of elements, in arrays.
//
// Ids count up from 1, so a plain table does what a hash would do, at the cost of one read: it is
// filled and asked in about the order of memory. Numbers that are far above the count, as in a
// long-edited or foreign file, go to a hash map, so that the table stays below 32 bytes per key.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ripstop {

class KeyIndex
{
public:
    explicit KeyIndex(std::size_t count)
        : m_limit(8 * count + 1024)
    {}

    // Returns false when the key is there already; its first place stays.
    bool add(std::uint32_t key, int place)
    {
        if (key >= m_limit)
            return m_far.emplace(key, place).second;
        if (key >= m_place.size())
            m_place.resize(std::min(m_limit, 2 * std::size_t(key) + 64), none);
        int& held = m_place[key];
        if (held != none)
            return false;
        held = place;
        return true;
    }

    static constexpr int none = -1;
    int operator()(std::uint32_t key) const
    {
        if (key < m_limit)
            return key < m_place.size() ? m_place[key] : none;
        const auto found = m_far.find(key);
        return found == m_far.end() ? none : found->second;
    }

private:
    std::size_t m_limit;
    std::vector<int> m_place;
    std::unordered_map<std::uint32_t, int> m_far;
};

} // namespace ripstop
