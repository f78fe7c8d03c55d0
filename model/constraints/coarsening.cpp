// coarsened() walks through the network five times: what is kept (in the order of few neighbours),
// its numbers, the weights of all others (weightsOf, of which weightsAt is the small problem of one
// node), the pattern of the next level, and the targets of products in it.
#include "constraints/coarsening.h"

#include "base/vec3.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace ripstop {
namespace {

constexpr std::size_t mostKept = 6;    // that a node moves by
constexpr std::size_t mostAnchors = 3; // among them
constexpr double ridge = 0.05;         // of the squared distance: prefers even weights
constexpr double leastWeight = 0.05;
constexpr double offAtSeams = 0.25;

using Pair = NetworkGraph::Pair;

void sortUnique(std::vector<Pair>& pairs)
{
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

// [nodes] neighbours in ascending order, anchors after the nodes.
std::vector<std::vector<int>> neighboursOf(const NetworkGraph& graph)
{
    std::vector<std::vector<int>> result(graph.nodes);
    for (const auto& [a, b] : graph.pairs) {
        result[a].push_back(int(b));
        result[b].push_back(int(a));
    }
    for (auto& row : result)
        std::ranges::sort(row);
    for (const auto& [node, anchor] : graph.anchors)
        result[node].push_back(int(graph.nodes + anchor));
    return result;
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

// Of a node that is not kept. `number` is -1 for others like it.
Weights weightsOf(std::size_t i, const NetworkGraph& graph,
                  const std::vector<std::vector<int>>& neighbours, const std::vector<int>& number)
{
    const auto isKept = [&](int j) {
        return std::size_t(j) >= graph.nodes || number[std::size_t(j)] >= 0;
    };
    std::vector<int> kept;
    std::ranges::copy_if(neighbours[i], std::back_inserter(kept), isKept);
    if (kept.empty())
        return {};
    Weights weights = weightsAt(graph.place[i], kept, graph.nodes, graph.place);
    if (weights.off <= offAtSeams)
        return weights;
    for (const int j : neighbours[i])
        if (std::size_t(j) < graph.nodes)
            std::ranges::copy_if(neighbours[std::size_t(j)], std::back_inserter(kept), isKept);
    std::ranges::sort(kept);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    Weights wider = weightsAt(graph.place[i], std::move(kept), graph.nodes, graph.place);
    return wider.off < weights.off ? wider : weights;
}

} // namespace

Coarsening coarsened(const NetworkGraph& graph)
{
    Coarsening result;
    NetworkGraph& coarse = result.graph;
    Prolongation& fine = result.up;
    const std::vector<std::vector<int>> neighbours = neighboursOf(graph);
    std::vector<int> number(graph.nodes, -1); // on the next level, of what is kept
    std::vector<std::uint8_t> reached(graph.nodes, 0);
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
    for (std::size_t i = 0; i < graph.nodes; ++i) {
        if (number[i] >= 0) {
            fine.coarse.push_back(std::uint32_t(number[i]));
            fine.weight.push_back(1.0);
        } else {
            const Weights weights = weightsOf(i, graph, neighbours, number);
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
    const auto eachPair = [&](auto visit) { // visit(I, J) in the order of Multigrid::makeCoarser()
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

    eachPair([&](std::uint32_t i, std::uint32_t j) {
        result.target.push_back(
            i == j ? std::uint32_t(coarse.pairs.size() + i)
                   : std::uint32_t(std::ranges::lower_bound(coarse.pairs, Pair(i, j))
                                   - coarse.pairs.begin()));
    });
    return result;
}

} // namespace ripstop
