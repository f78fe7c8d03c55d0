// Products and sweeps of a level of Multigrid, by stripes: a stripe takes what seams to others
// bring first, then goes over its own rows.
#include "constraints/multigrid_blocks.h"

#include <algorithm>
#include <numeric>

namespace ripstop {
namespace {

template <bool symmetric, class AnyBlock>
RIPSTOP_INLINE void takeAbove(const std::vector<Seam>& seams, const AnyBlock* block,
                              const std::vector<Row>& x, std::vector<Row>& r)
{
    for (const Seam& seam : seams)
        pack(r[seam.column].v) -= timesMirrored<symmetric>(block[seam.block], x[seam.row]);
}

template <class AnyBlock>
RIPSTOP_INLINE void takeBelow(const std::vector<Seam>& seams, const AnyBlock* block,
                              const std::vector<Row>& x, std::vector<Row>& r)
{
    for (const Seam& seam : seams)
        pack(r[seam.row].v) -= times(block[seam.block], x[seam.column]);
}

} // namespace

// The loops over a stripe, once for blocks that are symmetric and once for others.
template <bool symmetric>
RIPSTOP_INLINE double Multigrid::multiplyAs(const Level& level, const Stripe& stripe, const Row* x,
                                            Row* y)
{
    Pack product{};
    for (std::size_t i = stripe.first; i < stripe.last; ++i)
        pack(y[i].v) = times(level.diagonal[i], x[i]);
    for (const auto* seams : {&stripe.aboveEarlier, &stripe.aboveLater})
        for (const Seam& seam : *seams)
            pack(y[seam.column].v) +=
                timesMirrored<symmetric>(level.block[seam.block], x[seam.row]);
    for (const auto* seams : {&stripe.belowEarlier, &stripe.belowLater})
        for (const Seam& seam : *seams)
            pack(y[seam.row].v) += times(level.block[seam.block], x[seam.column]);
    for (std::size_t i = stripe.first; i < stripe.last; ++i) {
        const Row own = x[i];
        Pack sum = pack(y[i].v);
        for (std::uint32_t k = level.start[i]; k < level.stripes.inside[i]; ++k) {
            const Block& block = level.block[k];
            const std::uint32_t j = level.column[k];
            sum += times(block, x[j]);
            pack(y[j].v) += timesMirrored<symmetric>(block, own);
        }
        pack(y[i].v) = sum;
        product += sum * pack(own.v);
    }
    return (product[0] + product[1]) + product[2];
}

template <bool symmetric, class AnyBlock>
RIPSTOP_INLINE void Multigrid::forwardAs(Level& level, const Stripe& stripe, const AnyBlock* block,
                                         const Row* b)
{
    const std::size_t nodes = stripe.last - stripe.first;
    const std::size_t lag = level.rounded.empty() ? nodes : std::min(level.reach, nodes);
    std::copy(b + stripe.first, b + stripe.last, level.r.begin() + std::ptrdiff_t(stripe.first));
    takeAbove<symmetric>(stripe.aboveEarlier, block, level.x, level.r);
    takeBelow(stripe.belowEarlier, block, level.x, level.r);
    const auto& end = level.stripes.inside;
    for (std::size_t i = stripe.first; i < stripe.last + lag; ++i) {
        if (i < stripe.last) {
            Row x;
            pack(x.v) = times(level.inverse[i], level.r[i]);
            level.x[i] = x;
            for (std::uint32_t k = level.start[i]; k < end[i]; ++k)
                pack(level.r[level.column[k]].v) -= timesMirrored<symmetric>(block[k], x);
        }
        if (i < stripe.first + lag)
            continue;
        // what the sweep has left is what nodes to the right have moved since
        const std::size_t behind = i - lag;
        Pack left{};
        for (std::uint32_t k = level.start[behind]; k < end[behind]; ++k)
            left -= times(block[k], level.x[level.column[k]]);
        pack(level.r[behind].v) = left;
    }
}

// What stripes that came later have moved since.
template <bool symmetric, class AnyBlock>
RIPSTOP_INLINE void Multigrid::finishAs(Level& level, const Stripe& stripe, const AnyBlock* block)
{
    takeAbove<symmetric>(stripe.aboveLater, block, level.x, level.r);
    takeBelow(stripe.belowLater, block, level.x, level.r);
}

template <bool symmetric, class AnyBlock>
RIPSTOP_INLINE void Multigrid::backwardAs(Level& level, const Stripe& stripe, const AnyBlock* block,
                                          const Row* b)
{
    const std::size_t nodes = stripe.last - stripe.first;
    const std::size_t lag = level.rounded.empty() ? nodes : std::min(level.reach, nodes);
    std::copy(b + stripe.first, b + stripe.last, level.r.begin() + std::ptrdiff_t(stripe.first));
    for (const auto* seams : {&stripe.aboveEarlier, &stripe.aboveLater})
        takeAbove<symmetric>(*seams, block, level.x, level.r);
    for (const auto* seams : {&stripe.belowEarlier, &stripe.belowLater})
        takeBelow(*seams, block, level.x, level.r);
    const auto& end = level.stripes.inside;
    for (std::size_t ahead = stripe.last + lag; ahead-- > stripe.first;) {
        if (ahead >= stripe.first + lag) {
            const std::size_t i = ahead - lag;
            const Row x = level.x[i];
            for (std::uint32_t k = level.start[i]; k < end[i]; ++k)
                pack(level.r[level.column[k]].v) -= timesMirrored<symmetric>(block[k], x);
        }
        if (ahead >= stripe.last)
            continue;
        Row left = level.r[ahead];
        for (std::uint32_t k = level.start[ahead]; k < end[ahead]; ++k)
            pack(left.v) -= times(block[k], level.x[level.column[k]]);
        pack(level.x[ahead].v) = times(level.inverse[ahead], left);
    }
}

RIPSTOP_CLONES
double Multigrid::multiplyIn(const Level& level, const Stripe& stripe, const Row* x, Row* y) const
{
    return m_isSymmetric ? multiplyAs<true>(level, stripe, x, y)
                         : multiplyAs<false>(level, stripe, x, y);
}

RIPSTOP_CLONES
void Multigrid::forwardIn(Level& level, const Stripe& stripe, const Row* b) const
{
    if (level.rounded.empty())
        m_isSymmetric ? forwardAs<true>(level, stripe, level.block.data(), b)
                      : forwardAs<false>(level, stripe, level.block.data(), b);
    else
        m_isSymmetric ? forwardAs<true>(level, stripe, level.rounded.data(), b)
                      : forwardAs<false>(level, stripe, level.rounded.data(), b);
}

RIPSTOP_CLONES
void Multigrid::finishIn(Level& level, const Stripe& stripe) const
{
    if (level.rounded.empty())
        m_isSymmetric ? finishAs<true>(level, stripe, level.block.data())
                      : finishAs<false>(level, stripe, level.block.data());
    else
        m_isSymmetric ? finishAs<true>(level, stripe, level.rounded.data())
                      : finishAs<false>(level, stripe, level.rounded.data());
}

RIPSTOP_CLONES
void Multigrid::backwardIn(Level& level, const Stripe& stripe, const Row* b) const
{
    if (level.rounded.empty())
        m_isSymmetric ? backwardAs<true>(level, stripe, level.block.data(), b)
                      : backwardAs<false>(level, stripe, level.block.data(), b);
    else
        m_isSymmetric ? backwardAs<true>(level, stripe, level.rounded.data(), b)
                      : backwardAs<false>(level, stripe, level.rounded.data(), b);
}

// y = A x. Returns x^T A x.
double Multigrid::multiply(Level& level, const Row* x, Row* y, ThreadPool& pool) const
{
    const auto& list = level.stripes.list;
    pool.forEach(list.size(),
                 [&](std::size_t i) { level.part[i] = multiplyIn(level, list[i], x, y); });
    return std::accumulate(level.part.begin(), level.part.end(), 0.0);
}

// One sweep forth from x = 0 for A x = b, then r = b - A x. On large levels that is found as soon
// as the sweep has passed all neighbours, while their blocks are still near.
void Multigrid::forward(Level& level, const Row* b, ThreadPool& pool) const
{
    level.stripes.forEachByColour(pool, [&](const Stripe& stripe) { forwardIn(level, stripe, b); });
    level.stripes.forEach(pool, [&](const Stripe& stripe) { finishIn(level, stripe); });
}

// One sweep back from x.
void Multigrid::backward(Level& level, const Row* b, ThreadPool& pool) const
{
    level.stripes.forEachBackByColour(pool,
                                      [&](const Stripe& stripe) { backwardIn(level, stripe, b); });
}

} // namespace ripstop
