// Three particles that share an energy, as the direct solver has them (direct_solver.h): what a
// panel or the bend of a spar is to its matrix.
#pragma once

#include "base/vec3.h"
#include "constraints/block_cholesky.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ripstop {

inline constexpr std::array<std::pair<std::size_t, std::size_t>, 3> sidesOfTriple{
    {{0, 1}, {1, 2}, {2, 0}}};

struct Triple
{
    std::array<std::uint32_t, 3> row{};    // of the solver's positions; pins come last
    std::array<int, 3> pair{{-1, -1, -1}}; // in the matrix, by side; -1 where an end is pinned
    bool gone = false;
};

inline std::uint32_t firstRow(const Triple& triple)
{
    return std::min({triple.row[0], triple.row[1], triple.row[2]});
}

// What one adds to the matrix and to the right-hand side.
struct TripleBlock
{
    std::array<BlockCholesky::Block, 3> corner; // on the diagonal
    std::array<BlockCholesky::Block, 3> pair;   // by side: rows of the first corner, columns of the
                                                // second
    std::array<Row, 3> pull;                    // kg m
};

inline BlockCholesky::Block blockOf(const Mat3& value)
{
    BlockCholesky::Block block;
    for (int c = 0; c < 3; ++c)
        pack(block.column[c]) = Pack{value(0, c), value(1, c), value(2, c), 0.0};
    return block;
}

inline Mat3 matrixOf(const BlockCholesky::Block& block)
{
    Mat3 matrix;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            matrix(r, c) = block.column[c][r];
    return matrix;
}

RIPSTOP_INLINE BlockCholesky::Block transposed(const BlockCholesky::Block& a)
{
    const Pack x = pack(a.column[0]), y = pack(a.column[1]), z = pack(a.column[2]);
    const Pack xy02 = __builtin_shufflevector(x, y, 0, 4, 2, 6);
    const Pack xy1 = __builtin_shufflevector(x, y, 1, 5, 3, 7);
    const Pack z02 = __builtin_shufflevector(z, Pack{}, 0, 4, 2, 6);
    const Pack z1 = __builtin_shufflevector(z, Pack{}, 1, 5, 3, 7);
    BlockCholesky::Block t;
    pack(t.column[0]) = __builtin_shufflevector(xy02, z02, 0, 1, 4, 5);
    pack(t.column[1]) = __builtin_shufflevector(xy1, z1, 0, 1, 4, 5);
    pack(t.column[2]) = __builtin_shufflevector(xy02, z02, 2, 3, 6, 7);
    return t;
}

// Adds the sides between two of the first `nodes` rows to the pairs of the matrix.
inline void numberPairs(Triple& triple, std::size_t nodes, std::vector<std::pair<int, int>>& pairs)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triple.row[sidesOfTriple[k].first];
        const std::uint32_t to = triple.row[sidesOfTriple[k].second];
        triple.pair[k] = -1;
        if (from >= nodes || to >= nodes)
            continue;
        triple.pair[k] = int(pairs.size());
        pairs.emplace_back(from, to);
    }
}

} // namespace ripstop
