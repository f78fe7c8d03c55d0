// Each thread takes the next number there is.
#include "study/many.h"

#include <atomic>
#include <thread>
#include <vector>

namespace ripstop {

void forEachOfMany(std::size_t count, int jobs, const std::function<bool(std::size_t)>& work)
{
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> ends = false;
    const auto goOn = [&] {
        for (std::size_t i = next++; i < count && !ends; i = next++)
            if (!work(i))
                ends = true;
    };
    std::vector<std::thread> others;
    for (int i = 1; i < jobs; ++i)
        others.emplace_back(goOn);
    goOn();
    for (std::thread& other : others)
        other.join();
}

} // namespace ripstop
