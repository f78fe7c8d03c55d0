#include "sim/crew.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace ripstop {

struct Crew::Arena
{
    tbb::task_arena arena;
};

Crew::Crew(int threads)
    : m_arena(threads > 1 ? new Arena{tbb::task_arena(threads)} : nullptr)
{}

Crew::~Crew() = default;
Crew::Crew(Crew&&) noexcept = default;
Crew& Crew::operator=(Crew&&) noexcept = default;

void Crew::spread(std::size_t count, std::size_t least, const void* body,
                  void (*call)(const void*, std::size_t, std::size_t))
{
    m_arena->arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, least),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              call(body, range.begin(), range.end());
                          });
    });
}

} // namespace ripstop
