// SplitMix64 (Steele, Lea and Flood 2014): spreads the bits of a number, the same on every machine.
//
// Gusts, generated terrain and the order of colours draw their random numbers from it, as a hash of
// seed and step: it has no state of its own, so any thread may call it in any order.
#pragma once

#include <cstdint>

namespace ripstop {

// The last stage of SplitMix64 alone: numbers that are near each other come far apart.
inline std::uint64_t mixBits(std::uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// The number that follows the state x.
inline std::uint64_t splitMix(std::uint64_t x) { return mixBits(x + 0x9e3779b97f4a7c15u); }

} // namespace ripstop
