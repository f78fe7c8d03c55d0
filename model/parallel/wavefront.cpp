#include "parallel/wavefront.h"

#include <algorithm>

namespace ripstop {

// Each class lags behind the one before by more than the numbers of two chunks that touch can
// differ, so of two such chunks that of the earlier class comes first.
void Wavefront::arrange(std::span<const int> classOf, int reach, std::span<const int> rank,
                        int first, int last)
{
    const std::uint64_t distance = std::uint64_t(reach) + 1;
    m_keys.clear();
    for (int chunk = first; chunk < last; ++chunk) {
        const int turn = rank[std::size_t(classOf[std::size_t(chunk)])];
        m_keys.push_back((std::uint64_t(chunk) + distance * std::uint64_t(turn)) << 32
                         | std::uint64_t(chunk));
    }
    std::sort(m_keys.begin(), m_keys.end());
    m_chunks.clear();
    for (const std::uint64_t key : m_keys)
        m_chunks.push_back(int(key & 0xffffffffu));
}

} // namespace ripstop
