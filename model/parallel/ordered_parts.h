// Sums over many things by several threads, with the same bits at any number of them.
//
// The things are cut into parts that hang on their number alone. Threads work out what each part
// comes to, in any order; then the parts are taken together in theirs. Fewer things than one part
// has come to what a plain loop over them does.
#pragma once

#include "parallel/thread_pool.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace ripstop {

// Calls take(of(first, last)) for the parts of 0 .. count - 1, in ascending order.
template <typename Of, typename Take>
void inOrderedParts(ThreadPool& pool, std::size_t count, Of of, Take take)
{
    constexpr std::size_t most = 256;
    const std::size_t size = std::max(std::size_t(4096), (count + most - 1) / most);
    const std::size_t parts = (count + size - 1) / size;
    std::array<decltype(of(count, count)), most> found{};
    pool.forEach(parts, [&](std::size_t part) {
        found[part] = of(part * size, std::min(count, (part + 1) * size));
    });
    for (std::size_t part = 0; part < parts; ++part)
        take(found[part]);
}

template <typename Of> // double of(first, last)
double orderedSum(ThreadPool& pool, std::size_t count, Of of)
{
    double sum = 0.0;
    inOrderedParts(pool, count, of, [&](double part) { sum += part; });
    return sum;
}

} // namespace ripstop
