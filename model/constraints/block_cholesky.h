// Cholesky factorisation of symmetric matrices of 3 x 3 blocks with a fixed pattern.
//
// The pattern is analysed once: an order of little fill (approximate minimum degree, from Eigen)
// and the place that every product of blocks goes to. Factorising is then a walk along that list,
// without a search and without touching the heap, and with the same bits on every machine: vector
// instructions work on the columns of blocks, and no operation is fused. Threads share the columns;
// each is gathered in the same order by whoever takes it, so that their number changes no bit.
#pragma once

#include "parallel/simd_pack.h"
#include "parallel/thread_pool.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ripstop {

class BlockCholesky
{
public:
    struct alignas(32) Block
    {
        double column[3][4]; // the fourth row is zero
    };

    // What a column takes from an earlier one: the products of a block with itself and with those
    // below it.
    struct Source
    {
        std::uint32_t column; // the earlier one
        std::uint32_t block;
        std::uint32_t count;     // of products
        std::size_t firstTarget; // of theirs
    };

    // So much in one place of the diagonal, to be added to its column in one piece.
    static RIPSTOP_INLINE Pack diagonalPart(int column, double value)
    {
        return Pack{column == 0 ? value : 0.0, column == 1 ? value : 0.0, column == 2 ? value : 0.0,
                    0.0};
    }

    // Analyses a pattern, which takes memory; nothing else does. `pairs` are the places off the
    // diagonal, in any order, each pair of nodes once or more.
    void analyze(std::size_t nodes, std::span<const std::pair<int, int>> pairs);

    // How many products of blocks a factorisation takes, without analysing all of it: it needs the
    // memory of the pattern and the time of as many blocks as the factor has.
    static double countProducts(std::size_t nodes, std::span<const std::pair<int, int>> pairs);

    // Filling the matrix: set it to zero, then add symmetric blocks.
    void setZero(ThreadPool& pool);
    Block& diagonal(std::size_t node) { return m_block[m_diagonal[node]]; }
    // The rows of a pair's block are those of the node that is eliminated later.
    bool isLater(std::size_t node, std::size_t other) const
    {
        return m_place[node] > m_place[other];
    }
    Block& pair(std::size_t index) { return m_block[m_pair[index]]; }

    // Puts the factor in place of the matrix. Returns false when the matrix is not positive
    // definite.
    [[nodiscard]] bool factorize(ThreadPool& pool);

    // Solves for `x`, [nodes], given the right-hand side in it.
    void solve(std::span<Row> x);

    // Threads share a factorisation that takes as many products: two of them lose with a fifth of a
    // million, win nothing with two, and are 1.5 times as fast with ten.
    static constexpr std::size_t productsOfThreads = 5'000'000;

    std::size_t blocks() const { return m_block.size(); }    // of the factor, fill included
    std::size_t products() const { return m_target.size(); } // of blocks, in factorize()

private:
    void listSources();
    void shareOut();
    std::span<const Source> sourcesOf(std::size_t column) const
    {
        return std::span(m_source).subspan(m_sources[column],
                                           m_sources[column + 1] - m_sources[column]);
    }
    bool factorizeAlone();
    void factorizeShares();
    bool factorizeWithOthers(std::size_t column);
    bool isDone(std::uint32_t column);
    bool await(std::uint32_t column);
    void takeProducts(std::span<const Source> sources);
    bool finishColumn(std::size_t column);
    static void solve(std::size_t nodes, const std::uint32_t* start, const std::uint32_t* row,
                      Block* block, Row* x);

    std::vector<std::uint32_t> m_place;    // [nodes] row in the order of elimination
    std::vector<std::uint32_t> m_start;    // [nodes + 1] columns; each begins with its diagonal
    std::vector<std::uint32_t> m_row;      // [blocks]
    std::vector<std::uint32_t> m_diagonal; // [nodes] block
    std::vector<std::uint32_t> m_pair;     // [pairs] block
    std::vector<std::uint32_t> m_target;   // [products] block, in the order of elimination
    std::vector<Source> m_source;          // [blocks below the diagonal] by the column that takes
    std::vector<std::uint32_t> m_sources;  // [nodes + 1] first of each column
    std::vector<std::uint32_t> m_share;    // [shares + 1] columns that one thread takes at a time
    std::vector<std::uint32_t> m_done;     // [nodes] the round in which it was factorised last
    std::uint32_t m_round = 0;
    std::uint32_t m_nextShare = 0;
    std::uint32_t m_hasFailed = 0;
    std::vector<Block> m_block; // [blocks] the matrix, then its factor
    std::vector<Row> m_x;       // [nodes] scratch
};

} // namespace ripstop
