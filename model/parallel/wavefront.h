// The order in which one thread goes over chunks of work.
//
// Chunks that touch are in different classes, and classes take turns: a chunk comes after those
// that it touches and whose class is earlier. Going class by class would obey that too, but would
// take the whole network through the cache once for each class. A wavefront goes over the network
// once, and each class follows the one before at just the distance that it must keep. The result
// has the same bits either way.
//
// The scheduler (chunk_scheduler.h) has one for each thread, and sweeps on one thread have one for
// all chunks. It belongs to one caller; arrange() takes memory only when there are more chunks than
// before.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

class Wavefront
{
public:
    // Puts chunks first .. last - 1 in order.
    //   classOf  [chunks]   chunks that touch are numbered at most `reach` apart
    //   rank     [classes]  the turn of each class
    void arrange(std::span<const int> classOf, int reach, std::span<const int> rank, int first,
                 int last);

    std::span<const int> chunks() const { return m_chunks; }

private:
    std::vector<std::uint64_t> m_keys;
    std::vector<int> m_chunks;
};

} // namespace ripstop
