// The order in which rods are kept and swept.
//
// Rods near each other go into chunks that fit a core's cache. Within a chunk they are coloured: no
// two rods of a colour share a particle, so four of them can be projected at once. Chunks are
// coloured too, into classes: no two chunks of a class share a particle, so each can have a thread.
// Chunks stand in the order of space; classes take turns as parallel/wavefront.h says.
//
// The order depends on the network alone, never on the machine, so that all machines come to the
// same bits. It is made when a system is compiled or split, never in a step.
#pragma once

#include "system/system.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ripstop {

struct RodOrder
{
    std::vector<int> rod;        // [rods] old index at each new place
    std::vector<int> colorStart; // [colours + 1] places
    std::vector<int> chunkStart; // [chunks + 1] colours
    std::vector<int> chunkClass; // [chunks]
    int reach = 0;               // chunks that share a particle are numbered at most this far apart
};

struct RodEnds // particle indices
{
    int a;
    int b;
};

// The order of rods whose ends are particles 0 .. particles - 1.
RodOrder orderRods(std::size_t particles, std::span<const RodEnds> rods);
RodOrder orderRods(std::size_t particles, const std::vector<Rod>& rods);

} // namespace ripstop
