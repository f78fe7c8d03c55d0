// The rows of a large symmetric matrix, and what is written beside them, in stripes for threads.
//
// Stripes are runs of rows. They have colours such that those of one colour write to no place that
// another of them reads or writes: threads may take them in any order. A sweep of Gauss-Seidel goes
// through the colours one after the other, and through the rows of a stripe as ever. Size and
// colours follow from the pattern alone, so that the result has the same bits at any number of
// threads. A small matrix, or one whose rows are joined to others far away, is a single stripe.
#pragma once

#include "parallel/thread_pool.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

// A block above the diagonal that joins rows of two stripes.
struct Seam
{
    std::uint32_t row;
    std::uint32_t column; // further down
    std::uint32_t block;
};

struct Stripe
{
    std::size_t first = 0, last = 0; // rows
    int colour = 0;
    // Seams to stripes above and below; those to lower colours come first.
    std::vector<Seam> aboveEarlier, aboveLater; // the columns are in this stripe
    std::vector<Seam> belowEarlier, belowLater; // the rows are
    std::size_t pairTarget = 0, nodeTarget = 0; // first of what its blocks, and rows, write to
};

struct Stripes
{
    std::vector<Stripe> list;                        // by rows
    std::vector<std::vector<std::uint32_t>> colours; // places in `list`
    std::vector<std::uint32_t> inside;               // [rows] end of the blocks within the stripe

    std::size_t placeOf(const Stripe& stripe) const { return std::size_t(&stripe - list.data()); }

    // body(stripe), by threads that share the stripes: all of them, or colour by colour.
    template <typename Body>
    void forEach(ThreadPool& pool, Body body) const
    {
        pool.forEach(list.size(), [&](std::size_t i) { body(list[i]); });
    }
    template <typename Body>
    void forEachByColour(ThreadPool& pool, Body body) const
    {
        for (const auto& places : colours)
            forEachOf(places, pool, body);
    }
    template <typename Body>
    void forEachBackByColour(ThreadPool& pool, Body body) const
    {
        for (auto places = colours.rbegin(); places != colours.rend(); ++places)
            forEachOf(*places, pool, body);
    }

private:
    template <typename Body>
    void forEachOf(const std::vector<std::uint32_t>& places, ThreadPool& pool, Body body) const
    {
        pool.forEach(places.size(), [&](std::size_t i) { body(list[places[i]]); });
    }
};

// The pattern of the blocks above the diagonal, by rows, columns ascending; and, where there are
// any, the places that each block and then each row writes to.
struct Pattern
{
    std::span<const std::uint32_t> start;      // [rows + 1]
    std::span<const std::uint32_t> column;     // [blocks]
    std::span<const std::uint32_t> rowWrites;  // [rows + 1] first of the targets of a row's blocks
    std::span<const std::uint32_t> selfWrites; // [rows + 1] first of the targets of the row itself
    std::span<const std::uint32_t> target;
    std::size_t targets = 0; // places
};

Stripes stripesOf(const Pattern& pattern);

} // namespace ripstop
