// A pool of threads that loops are split over (parallel for).
//
// A loop body gets a range of indices and writes only what belongs to that range, so the result has
// the same bits whatever the number of threads; sums are split by ordered_parts.h alone. Small
// loops stay on the calling thread, as handing out work takes some microseconds. A call returns
// when all of its work is done.
//
// The stepper has the pool and lends it to forces, rods and contact; verification and tests make
// their own. TBB runs the threads and is not named outside of the source.
#pragma once

#include <cstddef>
#include <memory>

namespace ripstop {

class ThreadPool
{
public:
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(ThreadPool&&) noexcept;
    ThreadPool& operator=(ThreadPool&&) noexcept;

    // Calls body(first, last) for ranges that together are 0 .. count - 1.
    template <typename Body>
    void parallelFor(std::size_t count, Body body)
    {
        if (!m_arena || count < 2 * grain)
            body(std::size_t(0), count);
        else
            spread(count, grain, &body, [](const void* b, std::size_t first, std::size_t last) {
                (*static_cast<const Body*>(b))(first, last);
            });
    }

    // Calls body(i) for 0 .. count - 1, each of which is worth handing out.
    template <typename Body>
    void forEach(std::size_t count, Body body)
    {
        const auto range = [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                body(i);
        };
        if (!m_arena || count < 2)
            range(0, count);
        else
            spread(count, 1, &range, [](const void* r, std::size_t first, std::size_t last) {
                (*static_cast<const decltype(range)*>(r))(first, last);
            });
    }

    // Calls body(thread) for threads 0 .. threads() - 1, each on a thread of its own when there is
    // one to spare; one after another otherwise.
    template <typename Body>
    void onEachThread(Body body)
    {
        const auto range = [&](std::size_t first, std::size_t last) {
            for (std::size_t thread = first; thread < last; ++thread)
                body(int(thread));
        };
        if (!m_arena)
            range(0, 1);
        else
            spread(std::size_t(m_threads), 1, &range,
                   [](const void* r, std::size_t first, std::size_t last) {
                       (*static_cast<const decltype(range)*>(r))(first, last);
                   });
    }

    int threads() const { return m_threads; }

    static int cores(); // that this program may use

private:
    static constexpr std::size_t grain = 4096; // handing out work takes some microseconds

    void spread(std::size_t count, std::size_t least, const void* body,
                void (*call)(const void*, std::size_t, std::size_t));

    struct Arena;
    int m_threads;
    std::unique_ptr<Arena> m_arena; // null for one thread
};

} // namespace ripstop
