#include "sim/crew.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace ripstop {

struct Crew::Arena
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

Crew::Crew(int threads)
    : m_arena(threads > 1 ? new Arena(threads) : nullptr)
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
