// Conjugate gradients over a hierarchy of coarser networks.
//
// analyze() makes the hierarchy (coarsening.h). factorize() fills the levels with numbers:
// makeCoarser() for each, and a factor of the last. solve() iterates; cycle() is one V
// through the levels, whose sweeps are in multigrid_sweeps.cpp. Loops over blocks are compiled for
// both kinds of machine and fuse nothing.
#include "constraints/multigrid_blocks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
    for (Level& level : m_levels)
        cutInStripes(level);
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

void Multigrid::cutInStripes(Level& level)
{
    const auto of = [&](std::size_t node) {
        return level.up.ofNode[node + 1] - level.up.ofNode[node];
    };
    Pattern pattern{level.start, level.column, {}, {}, level.target};
    std::vector<std::uint32_t> rowWrites{0}, selfWrites;
    if (!level.target.empty()) {
        for (std::size_t a = 0; a < level.diagonal.size(); ++a) {
            std::uint32_t count = 0;
            for (std::uint32_t k = level.start[a]; k < level.start[a + 1]; ++k)
                count += of(a) * of(level.column[k]);
            rowWrites.push_back(rowWrites.back() + count);
        }
        selfWrites.push_back(rowWrites.back());
        for (std::size_t a = 0; a < level.diagonal.size(); ++a)
            selfWrites.push_back(selfWrites.back() + of(a) * (of(a) + 1) / 2);
        pattern.rowWrites = rowWrites;
        pattern.selfWrites = selfWrites;
        pattern.targets = *std::ranges::max_element(level.target) + std::size_t(1);
    }
    level.stripes = stripesOf(pattern);
    level.part.assign(level.stripes.list.size(), 0.0);
}

void Multigrid::setZero(ThreadPool& pool)
{
    const auto fill = [&](std::vector<Block>& blocks) {
        pool.parallelFor(blocks.size(), [&](std::size_t first, std::size_t last) {
            std::fill(blocks.begin() + std::ptrdiff_t(first), blocks.begin() + std::ptrdiff_t(last),
                      Block{});
        });
    };
    fill(m_levels[0].block);
    fill(m_levels[0].diagonal);
}

bool Multigrid::factorize(ThreadPool& pool)
{
    for (std::size_t l = 0; l + 1 < m_levels.size(); ++l)
        if (!makeCoarser(m_levels[l], m_levels[l + 1], pool))
            return false;
    Level& last = m_levels.back();
    if (!m_factorises) {
        roundBlocks(last);
        return invert(last, pool);
    }
    m_coarsest.setZero(pool);
    for (std::size_t i = 0; i < last.diagonal.size(); ++i)
        m_coarsest.diagonal(i) = last.diagonal[i];
    for (std::size_t i = 0; i < last.diagonal.size(); ++i)
        for (std::uint32_t k = last.start[i]; k < last.start[i + 1]; ++k) {
            const bool mirrors = !m_isSymmetric && m_coarsest.isLater(last.column[k], i);
            m_coarsest.pair(k) = mirrors ? mirrored(last.block[k]) : last.block[k];
        }
    return m_coarsest.factorize(pool);
}

bool Multigrid::invert(Level& level, ThreadPool& pool)
{
    level.stripes.forEach(pool, [&](const Stripe& stripe) {
        level.part[level.stripes.placeOf(stripe)] = invertIn(level, stripe);
    });
    return isPositive(level);
}

bool Multigrid::isPositive(const Level& level)
{
    return std::ranges::all_of(level.part, [](double isInverted) { return isInverted != 0.0; });
}

// Inverses of the blocks on the diagonal, by their adjugates.
RIPSTOP_CLONES
bool Multigrid::invertIn(Level& level, const Stripe& stripe)
{
    for (std::size_t i = stripe.first; i < stripe.last; ++i) {
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

// Inverts the diagonal as well, while it is near; returns whether that could be.
bool Multigrid::makeCoarser(Level& fine, Level& coarse, ThreadPool& pool) const
{
    std::fill(coarse.block.begin(), coarse.block.end(), Block{});
    std::fill(coarse.diagonal.begin(), coarse.diagonal.end(), Block{});
    fine.stripes.forEachByColour(pool, [&](const Stripe& stripe) {
        fine.part[fine.stripes.placeOf(stripe)] = invertIn(fine, stripe);
        makeCoarserIn(fine, stripe, coarse);
    });
    return isPositive(fine);
}

RIPSTOP_CLONES
void Multigrid::makeCoarserIn(Level& fine, const Stripe& stripe, Level& coarse) const
{
    const std::uint32_t* target = fine.target.data() + stripe.pairTarget;
    const auto blocks = std::uint32_t(coarse.block.size());
    for (std::size_t a = stripe.first; a < stripe.last; ++a)
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
    target = fine.target.data() + stripe.nodeTarget;
    for (std::size_t a = stripe.first; a < stripe.last; ++a) {
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

void Multigrid::restrictTo(const Level& fine, Level& coarse, ThreadPool& pool)
{
    std::fill(coarse.b.begin(), coarse.b.end(), Row{});
    fine.stripes.forEachByColour(pool,
                                 [&](const Stripe& stripe) { restrictIn(fine, stripe, coarse); });
}

RIPSTOP_CLONES
void Multigrid::restrictIn(const Level& fine, const Stripe& stripe, Level& coarse)
{
    for (std::size_t i = stripe.first; i < stripe.last; ++i)
        for (std::uint32_t k = fine.up.ofNode[i]; k < fine.up.ofNode[i + 1]; ++k)
            pack(coarse.b[fine.up.coarse[k]].v) += fine.up.weight[k] * pack(fine.r[i].v);
}

void Multigrid::prolongFrom(Level& fine, const Level& coarse, ThreadPool& pool)
{
    pool.parallelFor(fine.diagonal.size(), [&](std::size_t first, std::size_t last) {
        prolongIn(fine, coarse, first, last);
    });
}

RIPSTOP_CLONES
void Multigrid::prolongIn(Level& fine, const Level& coarse, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        Pack x = pack(fine.x[i].v);
        for (std::uint32_t k = fine.up.ofNode[i]; k < fine.up.ofNode[i + 1]; ++k)
            x += fine.up.weight[k] * pack(coarse.x[fine.up.coarse[k]].v);
        pack(fine.x[i].v) = x;
    }
}

// Fills x of a level from a right-hand side.
void Multigrid::cycle(std::size_t l, const Row* b, ThreadPool& pool)
{
    Level& level = m_levels[l];
    const bool isLast = l + 1 == m_levels.size();
    if (isLast && m_factorises) {
        std::copy(b, b + level.x.size(), level.x.begin());
        m_coarsest.solve(level.x);
        return;
    }
    forward(level, b, pool);
    if (!isLast) {
        Level& coarse = m_levels[l + 1];
        restrictTo(level, coarse, pool);
        cycle(l + 1, coarse.b.data(), pool);
        prolongFrom(level, coarse, pool);
    }
    backward(level, b, pool);
}

double Multigrid::dot(const Row* a, const Row* b, ThreadPool& pool)
{
    Level& finest = m_levels[0];
    pool.forEach(finest.part.size(), [&](std::size_t i) {
        const Stripe& stripe = finest.stripes.list[i];
        finest.part[i] = dotOf(a + stripe.first, b + stripe.first, stripe.last - stripe.first);
    });
    return std::accumulate(finest.part.begin(), finest.part.end(), 0.0);
}

double Multigrid::solve(std::span<Row> x, double goal, int mostIterations,
                        const std::function<void(std::span<Row>)>& keep, ThreadPool& pool,
                        const Beyond& beyond)
{
    const std::size_t count = nodes();
    Level& finest = m_levels[0];
    std::copy(x.begin(), x.end(), m_r.begin());
    std::fill(m_x.begin(), m_x.end(), Row{});
    keep(m_r);
    double enough = goal * goal;
    double now = 0.0; // the square of the error's energy, as the cycle estimates it
    int taken = 0;
    bool isWhole = !beyond; // what is solved now
    // Goes on to the whole matrix where the blocks alone leave too much: the energy of the error is
    // at most x times what is beyond them.
    const auto isDone = [&] {
        if (isWhole)
            return true;
        isWhole = true;
        std::ranges::fill(m_q, Row{});
        const double root = std::sqrt(now) + std::sqrt(std::max(-beyond(m_x, m_q), 0.0));
        if (root * root <= enough) {
            now = root * root;
            return true;
        }
        for (std::size_t i = 0; i < count; ++i)
            pack(m_r[i].v) -= pack(m_q[i].v);
        return false;
    };
    for (double before = 0.0;; ++taken) {
        cycle(0, m_r.data(), pool);
        keep(finest.x);
        const Row* const z = finest.x.data();
        now = dot(m_r.data(), z, pool);
        if (taken == 0)
            enough = std::max(enough, nothing * nothing * now);
        const bool isNear = !(now > enough);
        if (isNear ? isDone() : taken >= mostIterations)
            break;
        if (isNear) {
            before = 0.0;
            continue;
        }
        const double fall = before == 0.0 ? usualFall : std::max(now / before, usualFall);
        const double share = before == 0.0 ? 0.0 : now / before;
        before = now;
        pool.parallelFor(count, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                pack(m_p[i].v) = pack(z[i].v) + share * pack(m_p[i].v);
        });
        double held = multiply(finest, m_p.data(), m_q.data(), pool);
        if (isWhole && beyond)
            held += beyond(m_p, m_q);
        const double step = now / held;
        keep(m_q); // and p has nothing of what that takes out
        pool.parallelFor(count, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                pack(m_x[i].v) += step * pack(m_p[i].v);
        });
        // The next cycle would show what is left. It is not needed where the fall so far tells it.
        const bool tells = now * fall * toSpare < enough;
        if (tells && isWhole) {
            now *= fall;
            ++taken;
            break;
        }
        pool.parallelFor(count, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                pack(m_r[i].v) -= step * pack(m_q[i].v);
        });
        if (!tells)
            continue;
        now *= fall;
        if (isDone()) {
            ++taken;
            break;
        }
        before = 0.0;
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
