// Random numbers of studies: functions of a seed and of what they are for, the same everywhere.
#pragma once

#include "base/split_mix.h"

#include <cstdint>

namespace ripstop {

// A number for each point and variable, all of them as good as independent.
inline std::uint64_t randomBits(std::uint64_t seed, std::uint64_t point, std::uint64_t variable)
{
    return splitMix(splitMix(splitMix(seed) ^ point) + variable);
}

// Between 0 and 1, never at either: in the middle of one of 2^52 cells.
inline double shareOf(std::uint64_t bits)
{
    return (double(bits >> 12) + 0.5) / 4503599627370496.0;
}

// One after the other, for what draws as it goes.
class RandomShares
{
public:
    explicit RandomShares(std::uint64_t seed)
        : m_seed(seed)
    {}

    double next() { return shareOf(randomBits(m_seed, m_drawn++, 0)); }
    std::size_t below(std::size_t count) { return randomBits(m_seed, m_drawn++, 1) % count; }

private:
    std::uint64_t m_seed;
    std::uint64_t m_drawn = 0;
};

} // namespace ripstop
