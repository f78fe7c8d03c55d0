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
            spread(count, &body, [](void* b, std::size_t first, std::size_t last) {
                (*static_cast<Body*>(b))(first, last);
            });
    }

private:
    static constexpr std::size_t grain = 2048;

    void spread(std::size_t count, void* body, void (*call)(void*, std::size_t, std::size_t));

    struct Arena;
    std::unique_ptr<Arena> m_arena; // null for one thread
};

} // namespace ripstop
