#include "parallel/chunk_scheduler.h"

#include <thread>

namespace ripstop {
namespace {

// How often a thread looks before it lets others have the core: some microseconds, about what a
// chunk takes.
constexpr int patience = 200;

// Waiting for another thread, `waited` times so far. That thread may need this core.
void pause(int waited)
{
    if (waited >= patience)
        return std::this_thread::yield();
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

} // namespace

void ChunkScheduler::prepare(Rows touching, std::span<const int> classOf, int reach)
{
    m_touching = std::move(touching);
    m_class.assign(classOf.begin(), classOf.end());
    m_reach = reach;
    m_progress = std::make_unique<Progress[]>(m_class.size());
}

void ChunkScheduler::start(int rounds, std::span<const int> rank, int threads)
{
    m_rounds = rounds;
    m_rank.assign(rank.begin(), rank.end());
    m_wavefronts.resize(std::size_t(threads));
    const auto chunks = int(m_class.size());
    for (int thread = 0; thread < threads; ++thread)
        m_wavefronts[std::size_t(thread)].arrange(
            m_class, m_reach, m_rank, int(std::int64_t(chunks) * thread / threads),
            int(std::int64_t(chunks) * (thread + 1) / threads));
    for (std::size_t c = 0; c < m_class.size(); ++c) {
        m_progress[c].begun.store(0, std::memory_order_relaxed);
        m_progress[c].done.store(0, std::memory_order_relaxed);
    }
}

int ChunkScheduler::turn(int round, int chunk) const
{
    const int rank = m_rank[std::size_t(m_class[std::size_t(chunk)])];
    return round % 2 == 0 ? rank : int(m_rank.size()) - 1 - rank;
}

void ChunkScheduler::takePart(int thread, Call call, const void* work)
{
    const std::span<const int> wave = m_wavefronts[std::size_t(thread)].chunks();
    for (int round = 0; round < m_rounds; ++round)
        for (std::size_t i = 0; i < wave.size(); ++i)
            finishRounds(wave[round % 2 == 0 ? i : wave.size() - 1 - i], round + 1, call, work);
}

// Does rounds of `chunk` until so many are begun, by this thread or another.
void ChunkScheduler::finishRounds(int chunk, int rounds, Call call, const void* work)
{
    Progress& progress = m_progress[std::size_t(chunk)];
    int round = progress.begun.load(std::memory_order_acquire);
    while (round < rounds) {
        if (!progress.begun.compare_exchange_strong(round, round + 1, std::memory_order_acq_rel))
            continue;
        for (int waited = 0; progress.done.load(std::memory_order_acquire) < round; ++waited)
            pause(waited); // another thread is still in the round before
        const int own = turn(round, chunk);
        for (int i = m_touching.start[std::size_t(chunk)];
             i < m_touching.start[std::size_t(chunk) + 1]; ++i) {
            const int neighbour = m_touching.items[std::size_t(i)];
            await(neighbour, round + (turn(round, neighbour) < own), call, work);
        }
        call(work, round, chunk);
        progress.done.store(round + 1, std::memory_order_release);
        ++round;
    }
}

// Waits until so many rounds of `chunk` are done, and does those that nobody has begun.
void ChunkScheduler::await(int chunk, int rounds, Call call, const void* work)
{
    Progress& progress = m_progress[std::size_t(chunk)];
    for (int waited = 0; progress.done.load(std::memory_order_acquire) < rounds; ++waited) {
        if (waited >= patience && progress.begun.load(std::memory_order_acquire) < rounds)
            finishRounds(chunk, rounds, call, work);
        else
            pause(waited);
    }
}

} // namespace ripstop
