// The order of rods, in two passes over chunks.
//
// Rods are sorted by their higher ends and cut into chunks of one size. The first pass colours each
// chunk: a rod takes the lowest colour that is free at both ends, fillFours() then moves rods
// between colours so that few batches of four are left half empty, and the chunk takes the lowest
// class that is free at all of its particles. The second pass sorts the rods of each chunk by
// colour and writes the places down. Colours are bit sets, so that the lowest free one is found in
// a few operations.
#include "constraints/rod_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <span>
#include <unordered_map>

namespace ripstop {
namespace {

// The colours that touch each thing, as bit sets; finds the lowest colour that is free at several.
class ColorSets
{
public:
    explicit ColorSets(std::size_t things)
        : m_low(things, 0)
    {}

    template <typename Things>
    int take(const Things& things)
    {
        std::uint64_t taken = 0;
        for (const int thing : things)
            taken |= m_low[std::size_t(thing)];
        if (~taken == 0)
            return takeHigh(things);
        const int bit = std::countr_one(taken);
        for (const int thing : things)
            m_low[std::size_t(thing)] |= std::uint64_t(1) << bit;
        return bit;
    }

    // Whether a colour is free at both things; for colours below 64 only, as is change().
    bool isFree(int color, std::array<int, 2> things) const
    {
        return ((m_low[std::size_t(things[0])] | m_low[std::size_t(things[1])]) >> color & 1) == 0;
    }
    void change(int from, int to, std::array<int, 2> things)
    {
        for (const int thing : things)
            m_low[std::size_t(thing)] ^= std::uint64_t(1) << from | std::uint64_t(1) << to;
    }

    bool isUntouched(int thing) const { return m_low[std::size_t(thing)] == 0; }

    void clear(int thing)
    {
        if (!m_high.empty())
            m_high.erase(thing);
        m_low[std::size_t(thing)] = 0;
    }

private:
    // Colours from 64 on, which only hubs need. Things that have fewer than 64 have some too, when
    // they are tied to a hub.
    template <typename Things>
    int takeHigh(const Things& things)
    {
        for (std::size_t word = 0;; ++word) {
            std::uint64_t taken = 0;
            for (const int thing : things)
                if (const auto high = m_high.find(thing);
                    high != m_high.end() && word < high->second.size())
                    taken |= high->second[word];
            if (~taken == 0)
                continue;
            const int bit = std::countr_one(taken);
            for (const int thing : things) {
                std::vector<std::uint64_t>& high = m_high[thing];
                high.resize(std::max(high.size(), word + 1), 0);
                high[word] |= std::uint64_t(1) << bit;
            }
            return 64 + int(word) * 64 + bit;
        }
    }

    std::vector<std::uint64_t> m_low; // [things] colours 0 to 63
    std::unordered_map<int, std::vector<std::uint64_t>> m_high;
};

std::size_t chunkSize(std::size_t rods)
{
    constexpr std::size_t oneChunk = 3000; // below this, threads cost more than they bring
    // Eight chunks are few, as each boundary holds threads up, and make as many for each of two or
    // four threads.
    return rods <= oneChunk ? rods : std::clamp<std::size_t>(rods / 8, 512, 2048);
}

// Neighbours have near numbers, so sorting by the higher end keeps chunks compact.
std::vector<int> sortedByHigherEnd(std::size_t particles, std::span<const RodEnds> rods)
{
    std::vector<int> next(particles + 1, 0);
    for (const RodEnds& rod : rods)
        ++next[std::size_t(std::max(rod.a, rod.b)) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<int> sorted(rods.size());
    for (std::size_t r = 0; r < rods.size(); ++r)
        sorted[std::size_t(next[std::size_t(std::max(rods[r].a, rods[r].b))]++)] = int(r);
    return sorted;
}

// Rods are projected in fours. Where colours are small, as hubs make them, most would end with a
// batch that is not full. This moves rods to other colours where they may be, so that few do.
void fillFours(std::span<int> colorOf, std::span<const int> near, std::span<const RodEnds> rods,
               ColorSets& taken)
{
    const int colors = *std::max_element(colorOf.begin(), colorOf.end()) + 1;
    if (colors > 64 || int(colorOf.size()) > 64 * colors)
        return;
    std::vector<int> size(std::size_t(colors), 0);
    for (const int color : colorOf)
        ++size[std::size_t(color)];
    const int level = (int(colorOf.size()) / colors + 3) / 4 * 4;

    const auto moveTo = [&](std::size_t i, auto&& isBetter) {
        const RodEnds& rod = rods[std::size_t(near[i])];
        const std::array ends{rod.a, rod.b};
        const int from = colorOf[i];
        int best = -1;
        for (int to = 0; to < colors; ++to)
            if (to != from && taken.isFree(to, ends) && isBetter(from, to)
                && (best < 0 || size[std::size_t(to)] < size[std::size_t(best)]))
                best = to;
        if (best < 0)
            return;
        taken.change(from, best, ends);
        --size[std::size_t(from)];
        ++size[std::size_t(best)];
        colorOf[i] = best;
    };
    for (std::size_t i = 0; i < colorOf.size(); ++i)
        if (size[std::size_t(colorOf[i])] > level)
            moveTo(i, [&](int, int to) { return size[std::size_t(to)] < level; });
    // Rods beyond the full fours of their colour go to one where they fill a four.
    for (int turn = 0; turn < 3; ++turn)
        for (std::size_t i = 0; i < colorOf.size(); ++i)
            moveTo(i, [&](int from, int to) {
                const int over = size[std::size_t(from)] % 4;
                const int there = size[std::size_t(to)] % 4;
                return over > 0 && there >= over;
            });
}

// Sorts 0, 1, ... by small numbers; equal ones keep their order.
void sortByNumber(std::span<const int> number, std::vector<int>& start, std::vector<int>& sorted)
{
    const int most = *std::max_element(number.begin(), number.end());
    start.assign(std::size_t(most) + 2, 0);
    for (const int n : number)
        ++start[std::size_t(n) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    sorted.resize(number.size());
    for (std::size_t i = 0; i < number.size(); ++i)
        sorted[std::size_t(start[std::size_t(number[i])]++)] = int(i);
    start.insert(start.begin(), 0); // each has moved to where the next one starts
    start.pop_back();
}

} // namespace

RodOrder orderRods(std::size_t particles, std::span<const RodEnds> rods)
{
    const std::size_t count = rods.size();
    RodOrder order{{}, {0}, {0}, {}};
    if (count == 0)
        return order;

    const std::vector<int> near = sortedByHigherEnd(particles, rods);
    const std::size_t size = chunkSize(count);
    const std::size_t chunks = (count + size - 1) / size;
    const auto chunkAt = [&](std::size_t c) {
        return std::pair(c * size, std::min(count, (c + 1) * size));
    };
    std::vector<int> colorOf(count); // by place in `near`
    std::vector<int> touched;
    std::vector<int> firstChunk(particles, -1);
    ColorSets inChunk(particles);
    ColorSets ofChunks(particles);
    for (std::size_t c = 0; c < chunks; ++c) {
        touched.clear();
        const auto [first, last] = chunkAt(c);
        for (std::size_t i = first; i < last; ++i) {
            const RodEnds& rod = rods[std::size_t(near[i])];
            for (const int end : {rod.a, rod.b})
                if (inChunk.isUntouched(end))
                    touched.push_back(end);
            colorOf[i] = inChunk.take(std::array{rod.a, rod.b});
        }
        fillFours(std::span(colorOf).subspan(first, last - first),
                  std::span(near).subspan(first, last - first), rods, inChunk);
        order.chunkClass.push_back(ofChunks.take(touched));
        for (const int particle : touched) {
            inChunk.clear(particle);
            int& earliest = firstChunk[std::size_t(particle)];
            earliest = earliest < 0 ? int(c) : earliest;
            order.reach = std::max(order.reach, int(c) - earliest);
        }
    }

    order.rod.reserve(count);
    std::vector<int> colorStart;
    std::vector<int> inColors;
    for (std::size_t c = 0; c < chunks; ++c) {
        const auto [first, last] = chunkAt(c);
        sortByNumber(std::span(colorOf).subspan(first, last - first), colorStart, inColors);
        for (std::size_t color = 1; color < colorStart.size(); ++color)
            order.colorStart.push_back(int(first) + colorStart[color]);
        for (const int i : inColors)
            order.rod.push_back(near[first + std::size_t(i)]);
        order.chunkStart.push_back(int(order.colorStart.size()) - 1);
    }
    return order;
}

RodOrder orderRods(std::size_t particles, const std::vector<Rod>& rods)
{
    std::vector<RodEnds> ends;
    ends.reserve(rods.size());
    for (const Rod& rod : rods)
        ends.push_back({rod.a, rod.b});
    return orderRods(particles, std::span<const RodEnds>(ends));
}

} // namespace ripstop
