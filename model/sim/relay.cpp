#include "sim/relay.h"

#include <thread>

namespace ripstop {
namespace {

// Some microseconds: about what a chunk takes. Then let others have the core.
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

void Relay::prepare(Rows touching, std::span<const int> classStart)
{
    m_touching = std::move(touching);
    m_classStart.assign(classStart.begin(), classStart.end());
    const std::size_t chunks = m_touching.start.size() - 1;
    m_class.resize(chunks);
    m_place.resize(chunks);
    m_rank.resize(classStart.size() - 1);
    m_order.resize(classStart.size() - 1);
    for (std::size_t k = 0; k + 1 < classStart.size(); ++k)
        for (int c = classStart[k]; c < classStart[k + 1]; ++c) {
            m_class[std::size_t(c)] = int(k);
            m_place[std::size_t(c)] = c - classStart[k];
        }
    m_progress = std::make_unique<Progress[]>(chunks);
}

void Relay::start(int rounds, std::span<const int> order, int seats)
{
    m_rounds = rounds;
    m_seats = seats;
    for (std::size_t i = 0; i < order.size(); ++i) {
        m_order[i] = order[i];
        m_rank[std::size_t(order[i])] = int(i);
    }
    for (std::size_t c = 0; c < m_class.size(); ++c) {
        m_progress[c].begun.store(0, std::memory_order_relaxed);
        m_progress[c].done.store(0, std::memory_order_relaxed);
    }
}

int Relay::rank(int round, int chunk) const
{
    const int rank = m_rank[std::size_t(m_class[std::size_t(chunk)])];
    return round % 2 == 0 ? rank : int(m_rank.size()) - 1 - rank;
}

void Relay::takePart(int seat, Call call, const void* work)
{
    const int classes = int(m_order.size());
    for (int round = 0; round < m_rounds; ++round)
        for (int k = 0; k < classes; ++k) {
            const int which = m_order[std::size_t(round % 2 == 0 ? k : classes - 1 - k)];
            const int first = m_classStart[std::size_t(which)];
            const int size = m_classStart[std::size_t(which) + 1] - first;
            // Chunks of a class lie in the order of space: seats get neighbourhoods.
            for (int c = size * seat / m_seats; c < size * (seat + 1) / m_seats; ++c)
                finishRounds(first + c, round + 1, call, work);
        }
}

// Does the next round of `chunk` unless that many are begun.
void Relay::finishRounds(int chunk, int rounds, Call call, const void* work)
{
    Progress& progress = m_progress[std::size_t(chunk)];
    int round = progress.begun.load(std::memory_order_acquire);
    while (round < rounds) {
        if (!progress.begun.compare_exchange_strong(round, round + 1, std::memory_order_acq_rel))
            continue;
        for (int waited = 0; progress.done.load(std::memory_order_acquire) < round; ++waited)
            pause(waited); // another thread is at it
        const int turn = rank(round, chunk);
        for (int i = m_touching.start[std::size_t(chunk)];
             i < m_touching.start[std::size_t(chunk) + 1]; ++i) {
            const int neighbour = m_touching.items[std::size_t(i)];
            await(neighbour, round + (rank(round, neighbour) < turn), call, work);
        }
        call(work, round, chunk);
        progress.done.store(round + 1, std::memory_order_release);
        ++round;
    }
}

// Waits until so many rounds of `chunk` are done; does what nobody has begun.
void Relay::await(int chunk, int rounds, Call call, const void* work)
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
