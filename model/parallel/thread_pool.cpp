#include "parallel/thread_pool.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#ifdef RIPSTOP_TELLS_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace ripstop {
namespace {

// The thread sanitizer cannot see how TBB, which is not built for it, hands work to other threads
// and takes it back. These tell it, so that it sees every race of our own and no others. This file
// alone is not watched by it, as it is the only one that compiles what is in TBB's headers
// (CMakeLists.txt); what it calls is.
char handedOut;
char takenBack;

void release([[maybe_unused]] char& point)
{
#ifdef RIPSTOP_TELLS_THREAD_SANITIZER
    __tsan_release(&point);
#endif
}

void acquire([[maybe_unused]] char& point)
{
#ifdef RIPSTOP_TELLS_THREAD_SANITIZER
    __tsan_acquire(&point);
#endif
}

} // namespace

struct ThreadPool::Arena
{
    explicit Arena(int threads)
        : arena(threads)
    {
        if (threads > tbb::info::default_concurrency())
            more = std::make_unique<tbb::global_control>(
                tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    }

    // More threads than cores, when that is asked for; the library refuses them otherwise.
    std::unique_ptr<tbb::global_control> more;
    tbb::task_arena arena;
};

ThreadPool::ThreadPool(int threads)
    : m_threads(threads > 1 ? threads : 1)
    , m_arena(threads > 1 ? new Arena(threads) : nullptr)
{}

ThreadPool::~ThreadPool() = default;

int ThreadPool::cores() { return tbb::info::default_concurrency(); }

ThreadPool::ThreadPool(ThreadPool&&) noexcept = default;
ThreadPool& ThreadPool::operator=(ThreadPool&&) noexcept = default;

void ThreadPool::spread(std::size_t count, std::size_t least, const void* body,
                        void (*call)(const void*, std::size_t, std::size_t))
{
    release(handedOut);
    m_arena->arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, least),
            [&](const tbb::blocked_range<std::size_t>& range) {
                acquire(handedOut);
                call(body, range.begin(), range.end());
                release(takenBack);
            },
            tbb::simple_partitioner());
    });
    acquire(takenBack);
}

} // namespace ripstop
