#pragma once

#include <cstddef>
#include <memory>

namespace ripstop {

// Splits loops over threads. A loop body gets a range and writes only what belongs to that range,
// so the result has the same bits whatever the number of threads. Small loops stay on the calling
// thread.
class Crew
{
public:
    explicit Crew(int threads);
    ~Crew();
    Crew(Crew&&) noexcept;
    Crew& operator=(Crew&&) noexcept;

    template <typename Body> // body(first, last)
    void each(std::size_t count, Body body)
    {
        if (!m_arena || count < 2 * grain)
            body(std::size_t(0), count);
        else
            spread(count, grain, &body, [](const void* b, std::size_t first, std::size_t last) {
                (*static_cast<const Body*>(b))(first, last);
            });
    }

    // Items that are each worth a thread: body(item).
    template <typename Body>
    void tasks(std::size_t count, Body body)
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

private:
    static constexpr std::size_t grain = 2048;

    void spread(std::size_t count, std::size_t least, const void* body,
                void (*call)(const void*, std::size_t, std::size_t));

    struct Arena;
    std::unique_ptr<Arena> m_arena; // null for one thread
};

} // namespace ripstop
