// A scheduler that goes over chunks of work many rounds, on several threads, as if one thread did
// it in order.
//
// Chunks that touch each other are in different classes. In each round the classes take turns in a
// given order; a chunk starts as soon as the chunks that it touches have had their turns, so
// threads wait for neighbours and not for all of the others. Each thread has a stretch of chunks of
// its own, as their data are then in its core's cache, and goes over it as a wavefront
// (wavefront.h). A thread that waits for a chunk that nobody has begun does it itself, so it does
// not matter how many threads come, or when. The result has the same bits as that of one thread.
//
// ColouredSweeps (constraints/coloured_sweeps.h) sweeps the rods of large networks with it. One
// thread calls prepare() and run(), never two at once; `work` is called on all threads of the pool
// and writes only what belongs to its chunk. prepare() and the first run() take memory; later runs
// with as many threads take none.
#pragma once

#include "base/rows.h"
#include "parallel/thread_pool.h"
#include "parallel/wavefront.h"

#include <atomic>
#include <memory>
#include <span>

namespace ripstop {

class ChunkScheduler
{
public:
    // Takes over the network of chunks, before the first run() and whenever it has changed.
    //   touching  [chunks]  the chunks that each touches, numbered at most `reach` away
    //   classOf   [chunks]  chunks that touch are of different classes
    void prepare(Rows touching, std::span<const int> classOf, int reach);

    // Calls work(round, chunk) for each round and chunk, and returns when all of it is done.
    // Classes take turns as ranked in even rounds and the other way round in odd ones.
    //   rank  [classes]  its turn in even rounds
    template <typename Work>
    void run(ThreadPool& pool, int rounds, std::span<const int> rank, Work work)
    {
        start(rounds, rank, pool.threads());
        const auto call = [](const void* w, int round, int chunk) {
            (*static_cast<const Work*>(w))(round, chunk);
        };
        pool.onEachThread([&](int thread) { takePart(thread, call, &work); });
    }

    std::size_t chunks() const { return m_class.size(); }

private:
    using Call = void (*)(const void*, int, int);

    struct alignas(64) Progress // of a chunk, in rounds; a cache line of its own
    {
        std::atomic<int> begun = 0;
        std::atomic<int> done = 0;
    };

    void start(int rounds, std::span<const int> rank, int threads);
    void takePart(int thread, Call call, const void* work);
    void finishRounds(int chunk, int rounds, Call call, const void* work);
    void await(int chunk, int rounds, Call call, const void* work);
    int turn(int round, int chunk) const;

    Rows m_touching;
    std::vector<int> m_class; // [chunks]
    int m_reach = 0;
    std::vector<int> m_rank;             // [classes] in even rounds
    std::vector<Wavefront> m_wavefronts; // [threads]
    std::unique_ptr<Progress[]> m_progress;
    int m_rounds = 0;
};

} // namespace ripstop
