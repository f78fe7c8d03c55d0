#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

// The order in which one thread goes over chunks of work.
//
// Chunks that touch are in different classes, and classes take turns: a chunk comes after those
// that it touches and whose class is earlier. Class by class would do, but takes the whole network
// through the cache once for each class. A wave goes over the network instead, and each class
// follows the one before at just the distance that it must keep. The outcome has the same bits.
class Wavefront
{
public:
    // Sorts chunks `first` to `last`.
    //   classOf  [chunks]   chunks that touch are numbered at most `reach` apart
    //   rank     [classes]  its turn
    void arrange(std::span<const int> classOf, int reach, std::span<const int> rank, int first,
                 int last);

    std::span<const int> chunks() const { return m_chunks; }

private:
    std::vector<std::uint64_t> m_keys;
    std::vector<int> m_chunks;
};

} // namespace ripstop
