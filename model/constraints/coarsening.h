// The next coarser network of a network, for multigrid.h: which nodes it keeps, how the others move
// by them, and which products make its matrix.
//
//   - Nodes are kept that are not neighbours of each other, those with few neighbours first:
//   corners
//     and edges, as nothing lies beyond them. Anchors, which are held, are kept on every level.
//   - A node that is not kept moves as the kept ones beside it tell, by weights of sum 1 that put
//   it
//     nearest to where it is, as even as that allows and none of them negative. Motions that are
//     linear in the place, rotations among them, come back as they are so far as there are kept
//     ones on all sides; where two sides meet out of step, those one further are asked as well.
//
// All of it follows from pattern and places: the same network gives the same answer.
#pragma once

#include "parallel/simd_pack.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ripstop {

struct NetworkGraph
{
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    std::size_t nodes = 0;
    std::vector<Pair> pairs;   // ascending, the lower node first, each once
    std::vector<Pair> anchors; // node and anchor, numbered from 0; ascending
    std::vector<Row> place;    // [nodes, then anchors] m
};

// How the nodes of a level move by those of the next.
struct Prolongation
{
    std::vector<std::uint32_t>
        ofNode; // [nodes + 1] places in what follows; empty for no next level
    std::vector<std::uint32_t> coarse; // node of the next level
    std::vector<double> weight;        // 1
};

struct Coarsening
{
    NetworkGraph graph; // of the next level
    Prolongation up;
    // Where the products of P^T A P go on the next level, for the pairs of the network and then for
    // its nodes, in the order of `up`: a pair of its graph, or, after those, a node.
    std::vector<std::uint32_t> target;
};

Coarsening coarsened(const NetworkGraph& network);

} // namespace ripstop
