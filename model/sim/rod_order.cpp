#include "sim/rod_order.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace ripstop {
namespace {

// The colours that touch each thing, as bit sets, and the lowest colour that is free at some.
class ColorSets
{
public:
    explicit ColorSets(std::size_t things)
        : m_words(things)
    {}

    template <typename Things>
    int take(const Things& things)
    {
        std::size_t word = 0;
        std::uint64_t taken = 0;
        for (;; ++word) {
            taken = 0;
            for (const int thing : things)
                if (const auto& words = m_words[std::size_t(thing)]; word < words.size())
                    taken |= words[word];
            if (~taken != 0)
                break;
        }
        const int bit = std::countr_one(taken);
        for (const int thing : things) {
            auto& words = m_words[std::size_t(thing)];
            if (words.size() <= word)
                words.resize(word + 1, 0);
            words[word] |= std::uint64_t(1) << bit;
        }
        return int(word) * 64 + bit;
    }

    void clear(int thing) { m_words[std::size_t(thing)].clear(); }

private:
    std::vector<std::vector<std::uint64_t>> m_words;
};

std::size_t chunkSize(std::size_t rods)
{
    constexpr std::size_t oneChunk = 3000; // below this, threads cost more than they bring
    return rods <= oneChunk ? rods : std::clamp<std::size_t>(rods / 16, 512, 2048);
}

} // namespace

RodOrder orderRods(std::size_t particles, const std::vector<Rod>& rods)
{
    const std::size_t count = rods.size();
    RodOrder order;
    order.rod.resize(count);
    std::iota(order.rod.begin(), order.rod.end(), 0);
    order.colorStart = {0};
    order.chunkStart = {0};
    order.classStart = {0};
    if (count == 0)
        return order;

    // Neighbours have near numbers, so sorting by the higher end keeps chunks compact.
    std::stable_sort(order.rod.begin(), order.rod.end(), [&](int x, int y) {
        const Rod& r = rods[std::size_t(x)];
        const Rod& s = rods[std::size_t(y)];
        return std::max(r.a, r.b) < std::max(s.a, s.b);
    });

    const std::size_t size = chunkSize(count);
    const std::size_t chunks = (count + size - 1) / size;
    std::vector<int> classOf(chunks);
    std::vector<int> colorOf(count); // by old index
    std::vector<int> chunkOf(count);
    ColorSets inChunk(particles);
    ColorSets ofChunks(particles);
    for (std::size_t c = 0; c < chunks; ++c) {
        std::vector<int> touched;
        for (std::size_t i = c * size; i < std::min(count, (c + 1) * size); ++i) {
            const int r = order.rod[i];
            const std::array ends{rods[std::size_t(r)].a, rods[std::size_t(r)].b};
            colorOf[std::size_t(r)] = inChunk.take(ends);
            chunkOf[std::size_t(r)] = int(c);
            touched.insert(touched.end(), ends.begin(), ends.end());
        }
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        classOf[c] = ofChunks.take(touched);
        for (const int particle : touched)
            inChunk.clear(particle);
    }

    const auto key = [&](int r) {
        const auto chunk = std::size_t(chunkOf[std::size_t(r)]);
        return std::tuple(classOf[chunk], chunk, colorOf[std::size_t(r)]);
    };
    std::stable_sort(order.rod.begin(), order.rod.end(),
                     [&](int x, int y) { return key(x) < key(y); });

    for (std::size_t i = 1; i <= count; ++i) {
        const bool last = i == count;
        const auto before = key(order.rod[i - 1]);
        const auto after = last ? before : key(order.rod[i]);
        const bool newClass = last || std::get<0>(before) != std::get<0>(after);
        const bool newChunk = newClass || std::get<1>(before) != std::get<1>(after);
        if (newChunk || std::get<2>(before) != std::get<2>(after))
            order.colorStart.push_back(int(i));
        if (newChunk)
            order.chunkStart.push_back(int(order.colorStart.size()) - 1);
        if (newClass)
            order.classStart.push_back(int(order.chunkStart.size()) - 1);
    }
    return order;
}

} // namespace ripstop
