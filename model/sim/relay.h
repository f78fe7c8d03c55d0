#pragma once

#include "sim/crew.h"
#include "sim/system.h"

#include <atomic>
#include <memory>
#include <span>

namespace ripstop {

// Goes over chunks of work many rounds, on several threads, as if one thread did it in order.
//
// Chunks that touch each other are in different classes. In each round the classes take turns in a
// given order; a chunk starts as soon as the chunks that it touches have had their turns, so
// threads wait for neighbours and not for all of the others. Each thread has chunks of its own, as
// their data are then in its core's cache; a thread that waits for one that nobody has begun does
// it itself, so it does not matter how many threads come, or when.
class Relay
{
public:
    // `touching` [chunks]: neighbours of each; `classStart` [classes + 1]: its first chunk.
    void prepare(Rows touching, std::span<const int> classStart);

    // Calls work(round, chunk). Classes take turns in `order` in even rounds and the other way
    // round in odd ones.
    template <typename Work>
    void run(Crew& crew, int rounds, std::span<const int> order, Work work)
    {
        start(rounds, order, crew.threads());
        const auto call = [](const void* w, int round, int chunk) {
            (*static_cast<const Work*>(w))(round, chunk);
        };
        crew.together([&](int seat) { takePart(seat, call, &work); });
    }

    std::size_t chunks() const { return m_class.size(); }

private:
    using Call = void (*)(const void*, int, int);

    struct alignas(64) Progress // in rounds
    {
        std::atomic<int> begun = 0;
        std::atomic<int> done = 0;
    };

    void start(int rounds, std::span<const int> order, int seats);
    void takePart(int seat, Call call, const void* work);
    void finishRounds(int chunk, int rounds, Call call, const void* work);
    void await(int chunk, int rounds, Call call, const void* work);
    int rank(int round, int chunk) const;

    Rows m_touching;
    std::vector<int> m_class;      // [chunks]
    std::vector<int> m_place;      // [chunks] within its class
    std::vector<int> m_classStart; // [classes + 1]
    std::vector<int> m_rank;       // [classes] in even rounds
    std::vector<int> m_order;      // [classes]
    std::unique_ptr<Progress[]> m_progress;
    int m_rounds = 0;
    int m_seats = 1;
};

} // namespace ripstop
