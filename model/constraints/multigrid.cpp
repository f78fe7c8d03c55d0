// Conjugate gradients over a hierarchy of coarser networks.
//
// analyze() makes the hierarchy (coarsening.h). factorize() fills the levels with numbers:
// makeCoarser() and invert() for each, and a factor of the last. solve() iterates; cycle() is one V
// through the levels. Loops over blocks are compiled for both kinds of machine and fuse nothing.
#include "constraints/multigrid.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::size_t smallEnough = 48;      // nodes, of the coarsest level
constexpr std::size_t mostFactorised = 2000; // nodes, where a network has no coarser one
constexpr std::size_t mostNear = 40'000;     // blocks, that a processor keeps near
constexpr double nothing = 1e-5;             // of the energy's root
constexpr double usualFall = 0.02;           // of the square of the error, in an iteration
constexpr double toSpare = 3.0;

using Block = BlockCholesky::Block;
using RoundedBlock = Multigrid::RoundedBlock;

RIPSTOP_INLINE Pack columnOf(const Block& block, int c) { return pack(block.column[c]); }

RIPSTOP_INLINE Pack columnOf(const RoundedBlock& block, int c)
{
    return __builtin_convertvector(block.column[c], Pack);
}

template <class AnyBlock>
RIPSTOP_INLINE Pack times(const AnyBlock& block, const Row& x)
{
    return columnOf(block, 0) * x.v[0] + columnOf(block, 1) * x.v[1] + columnOf(block, 2) * x.v[2];
}

// Of the block below the diagonal that mirrors this one above it.
template <bool symmetric, class AnyBlock>
RIPSTOP_INLINE Pack timesMirrored(const AnyBlock& block, const Row& x)
{
    if constexpr (symmetric)
        return times(block, x);
    Pack result{};
    for (int c = 0; c < 3; ++c) {
        const Pack product = columnOf(block, c) * pack(x.v);
        result[c] = (product[0] + product[1]) + product[2];
    }
    return result;
}

RIPSTOP_INLINE RoundedBlock rounded(const Block& block)
{
    RoundedBlock result;
    for (int c = 0; c < 3; ++c)
        result.column[c] = __builtin_convertvector(columnOf(block, c), RoundedBlock::Column);
    return result;
}

RIPSTOP_INLINE Block mirrored(const Block& block)
{
    Block result{};
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            result.column[c][r] = block.column[r][c];
    return result;
}

// A sum in a fixed order, in four parts, so that additions need not wait for each other.
RIPSTOP_CLONES
double dotOf(const Row* a, const Row* b, std::size_t count)
{
    Pack sum[4] = {};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (std::size_t k = 0; k < 4; ++k)
            sum[k] += pack(a[i + k].v) * pack(b[i + k].v);
    for (; i < count; ++i)
        sum[0] += pack(a[i].v) * pack(b[i].v);
    const Pack all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    return (all[0] + all[1]) + all[2];
}

} // namespace

void Multigrid::analyze(std::size_t nodes, std::span<const std::pair<int, int>> pairs,
                        std::span<const std::pair<int, int>> anchors, std::span<const Row> place,
                        bool symmetric)
{
    m_isSymmetric = symmetric;
    using Pair = NetworkGraph::Pair;
    NetworkGraph graph{nodes, {}, {}, {place.begin(), place.end()}};
    const auto sortUnique = [](std::vector<Pair>& all) {
        std::ranges::sort(all);
        all.erase(std::unique(all.begin(), all.end()), all.end());
    };
    const auto ordered = [](const std::pair<int, int>& pair) {
        const auto [low, high] = std::minmax(pair.first, pair.second);
        return Pair(std::uint32_t(low), std::uint32_t(high));
    };
    for (const auto& pair : pairs)
        graph.pairs.push_back(ordered(pair));
    sortUnique(graph.pairs);
    for (const auto& [node, anchor] : anchors)
        graph.anchors.emplace_back(std::uint32_t(node), std::uint32_t(std::size_t(anchor) - nodes));
    sortUnique(graph.anchors);
    m_pair.clear();
    for (const auto& pair : pairs)
        m_pair.push_back(std::uint32_t(std::ranges::lower_bound(graph.pairs, ordered(pair))
                                       - graph.pairs.begin()));

    const auto giveSweeps = [](Level& level) {
        level.inverse.assign(level.diagonal.size(), RoundedBlock{});
        if (level.block.size() > mostNear)
            level.rounded.assign(level.block.size(), RoundedBlock{});
    };
    m_levels.clear();
    for (;;) {
        Level& level = m_levels.emplace_back();
        level.start.assign(graph.nodes + 1, 0);
        for (const auto& [a, b] : graph.pairs) {
            ++level.start[a + 1];
            level.column.push_back(b);
            level.reach = std::max(level.reach, std::size_t(b - a));
        }
        for (std::size_t i = 0; i < graph.nodes; ++i)
            level.start[i + 1] += level.start[i];
        level.block.assign(graph.pairs.size(), Block{});
        level.diagonal.assign(graph.nodes, Block{});
        for (auto* rows : {&level.x, &level.b, &level.r})
            rows->assign(graph.nodes, Row{});
        if (graph.nodes <= smallEnough)
            break;
        Coarsening next = coarsened(graph);
        if (next.graph.nodes == 0 || next.graph.nodes > graph.nodes * 4 / 5) // no use
            break;
        giveSweeps(level);
        level.up = std::move(next.up);
        level.target = std::move(next.target);
        graph = std::move(next.graph);
    }
    m_factorises = graph.nodes <= mostFactorised;
    if (!m_factorises) {
        giveSweeps(m_levels.back());
        graph = {};
    }
    std::vector<std::pair<int, int>> last;
    for (const auto& [a, b] : graph.pairs)
        last.emplace_back(int(a), int(b));
    m_coarsest.analyze(graph.nodes, last);
    for (auto* rows : {&m_x, &m_r, &m_p, &m_q})
        rows->assign(nodes, Row{});
}

void Multigrid::setZero()
{
    std::ranges::fill(m_levels[0].block, Block{});
    std::ranges::fill(m_levels[0].diagonal, Block{});
}

bool Multigrid::factorize()
{
    for (std::size_t l = 0; l + 1 < m_levels.size(); ++l) {
        if (!invert(m_levels[l]))
            return false;
        makeCoarser(m_levels[l], m_levels[l + 1]);
    }
    Level& last = m_levels.back();
    if (!m_factorises) {
        roundBlocks(last);
        return invert(last);
    }
    m_coarsest.setZero();
    for (std::size_t i = 0; i < last.diagonal.size(); ++i)
        m_coarsest.diagonal(i) = last.diagonal[i];
    for (std::size_t i = 0; i < last.diagonal.size(); ++i)
        for (std::uint32_t k = last.start[i]; k < last.start[i + 1]; ++k) {
            const bool mirrors = !m_isSymmetric && m_coarsest.isLater(last.column[k], i);
            m_coarsest.pair(k) = mirrors ? mirrored(last.block[k]) : last.block[k];
        }
    return m_coarsest.factorize();
}

// Inverses of the blocks on the diagonal, by their adjugates.
bool Multigrid::invert(Level& level)
{
    for (std::size_t i = 0; i < level.diagonal.size(); ++i) {
        const auto& [x, y, z] = level.diagonal[i].column;
        const double a = x[0], b = x[1], c = x[2], d = y[1], e = y[2], f = z[2];
        const double A = d * f - e * e, B = c * e - b * f, C = b * e - c * d;
        const double determinant = a * A + b * B + c * C;
        if (!(a > 0.0) || !(a * d - b * b > 0.0) || !(determinant > 0.0))
            return false;
        const double s = 1.0 / determinant;
        const double D = (a * f - c * c) * s, E = (b * c - a * e) * s, F = (a * d - b * b) * s;
        level.inverse[i] =
            rounded({{{A * s, B * s, C * s, 0.0}, {B * s, D, E, 0.0}, {C * s, E, F, 0.0}}});
    }
    return true;
}

// Of a level that has no coarser one; makeCoarser() does so as it reads the blocks.
void Multigrid::roundBlocks(Level& level)
{
    for (std::size_t k = 0; k < level.rounded.size(); ++k)
        level.rounded[k] = rounded(level.block[k]);
}

// What makeCoarser() adds of the block k of row a, which is not symmetric.
void Multigrid::addMirrored(const Level& fine, std::size_t a, std::uint32_t k,
                            const std::uint32_t*& target, Level& coarse)
{
    const auto blocks = std::uint32_t(coarse.block.size());
    const std::size_t b = fine.column[k];
    const Block& block = fine.block[k];
    const Block mirror = mirrored(block);
    const auto add = [](Block& into, const Block& what, double weight) {
        for (int c = 0; c < 3; ++c)
            pack(into.column[c]) += pack(what.column[c]) * weight;
    };
    for (std::uint32_t i = fine.up.ofNode[a]; i < fine.up.ofNode[a + 1]; ++i)
        for (std::uint32_t j = fine.up.ofNode[b]; j < fine.up.ofNode[b + 1]; ++j) {
            const std::uint32_t to = *target++;
            const double weight = fine.up.weight[i] * fine.up.weight[j];
            if (to >= blocks) {
                add(coarse.diagonal[to - blocks], block, weight);
                add(coarse.diagonal[to - blocks], mirror, weight);
            } else {
                const bool isAbove = fine.up.coarse[i] < fine.up.coarse[j];
                add(coarse.block[to], isAbove ? block : mirror, weight);
            }
        }
}

RIPSTOP_CLONES
void Multigrid::makeCoarser(Level& fine, Level& coarse) const
{
    std::fill(coarse.block.begin(), coarse.block.end(), Block{});
    std::fill(coarse.diagonal.begin(), coarse.diagonal.end(), Block{});
    const std::uint32_t* target = fine.target.data();
    const auto blocks = std::uint32_t(coarse.block.size());
    const std::size_t nodes = fine.diagonal.size();
    for (std::size_t a = 0; a < nodes; ++a)
        for (std::uint32_t k = fine.start[a]; k < fine.start[a + 1]; ++k) {
            const std::size_t b = fine.column[k];
            if (!fine.rounded.empty())
                fine.rounded[k] = rounded(fine.block[k]);
            if (!m_isSymmetric) {
                addMirrored(fine, a, k, target, coarse);
                continue;
            }
            const Pack x = pack(fine.block[k].column[0]);
            const Pack y = pack(fine.block[k].column[1]);
            const Pack z = pack(fine.block[k].column[2]);
            for (std::uint32_t i = fine.up.ofNode[a]; i < fine.up.ofNode[a + 1]; ++i)
                for (std::uint32_t j = fine.up.ofNode[b]; j < fine.up.ofNode[b + 1]; ++j) {
                    const std::uint32_t to = *target++;
                    const bool isDiagonal = to >= blocks;
                    const double w =
                        fine.up.weight[i] * fine.up.weight[j] * (isDiagonal ? 2.0 : 1.0);
                    Block& into = isDiagonal ? coarse.diagonal[to - blocks] : coarse.block[to];
                    pack(into.column[0]) += x * w;
                    pack(into.column[1]) += y * w;
                    pack(into.column[2]) += z * w;
                }
        }
    for (std::size_t a = 0; a < nodes; ++a) {
        const Pack x = pack(fine.diagonal[a].column[0]);
        const Pack y = pack(fine.diagonal[a].column[1]);
        const Pack z = pack(fine.diagonal[a].column[2]);
        for (std::uint32_t i = fine.up.ofNode[a]; i < fine.up.ofNode[a + 1]; ++i)
            for (std::uint32_t j = i; j < fine.up.ofNode[a + 1]; ++j) {
                const std::uint32_t to = *target++;
                const double w = fine.up.weight[i] * fine.up.weight[j];
                Block& into = to >= blocks ? coarse.diagonal[to - blocks] : coarse.block[to];
                pack(into.column[0]) += x * w;
                pack(into.column[1]) += y * w;
                pack(into.column[2]) += z * w;
            }
    }
}

// The loops over a level, once for blocks that are symmetric and once for others.
template <bool symmetric>
RIPSTOP_INLINE double Multigrid::multiplyAs(const Level& level, const Row* x, Row* y)
{
    const std::size_t nodes = level.diagonal.size();
    Pack product{};
    for (std::size_t i = 0; i < nodes; ++i)
        pack(y[i].v) = times(level.diagonal[i], x[i]);
    for (std::size_t i = 0; i < nodes; ++i) {
        const Row own = x[i];
        Pack sum = pack(y[i].v);
        for (std::uint32_t k = level.start[i]; k < level.start[i + 1]; ++k) {
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
RIPSTOP_INLINE void Multigrid::forwardAs(Level& level, const AnyBlock* block, const Row* b)
{
    const std::size_t nodes = level.diagonal.size();
    const std::size_t lag = level.rounded.empty() ? nodes : level.reach;
    std::copy_n(b, lag, level.r.begin());
    for (std::size_t i = 0; i < nodes + lag; ++i) {
        if (i + lag < nodes)
            level.r[i + lag] = b[i + lag];
        if (i < nodes) {
            Row x;
            pack(x.v) = times(level.inverse[i], level.r[i]);
            level.x[i] = x;
            for (std::uint32_t k = level.start[i]; k < level.start[i + 1]; ++k)
                pack(level.r[level.column[k]].v) -= timesMirrored<symmetric>(block[k], x);
        }
        if (i < lag)
            continue;
        // what the sweep has left is what nodes to the right have moved since
        const std::size_t behind = i - lag;
        Pack left{};
        for (std::uint32_t k = level.start[behind]; k < level.start[behind + 1]; ++k)
            left -= times(block[k], level.x[level.column[k]]);
        pack(level.r[behind].v) = left;
    }
}

template <bool symmetric, class AnyBlock>
RIPSTOP_INLINE void Multigrid::backwardAs(Level& level, const AnyBlock* block, const Row* b)
{
    const std::size_t nodes = level.diagonal.size();
    const std::size_t lag = level.rounded.empty() ? nodes : level.reach;
    for (std::size_t ahead = nodes + lag; ahead-- > 0;) {
        if (ahead >= lag) {
            const std::size_t i = ahead - lag;
            level.r[i] = b[i];
            const Row x = level.x[i];
            for (std::uint32_t k = level.start[i]; k < level.start[i + 1]; ++k)
                pack(level.r[level.column[k]].v) -= timesMirrored<symmetric>(block[k], x);
        }
        if (ahead >= nodes)
            continue;
        Row left = level.r[ahead];
        for (std::uint32_t k = level.start[ahead]; k < level.start[ahead + 1]; ++k)
            pack(left.v) -= times(block[k], level.x[level.column[k]]);
        pack(level.x[ahead].v) = times(level.inverse[ahead], left);
    }
}

// y = A x. Returns x^T A x.
RIPSTOP_CLONES
double Multigrid::multiply(const Level& level, const Row* x, Row* y) const
{
    return m_isSymmetric ? multiplyAs<true>(level, x, y) : multiplyAs<false>(level, x, y);
}

// One sweep forth from x = 0 for A x = b, then r = b - A x. On large levels that is found as soon
// as the sweep has passed all neighbours, while their blocks are still near.
RIPSTOP_CLONES
void Multigrid::forward(Level& level, const Row* b) const
{
    if (level.rounded.empty())
        m_isSymmetric ? forwardAs<true>(level, level.block.data(), b)
                      : forwardAs<false>(level, level.block.data(), b);
    else
        m_isSymmetric ? forwardAs<true>(level, level.rounded.data(), b)
                      : forwardAs<false>(level, level.rounded.data(), b);
}

// One sweep back from x.
RIPSTOP_CLONES
void Multigrid::backward(Level& level, const Row* b) const
{
    if (level.rounded.empty())
        m_isSymmetric ? backwardAs<true>(level, level.block.data(), b)
                      : backwardAs<false>(level, level.block.data(), b);
    else
        m_isSymmetric ? backwardAs<true>(level, level.rounded.data(), b)
                      : backwardAs<false>(level, level.rounded.data(), b);
}

RIPSTOP_CLONES
void Multigrid::restrictTo(const Level& fine, Level& coarse)
{
    std::fill(coarse.b.begin(), coarse.b.end(), Row{});
    for (std::size_t i = 0; i < fine.diagonal.size(); ++i)
        for (std::uint32_t k = fine.up.ofNode[i]; k < fine.up.ofNode[i + 1]; ++k)
            pack(coarse.b[fine.up.coarse[k]].v) += fine.up.weight[k] * pack(fine.r[i].v);
}

RIPSTOP_CLONES
void Multigrid::prolongFrom(Level& fine, const Level& coarse)
{
    for (std::size_t i = 0; i < fine.diagonal.size(); ++i) {
        Pack x = pack(fine.x[i].v);
        for (std::uint32_t k = fine.up.ofNode[i]; k < fine.up.ofNode[i + 1]; ++k)
            x += fine.up.weight[k] * pack(coarse.x[fine.up.coarse[k]].v);
        pack(fine.x[i].v) = x;
    }
}

// Fills x of a level from a right-hand side.
void Multigrid::cycle(std::size_t l, const Row* b)
{
    Level& level = m_levels[l];
    const bool isLast = l + 1 == m_levels.size();
    if (isLast && m_factorises) {
        std::copy(b, b + level.x.size(), level.x.begin());
        m_coarsest.solve(level.x);
        return;
    }
    forward(level, b);
    if (!isLast) {
        Level& coarse = m_levels[l + 1];
        restrictTo(level, coarse);
        cycle(l + 1, coarse.b.data());
        prolongFrom(level, coarse);
    }
    backward(level, b);
}

double Multigrid::solve(std::span<Row> x, double goal, int mostIterations,
                        const std::function<void(std::span<Row>)>& keep)
{
    const std::size_t count = nodes();
    Level& finest = m_levels[0];
    std::copy(x.begin(), x.end(), m_r.begin());
    std::fill(m_x.begin(), m_x.end(), Row{});
    keep(m_r);
    double enough = goal * goal;
    double now = 0.0; // the square of the error's energy, as the cycle estimates it
    int taken = 0;
    for (double before = 0.0;; ++taken) {
        cycle(0, m_r.data());
        keep(finest.x);
        const Row* const z = finest.x.data();
        now = dotOf(m_r.data(), z, count);
        if (taken == 0)
            enough = std::max(enough, nothing * nothing * now);
        if (!(now > enough) || taken == mostIterations)
            break;
        const double fall = taken == 0 ? usualFall : std::max(now / before, usualFall);
        const double share = taken == 0 ? 0.0 : now / before;
        before = now;
        for (std::size_t i = 0; i < count; ++i)
            pack(m_p[i].v) = pack(z[i].v) + share * pack(m_p[i].v);
        const double step = now / multiply(finest, m_p.data(), m_q.data());
        keep(m_q); // and p has nothing of what that takes out
        for (std::size_t i = 0; i < count; ++i)
            pack(m_x[i].v) += step * pack(m_p[i].v);
        // The next cycle would show what is left. It is not needed where the fall so far tells it.
        if (now * fall * toSpare < enough) {
            now *= fall;
            ++taken;
            break;
        }
        for (std::size_t i = 0; i < count; ++i)
            pack(m_r[i].v) -= step * pack(m_q[i].v);
    }
    std::copy(m_x.begin(), m_x.end(), x.begin());
    m_iterations = taken;
    return std::sqrt(std::max(now, 0.0));
}

std::size_t Multigrid::blocks() const
{
    std::size_t count = 0;
    for (const Level& level : m_levels)
        count += level.block.size() + level.diagonal.size();
    return count;
}

} // namespace ripstop
