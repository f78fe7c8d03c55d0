// Products of the blocks of a Multigrid with rows, in both precisions. All of it is made to be
// inlined into loops over a level.
#pragma once

#include "constraints/multigrid.h"

namespace ripstop {

RIPSTOP_INLINE Pack columnOf(const BlockCholesky::Block& block, int c)
{
    return pack(block.column[c]);
}

RIPSTOP_INLINE Pack columnOf(const Multigrid::RoundedBlock& block, int c)
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

RIPSTOP_INLINE Multigrid::RoundedBlock rounded(const BlockCholesky::Block& block)
{
    Multigrid::RoundedBlock result;
    for (int c = 0; c < 3; ++c)
        result.column[c] =
            __builtin_convertvector(columnOf(block, c), Multigrid::RoundedBlock::Column);
    return result;
}

RIPSTOP_INLINE BlockCholesky::Block mirrored(const BlockCholesky::Block& block)
{
    BlockCholesky::Block result{};
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            result.column[c][r] = block.column[r][c];
    return result;
}

} // namespace ripstop
