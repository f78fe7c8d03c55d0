// Cuts the rows, then gives each stripe in turn the lowest colour that none has which touches the
// same rows or targets.
#include "constraints/stripes.h"

#include <algorithm>
#include <bit>

namespace ripstop {
namespace {

constexpr std::size_t leastRows = 512;  // of a stripe
constexpr std::size_t leastStripes = 4; // fewer are not worth it
constexpr int mostColours = 64;

std::size_t reachOf(const Pattern& pattern) // rows
{
    std::size_t reach = 0;
    for (std::size_t i = 0; i + 1 < pattern.start.size(); ++i)
        if (pattern.start[i + 1] > pattern.start[i])
            reach = std::max(reach, pattern.column[pattern.start[i + 1] - 1] - i);
    return reach;
}

// Which colours touch a row or a target.
class Touched
{
public:
    explicit Touched(const Pattern& pattern)
        : m_pattern(pattern)
        , m_rows(pattern.start.size() - 1, 0)
        , m_targets(pattern.targets, 0)
    {}

    int colourOf(const Stripe& stripe) // which has it from now on; -1 when there is none
    {
        std::uint64_t taken = 0;
        visit(stripe, [&](std::uint64_t& colours) { taken |= colours; });
        const int colour = std::countr_one(taken);
        if (colour == mostColours)
            return -1;
        visit(stripe, [&](std::uint64_t& colours) { colours |= std::uint64_t(1) << colour; });
        return colour;
    }

private:
    template <typename Visit>
    void visit(const Stripe& stripe, Visit visit)
    {
        const auto& p = m_pattern;
        for (std::size_t i = stripe.first; i < stripe.last; ++i)
            visit(m_rows[i]);
        for (std::size_t k = p.start[stripe.first]; k < p.start[stripe.last]; ++k)
            visit(m_rows[p.column[k]]);
        if (p.target.empty())
            return;
        for (const auto writes : {p.rowWrites, p.selfWrites})
            for (std::size_t t = writes[stripe.first]; t < writes[stripe.last]; ++t)
                visit(m_targets[p.target[t]]);
    }

    const Pattern& m_pattern;
    std::vector<std::uint64_t> m_rows, m_targets; // bits of colours
};

Stripes single(const Pattern& pattern)
{
    Stripes stripes;
    Stripe& all = stripes.list.emplace_back();
    all.last = pattern.start.size() - 1;
    if (!pattern.target.empty())
        all.nodeTarget = pattern.selfWrites[0];
    stripes.colours = {{0}};
    stripes.inside.assign(pattern.start.begin() + 1, pattern.start.end());
    return stripes;
}

void addSeams(const Pattern& pattern, std::size_t size, Stripes& stripes)
{
    for (std::size_t i = 0; i + 1 < pattern.start.size(); ++i) {
        const std::size_t own = i / size;
        for (std::uint32_t k = stripes.inside[i]; k < pattern.start[i + 1]; ++k) {
            const std::size_t other = pattern.column[k] / size;
            const Seam seam{std::uint32_t(i), pattern.column[k], k};
            Stripe& above = stripes.list[own];
            Stripe& below = stripes.list[other];
            (below.colour < above.colour ? above.belowEarlier : above.belowLater).push_back(seam);
            (above.colour < below.colour ? below.aboveEarlier : below.aboveLater).push_back(seam);
        }
    }
}

} // namespace

Stripes stripesOf(const Pattern& pattern)
{
    const std::size_t rows = pattern.start.size() - 1;
    const std::size_t size = std::max(leastRows, 4 * reachOf(pattern));
    if (rows < leastStripes * size)
        return single(pattern);
    Stripes stripes;
    Touched touched(pattern);
    for (std::size_t first = 0; first < rows; first += size) {
        Stripe stripe;
        stripe.first = first;
        stripe.last = std::min(rows, first + size);
        stripe.colour = touched.colourOf(stripe);
        if (stripe.colour < 0)
            return single(pattern);
        if (!pattern.target.empty()) {
            stripe.pairTarget = pattern.rowWrites[first];
            stripe.nodeTarget = pattern.selfWrites[first];
        }
        stripes.colours.resize(std::max(stripes.colours.size(), std::size_t(stripe.colour) + 1));
        stripes.colours[std::size_t(stripe.colour)].push_back(std::uint32_t(stripes.list.size()));
        stripes.list.push_back(stripe);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const auto* const first = pattern.column.data() + pattern.start[i];
        const auto* const last = pattern.column.data() + pattern.start[i + 1];
        const auto end = std::uint32_t(stripes.list[i / size].last);
        stripes.inside.push_back(
            std::uint32_t(std::lower_bound(first, last, end) - pattern.column.data()));
    }
    addSeams(pattern, size, stripes);
    return stripes;
}

} // namespace ripstop
