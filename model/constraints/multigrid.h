// Solves systems with symmetric positive definite matrices of symmetric 3 x 3 blocks, as those of
// fabric, in a time that grows like their size: conjugate gradients with a multigrid cycle as its
// preconditioner.
//
// Stiff fabric passes a pull on over its whole length. An iteration that passes it on from
// neighbour to neighbour needs as many rounds as the fabric has cells across; a hierarchy of
// coarser fabrics needs a few, however fine the mesh (Tamstorf, Jones and McCormick 2015 for
// cloth).
//
//   - A level keeps about one node of four on sheets, one of two on lines; the others move as these
//     tell (coarsening.h).
//   - The coarse matrix is P^T A P (Galerkin). P has one number for each pair of nodes, so that
//     blocks that are symmetric stay so, as those of networks; those of panels are not.
//   - A cycle is one sweep of block Gauss-Seidel forth before the coarser level and one back after
//     it; the coarsest level is factorised. Being symmetric it suits conjugate gradients.
//   - A large network whose nodes are all tied to what is held has no coarser one and needs none:
//     sweeps alone are quick there.
//
// The pattern, the weights and the order of all sums are those of analyze(): the same numbers give
// the same bits, at any number of threads (stripes.h). Nothing is kept from one solve() to the
// next.
#pragma once

#include "constraints/block_cholesky.h"
#include "constraints/coarsening.h"
#include "constraints/stripes.h"
#include "parallel/thread_pool.h"

#include <functional>

namespace ripstop {

class Multigrid
{
public:
    using Block = BlockCholesky::Block;

    // A block in single precision: half of what there is to fetch, and a preconditioner need not be
    // exact.
    struct RoundedBlock
    {
        using Column = float __attribute__((vector_size(16)));
        Column column[3];
    };

    // Analyses a pattern, which takes memory; nothing else does.
    //   pairs    places off the diagonal, each pair of nodes once or more, in any order
    //   anchors  pairs of a node and something that is held, numbered from `nodes` on
    //   place    [nodes, then what is held]  m, where the weights of the levels come from
    //   symmetric  whether the blocks of pairs are; it saves time where they are
    void analyze(std::size_t nodes, std::span<const std::pair<int, int>> pairs,
                 std::span<const std::pair<int, int>> anchors, std::span<const Row> place,
                 bool symmetric = true);

    // Filling the matrix: set it to zero, then add blocks. The rows of a pair's block are those of
    // the lower node. Threads that fill in what belongs to stripes of one colour do not meet.
    void setZero(ThreadPool& pool);
    Block& diagonal(std::size_t node) { return m_levels[0].diagonal[node]; }
    Block& pair(std::size_t index) { return m_levels[0].block[m_pair[index]]; }

    const Stripes& stripes() const { return m_levels[0].stripes; } // of the nodes

    // Makes the coarser levels of the matrix. Returns false when the matrix is not positive
    // definite.
    [[nodiscard]] bool factorize(ThreadPool& pool);

    // Solves for `x`, [nodes], given the right-hand side in it, until the error of x, as its energy
    // sqrt(e^T A e) is estimated by the cycle, is at most `goal` or next to nothing of that of 0.
    // Returns that estimate of the error that is left; iterations() tells how many it took.
    //   keep    takes out of rows, [nodes], what x may not have; a projection
    //   beyond  adds to y what else the matrix is than its blocks, times x, and returns x times
    //           that; symmetric and not positive, so that the blocks are a bound. It is asked only
    //           where the error without it may matter. Or empty
    using Beyond = std::function<double(std::span<const Row> x, std::span<Row> y)>;
    double solve(std::span<Row> x, double goal, int mostIterations,
                 const std::function<void(std::span<Row>)>& keep, ThreadPool& pool,
                 const Beyond& beyond = {});

    int iterations() const { return m_iterations; } // of the last solve()

    std::size_t nodes() const { return m_levels.empty() ? 0 : m_levels[0].diagonal.size(); }
    std::size_t levels() const { return m_levels.size(); }
    std::size_t blocks() const; // of all levels

private:
    struct Level
    {
        std::vector<std::uint32_t> start;  // [nodes + 1] blocks of each row, right of the diagonal
        std::vector<std::uint32_t> column; // [blocks] ascending in each row
        std::vector<Block> block;          // [blocks]
        std::vector<Block> diagonal;       // [nodes]
        std::vector<RoundedBlock> rounded; // [blocks] what sweeps read; of large levels
        std::vector<RoundedBlock> inverse; // [nodes] of the diagonal
        std::size_t reach = 0;             // nodes, from a row to the furthest of its columns
        Stripes stripes;                   // of the nodes
        std::vector<double> part;          // [stripes] scratch of sums
        Prolongation up;                   // to the next level
        std::vector<std::uint32_t> target; // of products there
        std::vector<Row> x, b, r;          // [nodes] scratch of the cycle
    };

    static void cutInStripes(Level& level);
    bool makeCoarser(Level& fine, Level& coarse, ThreadPool& pool) const;
    void makeCoarserIn(Level& fine, const Stripe& stripe, Level& coarse) const;
    static void addMirrored(const Level& fine, std::size_t a, std::uint32_t k,
                            const std::uint32_t*& target, Level& coarse);
    template <bool symmetric>
    static double multiplyAs(const Level& level, const Stripe& stripe, const Row* x, Row* y);
    template <bool symmetric, class AnyBlock>
    static void forwardAs(Level& level, const Stripe& stripe, const AnyBlock* block, const Row* b);
    template <bool symmetric, class AnyBlock>
    static void finishAs(Level& level, const Stripe& stripe, const AnyBlock* block);
    template <bool symmetric, class AnyBlock>
    static void backwardAs(Level& level, const Stripe& stripe, const AnyBlock* block, const Row* b);
    void cycle(std::size_t level, const Row* b, ThreadPool& pool);
    static bool invert(Level& level, ThreadPool& pool);
    static bool isPositive(const Level& level); // of the last time it was inverted
    static bool invertIn(Level& level, const Stripe& stripe);
    static void roundBlocks(Level& level);
    double multiply(Level& level, const Row* x, Row* y, ThreadPool& pool) const;
    double multiplyIn(const Level& level, const Stripe& stripe, const Row* x, Row* y) const;
    void forward(Level& level, const Row* b, ThreadPool& pool) const;
    void forwardIn(Level& level, const Stripe& stripe, const Row* b) const;
    void finishIn(Level& level, const Stripe& stripe) const;
    void backward(Level& level, const Row* b, ThreadPool& pool) const;
    void backwardIn(Level& level, const Stripe& stripe, const Row* b) const;
    static void restrictTo(const Level& fine, Level& coarse, ThreadPool& pool);
    static void restrictIn(const Level& fine, const Stripe& stripe, Level& coarse);
    static void prolongFrom(Level& fine, const Level& coarse, ThreadPool& pool);
    static void prolongIn(Level& fine, const Level& coarse, std::size_t first, std::size_t last);
    double dot(const Row* a, const Row* b, ThreadPool& pool); // over the nodes

    std::vector<Level> m_levels;       // the finest first
    std::vector<std::uint32_t> m_pair; // [pairs] block of the finest level
    int m_iterations = 0;
    bool m_isSymmetric = true;           // each block of a pair
    bool m_factorises = true;            // the last level
    BlockCholesky m_coarsest;            // of the last level
    std::vector<Row> m_x, m_r, m_p, m_q; // [nodes] of conjugate gradients
};

} // namespace ripstop
