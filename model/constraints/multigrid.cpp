// Conjugate gradients over a hierarchy of coarser networks.
//
// analyze() makes the hierarchy from the pattern and the places alone: coarsen() keeps nodes,
// weighs the others by them (weightsAt) and finds where each product of P^T A P goes. factorize()
// fills the levels with numbers: makeCoarser() and invert() for each, and a factor of the last.
// solve() iterates; cycle() is one V through the levels. Loops over blocks are compiled for both
// kinds of machine and fuse nothing.
#include "constraints/multigrid.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ripstop {
namespace {

constexpr std::size_t smallEnough = 48; // nodes, of the coarsest level
constexpr std::size_t mostKept = 6;     // that a node moves by
constexpr std::size_t mostAnchors = 3;  // among them
constexpr double ridge = 0.05;          // of the squared distance: prefers even weights
constexpr double leastWeight = 0.05;
constexpr double offAtSeams = 0.25;
constexpr double nothing = 1e-5;   // of the energy's root
constexpr double usualFall = 0.02; // of the square of the error, in an iteration
constexpr double toSpare = 3.0;

using Block = BlockCholesky::Block;

RIPSTOP_INLINE double dot3(const double* a, const double* b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

RIPSTOP_INLINE Pack times(const Block& block, const Row& x)
{
    return pack(block.column[0]) * x.v[0] + pack(block.column[1]) * x.v[1]
           + pack(block.column[2]) * x.v[2];
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

struct Weighted
{
    int node; // kept, by its number on the fine level; anchors come after the nodes
    double weight;
};

struct Weights
{
    std::vector<Weighted> list;
    double off = 0.0; // 1, how far they put the node from where it is, over the way to the nearest
};

// Weights of sum 1 by which a node at `origin` moves as the kept ones beside it: those that put it
// nearest to where it is, as even as that allows, none of them negative.
Weights weightsAt(const Row& origin, std::vector<int> kept, std::size_t nodes,
                  std::span<const Row> place)
{
    const auto to = [&](int node) {
        const Row& p = place[std::size_t(node)];
        return Vec3(p.v[0] - origin.v[0], p.v[1] - origin.v[1], p.v[2] - origin.v[2]);
    };
    std::ranges::stable_sort(kept, {}, [&](int node) { return to(node).squaredNorm(); });
    std::size_t anchors = 0;
    std::erase_if(kept,
                  [&](int node) { return std::size_t(node) >= nodes && ++anchors > mostAnchors; });
    if (kept.size() > mostKept)
        kept.resize(mostKept);
    Eigen::VectorXd weight;
    for (;;) {
        const auto count = Eigen::Index(kept.size());
        Eigen::MatrixXd gram(count, count);
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index j = 0; j < count; ++j)
                gram(i, j) = to(kept[std::size_t(i)]).dot(to(kept[std::size_t(j)]));
        const double size = gram.trace() / double(count);
        for (Eigen::Index i = 0; i < count; ++i)
            gram(i, i) += ridge * size + std::numeric_limits<double>::min();
        weight = gram.llt().solve(Eigen::VectorXd::Ones(count));
        weight /= weight.sum();
        if (!weight.allFinite()) // all at one place
            weight.setConstant(count, 1.0 / double(count));
        Eigen::Index lowest = 0;
        if (count == 1 || weight.minCoeff(&lowest) >= leastWeight)
            break;
        kept.erase(kept.begin() + lowest);
    }
    Weights result;
    Vec3 off = Vec3::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < kept.size(); ++i) {
        result.list.push_back({kept[i], weight[Eigen::Index(i)]});
        off += weight[Eigen::Index(i)] * to(kept[i]);
        nearest = std::min(nearest, to(kept[i]).norm());
    }
    result.off = nearest > 0.0 ? off.norm() / nearest : 0.0;
    return result;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

void sortUnique(std::vector<Pair>& pairs)
{
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

} // namespace

// What a level is made from.
struct Multigrid::Graph
{
    std::size_t nodes = 0;
    std::vector<Pair> pairs;   // ascending, the lower node first, each once
    std::vector<Pair> anchors; // node and anchor, numbered from 0; ascending
    std::vector<Row> place;    // [nodes, then anchors] m

    // [nodes] neighbours in ascending order, anchors after the nodes.
    std::vector<std::vector<int>> neighbours() const
    {
        std::vector<std::vector<int>> result(nodes);
        for (const auto& [a, b] : pairs) {
            result[a].push_back(int(b));
            result[b].push_back(int(a));
        }
        for (auto& row : result)
            std::ranges::sort(row);
        for (const auto& [node, anchor] : anchors)
            result[node].push_back(int(nodes + anchor));
        return result;
    }
};

void Multigrid::analyze(std::size_t nodes, std::span<const std::pair<int, int>> pairs,
                        std::span<const std::pair<int, int>> anchors, std::span<const Row> place)
{
    Graph graph{nodes, {}, {}, {place.begin(), place.end()}};
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

    m_levels.clear();
    for (;;) {
        Level& level = m_levels.emplace_back();
        level.start.assign(graph.nodes + 1, 0);
        for (const auto& [a, b] : graph.pairs) {
            ++level.start[a + 1];
            level.column.push_back(b);
        }
        for (std::size_t i = 0; i < graph.nodes; ++i)
            level.start[i + 1] += level.start[i];
        level.block.assign(graph.pairs.size(), Block{});
        level.diagonal.assign(graph.nodes, Block{});
        for (auto* rows : {&level.x, &level.b, &level.r})
            rows->assign(graph.nodes, Row{});
        if (graph.nodes <= smallEnough)
            break;
        Graph coarse = coarsen(level, graph);
        if (coarse.nodes == 0 || coarse.nodes > graph.nodes * 4 / 5) { // no use
            level.ofNode.clear();
            break;
        }
        level.inverse.assign(graph.nodes, Block{});
        graph = std::move(coarse);
    }
    std::vector<std::pair<int, int>> last;
    for (const auto& [a, b] : graph.pairs)
        last.emplace_back(int(a), int(b));
    m_coarsest.analyze(graph.nodes, last);
    for (auto* rows : {&m_x, &m_r, &m_p, &m_q})
        rows->assign(nodes, Row{});
}

Multigrid::Graph Multigrid::coarsen(Level& fine, const Graph& graph)
{
    const std::vector<std::vector<int>> neighbours = graph.neighbours();
    std::vector<int> number(graph.nodes, -1); // on the next level, of what is kept
    std::vector<std::uint8_t> reached(graph.nodes, 0);
    Graph coarse;
    for (const auto& [node, anchor] : graph.anchors)
        reached[node] = 1;
    // Corners and edges have fewer neighbours: they come first, as nothing lies beyond them that
    // could tell how they move.
    std::vector<std::size_t> order(graph.nodes);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return neighbours[i].size(); });
    std::vector<std::uint8_t> isKept(graph.nodes, 0);
    for (const std::size_t i : order) {
        if (reached[i])
            continue;
        isKept[i] = reached[i] = 1;
        for (const int j : neighbours[i])
            if (std::size_t(j) < graph.nodes)
                reached[std::size_t(j)] = 1;
    }
    for (std::size_t i = 0; i < graph.nodes; ++i)
        if (isKept[i]) {
            number[i] = int(coarse.nodes++);
            coarse.place.push_back(graph.place[i]);
        }
    coarse.place.insert(coarse.place.end(), graph.place.begin() + std::ptrdiff_t(graph.nodes),
                        graph.place.end());

    fine.ofNode.assign(1, 0);
    fine.coarse.clear();
    fine.weight.clear();
    for (std::size_t i = 0; i < graph.nodes; ++i) {
        if (number[i] >= 0) {
            fine.coarse.push_back(std::uint32_t(number[i]));
            fine.weight.push_back(1.0);
        } else {
            const auto isCoarse = [&](int j) {
                return std::size_t(j) >= graph.nodes || number[std::size_t(j)] >= 0;
            };
            std::vector<int> kept;
            std::ranges::copy_if(neighbours[i], std::back_inserter(kept), isCoarse);
            Weights weights;
            if (!kept.empty())
                weights = weightsAt(graph.place[i], kept, graph.nodes, graph.place);
            if (weights.off > offAtSeams) { // where the kept ones of two sides meet out of step
                for (const int j : neighbours[i])
                    if (std::size_t(j) < graph.nodes)
                        std::ranges::copy_if(neighbours[std::size_t(j)], std::back_inserter(kept),
                                             isCoarse);
                std::ranges::sort(kept);
                kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
                Weights wider =
                    weightsAt(graph.place[i], std::move(kept), graph.nodes, graph.place);
                if (wider.off < weights.off)
                    weights = std::move(wider);
            }
            for (const Weighted& w : weights.list)
                if (std::size_t(w.node) < graph.nodes) {
                    fine.coarse.push_back(std::uint32_t(number[std::size_t(w.node)]));
                    fine.weight.push_back(w.weight);
                }
        }
        fine.ofNode.push_back(std::uint32_t(fine.coarse.size()));
    }

    const auto ofNode = [&](std::size_t i) {
        return std::span(fine.coarse).subspan(fine.ofNode[i], fine.ofNode[i + 1] - fine.ofNode[i]);
    };
    const auto eachPair = [&](auto visit) { // visit(I, J) in the order of makeCoarser()
        for (const auto& [a, b] : graph.pairs)
            for (const std::uint32_t i : ofNode(a))
                for (const std::uint32_t j : ofNode(b))
                    visit(std::min(i, j), std::max(i, j));
        for (std::size_t a = 0; a < graph.nodes; ++a)
            for (std::size_t i = fine.ofNode[a]; i < fine.ofNode[a + 1]; ++i)
                for (std::size_t j = i; j < fine.ofNode[a + 1]; ++j) {
                    const auto [low, high] = std::minmax(fine.coarse[i], fine.coarse[j]);
                    visit(low, high);
                }
    };
    eachPair([&](std::uint32_t i, std::uint32_t j) {
        if (i != j && (coarse.pairs.empty() || coarse.pairs.back() != Pair(i, j)))
            coarse.pairs.emplace_back(i, j);
    });
    sortUnique(coarse.pairs);
    for (const auto& [node, anchor] : graph.anchors)
        for (const std::uint32_t i : ofNode(node))
            coarse.anchors.emplace_back(i, anchor);
    sortUnique(coarse.anchors);

    // Diagonals of the next level are targets after its blocks.
    fine.target.clear();
    eachPair([&](std::uint32_t i, std::uint32_t j) {
        fine.target.push_back(i == j
                                  ? std::uint32_t(coarse.pairs.size() + i)
                                  : std::uint32_t(std::ranges::lower_bound(coarse.pairs, Pair(i, j))
                                                  - coarse.pairs.begin()));
    });
    return coarse;
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
    const Level& last = m_levels.back();
    m_coarsest.setZero();
    for (std::size_t i = 0; i < last.diagonal.size(); ++i)
        m_coarsest.diagonal(i) = last.diagonal[i];
    for (std::size_t k = 0; k < last.block.size(); ++k)
        m_coarsest.pair(k) = last.block[k];
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
        level.inverse[i] = {{{A * s, B * s, C * s, 0.0}, {B * s, D, E, 0.0}, {C * s, E, F, 0.0}}};
    }
    return true;
}

RIPSTOP_CLONES
void Multigrid::makeCoarser(const Level& fine, Level& coarse)
{
    std::fill(coarse.block.begin(), coarse.block.end(), Block{});
    std::fill(coarse.diagonal.begin(), coarse.diagonal.end(), Block{});
    const std::uint32_t* target = fine.target.data();
    const auto blocks = std::uint32_t(coarse.block.size());
    const std::size_t nodes = fine.diagonal.size();
    for (std::size_t a = 0; a < nodes; ++a)
        for (std::uint32_t k = fine.start[a]; k < fine.start[a + 1]; ++k) {
            const std::size_t b = fine.column[k];
            const Pack x = pack(fine.block[k].column[0]);
            const Pack y = pack(fine.block[k].column[1]);
            const Pack z = pack(fine.block[k].column[2]);
            for (std::uint32_t i = fine.ofNode[a]; i < fine.ofNode[a + 1]; ++i)
                for (std::uint32_t j = fine.ofNode[b]; j < fine.ofNode[b + 1]; ++j) {
                    const std::uint32_t to = *target++;
                    const bool isDiagonal = to >= blocks;
                    const double w = fine.weight[i] * fine.weight[j] * (isDiagonal ? 2.0 : 1.0);
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
        for (std::uint32_t i = fine.ofNode[a]; i < fine.ofNode[a + 1]; ++i)
            for (std::uint32_t j = i; j < fine.ofNode[a + 1]; ++j) {
                const std::uint32_t to = *target++;
                const double w = fine.weight[i] * fine.weight[j];
                Block& into = to >= blocks ? coarse.diagonal[to - blocks] : coarse.block[to];
                pack(into.column[0]) += x * w;
                pack(into.column[1]) += y * w;
                pack(into.column[2]) += z * w;
            }
    }
}

// y = A x
RIPSTOP_CLONES
void Multigrid::multiply(const Level& level, const Row* x, Row* y)
{
    const std::size_t nodes = level.diagonal.size();
    for (std::size_t i = 0; i < nodes; ++i)
        pack(y[i].v) = times(level.diagonal[i], x[i]);
    for (std::size_t i = 0; i < nodes; ++i) {
        const Row own = x[i];
        Pack sum = pack(y[i].v);
        for (std::uint32_t k = level.start[i]; k < level.start[i + 1]; ++k) {
            const Block& block = level.block[k];
            const std::uint32_t j = level.column[k];
            sum += times(block, x[j]);
            pack(y[j].v) += times(block, own);
        }
        pack(y[i].v) = sum;
    }
}

// One sweep forth from x = 0 for A x = b, then r = b - A x.
RIPSTOP_CLONES
void Multigrid::forward(Level& level)
{
    const std::size_t nodes = level.diagonal.size();
    std::copy(level.b.begin(), level.b.end(), level.r.begin());
    for (std::size_t i = 0; i < nodes; ++i) {
        Row x;
        pack(x.v) = times(level.inverse[i], level.r[i]);
        level.x[i] = x;
        for (std::uint32_t k = level.start[i]; k < level.start[i + 1]; ++k)
            pack(level.r[level.column[k]].v) -= times(level.block[k], x);
    }
    // what the sweep has left is what nodes to the right have moved since
    for (std::size_t i = 0; i < nodes; ++i) {
        Pack left{};
        for (std::uint32_t k = level.start[i]; k < level.start[i + 1]; ++k)
            left -= times(level.block[k], level.x[level.column[k]]);
        pack(level.r[i].v) = left;
    }
}

// One sweep back from x.
RIPSTOP_CLONES
void Multigrid::backward(Level& level)
{
    const std::size_t nodes = level.diagonal.size();
    std::copy(level.b.begin(), level.b.end(), level.r.begin());
    for (std::size_t i = 0; i < nodes; ++i) {
        const Row x = level.x[i];
        for (std::uint32_t k = level.start[i]; k < level.start[i + 1]; ++k)
            pack(level.r[level.column[k]].v) -= times(level.block[k], x);
    }
    for (std::size_t i = nodes; i-- > 0;) {
        Row left = level.r[i];
        for (std::uint32_t k = level.start[i]; k < level.start[i + 1]; ++k)
            pack(left.v) -= times(level.block[k], level.x[level.column[k]]);
        pack(level.x[i].v) = times(level.inverse[i], left);
    }
}

RIPSTOP_CLONES
void Multigrid::restrictTo(const Level& fine, Level& coarse)
{
    std::fill(coarse.b.begin(), coarse.b.end(), Row{});
    for (std::size_t i = 0; i < fine.diagonal.size(); ++i)
        for (std::uint32_t k = fine.ofNode[i]; k < fine.ofNode[i + 1]; ++k)
            pack(coarse.b[fine.coarse[k]].v) += fine.weight[k] * pack(fine.r[i].v);
}

RIPSTOP_CLONES
void Multigrid::prolongFrom(Level& fine, const Level& coarse)
{
    for (std::size_t i = 0; i < fine.diagonal.size(); ++i) {
        Pack x = pack(fine.x[i].v);
        for (std::uint32_t k = fine.ofNode[i]; k < fine.ofNode[i + 1]; ++k)
            x += fine.weight[k] * pack(coarse.x[fine.coarse[k]].v);
        pack(fine.x[i].v) = x;
    }
}

// Fills x of a level from its b.
void Multigrid::cycle(std::size_t l)
{
    Level& level = m_levels[l];
    if (l + 1 == m_levels.size()) {
        std::copy(level.b.begin(), level.b.end(), level.x.begin());
        m_coarsest.solve(level.x);
        return;
    }
    forward(level);
    restrictTo(level, m_levels[l + 1]);
    cycle(l + 1);
    prolongFrom(level, m_levels[l + 1]);
    backward(level);
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
        std::copy(m_r.begin(), m_r.end(), finest.b.begin());
        cycle(0);
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
        multiply(finest, m_p.data(), m_q.data());
        keep(m_q);
        const double step = now / dotOf(m_p.data(), m_q.data(), count);
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
