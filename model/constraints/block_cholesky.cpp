// A sparse factorisation by 3 x 3 blocks, in three stages that are called at different rates.
//
// analyze() once for a pattern: the order of elimination, the rows of each column with its fill
// (which a column hands on to its parent in the elimination tree), and the block that every product
// goes to. factorize() in each iteration: column after column, each takes the products of the
// earlier ones along the list, factorises its block on the diagonal and divides those below by it.
// Threads take shares of columns in their order and wait for earlier columns where they must; far
// down in the elimination they hardly do, and further up each works while the other ends the column
// before. solve() goes forward through the columns and back again. Searching and memory are left to
// the first stage, so that the others are plain loops in a fixed order.
#include "constraints/block_cholesky.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

namespace ripstop {
namespace {

using Block = BlockCholesky::Block;

constexpr std::size_t productsOfShare = 256; // of blocks; some microseconds
constexpr int patientLooks = 2000;           // some microseconds

std::vector<std::uint32_t> eliminationOrder(std::size_t nodes,
                                            std::span<const std::pair<int, int>> pairs)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < nodes; ++i)
        entries.emplace_back(int(i), int(i), 1.0);
    for (const auto& [i, j] : pairs) {
        entries.emplace_back(i, j, 1.0);
        entries.emplace_back(j, i, 1.0);
    }
    const auto size = Eigen::Index(nodes);
    Eigen::SparseMatrix<double> pattern(size, size);
    pattern.setFromTriplets(entries.begin(), entries.end());
    Eigen::AMDOrdering<int>::PermutationType order;
    Eigen::AMDOrdering<int>()(pattern, order);
    // Eigen gives, for each step of the elimination, the node.
    std::vector<std::uint32_t> place(nodes);
    for (std::size_t k = 0; k < nodes; ++k)
        place[std::size_t(order.indices()[Eigen::Index(k)])] = std::uint32_t(k);
    return place;
}

// Puts the lower Cholesky factor of a 3 x 3 block in its place, with the inverses of its diagonal.
// Returns false when the block is not positive definite.
RIPSTOP_INLINE bool factorizeBlock(Block& a)
{
    auto& [x, y, z] = a.column;
    if (!(x[0] > 0.0))
        return false;
    x[0] = 1.0 / __builtin_sqrt(x[0]);
    x[1] *= x[0];
    x[2] *= x[0];
    const double second = y[1] - x[1] * x[1];
    if (!(second > 0.0))
        return false;
    y[1] = 1.0 / __builtin_sqrt(second);
    y[2] = (y[2] - x[2] * x[1]) * y[1];
    const double third = z[2] - x[2] * x[2] - y[2] * y[2];
    if (!(third > 0.0))
        return false;
    z[2] = 1.0 / __builtin_sqrt(third);
    return true;
}

// b <- b L^-T
RIPSTOP_INLINE void divideByTransposed(Block& b, const Block& l)
{
    const Pack x = pack(b.column[0]) * l.column[0][0];
    const Pack y = (pack(b.column[1]) - x * l.column[0][1]) * l.column[1][1];
    const Pack z = (pack(b.column[2]) - x * l.column[0][2] - y * l.column[1][2]) * l.column[2][2];
    pack(b.column[0]) = x;
    pack(b.column[1]) = y;
    pack(b.column[2]) = z;
}

// The block `right` of a column takes its products with the blocks from itself on down the column
// from later blocks: target -= left right^T.
RIPSTOP_INLINE void subtractProducts(Block* left, std::size_t count, const Block& right,
                                     const std::uint32_t* target, Block* block)
{
    double r[3][3];
    for (int k = 0; k < 3; ++k)
        for (int c = 0; c < 3; ++c)
            r[k][c] = right.column[k][c];
    for (std::size_t i = 0; i < count; ++i) {
        const Pack x = pack(left[i].column[0]);
        const Pack y = pack(left[i].column[1]);
        const Pack z = pack(left[i].column[2]);
        Block& into = block[target[i]];
        for (int c = 0; c < 3; ++c)
            pack(into.column[c]) -= x * r[0][c] + y * r[1][c] + z * r[2][c];
    }
}

RIPSTOP_INLINE void take(std::span<const BlockCholesky::Source> sources,
                         const std::uint32_t* target, Block* block)
{
    for (const BlockCholesky::Source& source : sources) {
        Block* const left = block + source.block;
        subtractProducts(left, source.count, *left, target + source.firstTarget, block);
    }
}

// The column from its diagonal on, when all products have been taken.
RIPSTOP_INLINE bool finish(Block* diagonal, Block* last)
{
    if (!factorizeBlock(*diagonal))
        return false;
    for (Block* b = diagonal + 1; b < last; ++b)
        divideByTransposed(*b, *diagonal);
    return true;
}

RIPSTOP_INLINE void forward(const Block& l, double* x)
{
    x[0] *= l.column[0][0];
    x[1] = (x[1] - l.column[0][1] * x[0]) * l.column[1][1];
    x[2] = (x[2] - l.column[0][2] * x[0] - l.column[1][2] * x[1]) * l.column[2][2];
}

RIPSTOP_INLINE void backward(const Block& l, double* x)
{
    x[2] *= l.column[2][2];
    x[1] = (x[1] - l.column[1][2] * x[2]) * l.column[1][1];
    x[0] = (x[0] - l.column[0][1] * x[1] - l.column[0][2] * x[2]) * l.column[0][0];
}

} // namespace

// A row of the factor has a block in each column on the way up the elimination tree from its
// entries in the matrix to itself (Liu 1990).
double BlockCholesky::countProducts(std::size_t nodes, std::span<const std::pair<int, int>> pairs)
{
    const std::vector<std::uint32_t> place = eliminationOrder(nodes, pairs);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> entries; // row, column left of it
    for (const auto& pair : pairs) {
        const auto [low, high] =
            std::minmax({place[std::size_t(pair.first)], place[std::size_t(pair.second)]});
        entries.emplace_back(high, low);
    }
    std::ranges::sort(entries);
    constexpr auto none = std::uint32_t(-1);
    std::vector<std::uint32_t> parent(nodes, none), reachedBy(nodes, none);
    std::vector<std::uint32_t> below(nodes, 0); // blocks below the diagonal of each column
    for (const auto& [row, column] : entries) {
        reachedBy[row] = row;
        for (std::uint32_t k = column; reachedBy[k] != row; k = parent[k]) {
            reachedBy[k] = row;
            ++below[k];
            if (parent[k] == none)
                parent[k] = row;
        }
    }
    double products = 0.0;
    for (const double count : below)
        products += 0.5 * count * (count + 1.0);
    return products;
}

void BlockCholesky::analyze(std::size_t nodes, std::span<const std::pair<int, int>> pairs)
{
    m_place = eliminationOrder(nodes, pairs);
    const auto placesOf = [&](const std::pair<int, int>& pair) {
        return std::pair(
            std::minmax({m_place[std::size_t(pair.first)], m_place[std::size_t(pair.second)]}));
    };

    // Rows below the diagonal of each column, fill included: a column hands its rows on to the
    // column of the first of them (its parent in the elimination tree).
    std::vector<std::vector<std::uint32_t>> rows(nodes);
    for (const auto& pair : pairs) {
        const auto [low, high] = placesOf(pair);
        rows[low].push_back(high);
    }
    for (std::size_t k = 0; k < nodes; ++k) {
        auto& own = rows[k];
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        if (own.size() > 1)
            rows[own[0]].insert(rows[own[0]].end(), own.begin() + 1, own.end());
    }

    m_start.assign(1, 0);
    m_row.clear();
    for (std::size_t k = 0; k < nodes; ++k) {
        m_row.push_back(std::uint32_t(k));
        m_row.insert(m_row.end(), rows[k].begin(), rows[k].end());
        m_start.push_back(std::uint32_t(m_row.size()));
    }
    const auto blockAt = [&](std::uint32_t row, std::uint32_t column) {
        const auto first = m_row.begin() + m_start[column];
        const auto last = m_row.begin() + m_start[column + 1];
        return std::uint32_t(std::lower_bound(first, last, row) - m_row.begin());
    };

    m_diagonal.resize(nodes);
    for (std::size_t i = 0; i < nodes; ++i)
        m_diagonal[i] = m_start[m_place[i]];
    m_pair.clear();
    for (const auto& pair : pairs) {
        const auto [low, high] = placesOf(pair);
        m_pair.push_back(blockAt(high, low));
    }

    // Column k changes every later block whose row and column are both among its rows.
    m_target.clear();
    for (std::size_t k = 0; k < nodes; ++k)
        for (std::size_t j = 0; j < rows[k].size(); ++j)
            for (std::size_t i = j; i < rows[k].size(); ++i)
                m_target.push_back(blockAt(rows[k][i], rows[k][j]));
    m_block.assign(m_row.size(), Block{});
    m_x.resize(nodes);
    listSources();
    shareOut();
}

void BlockCholesky::setZero(ThreadPool& pool)
{
    pool.parallelFor(m_block.size(), [this](std::size_t first, std::size_t last) {
        std::fill(m_block.begin() + std::ptrdiff_t(first), m_block.begin() + std::ptrdiff_t(last),
                  Block{});
    });
}

// By the column that takes, each from the first column to the last.
void BlockCholesky::listSources()
{
    const std::size_t nodes = m_place.size();
    m_sources.assign(nodes + 1, 0);
    for (std::size_t k = 0; k < nodes; ++k)
        for (std::uint32_t b = m_start[k] + 1; b < m_start[k + 1]; ++b)
            ++m_sources[m_row[b] + 1];
    std::partial_sum(m_sources.begin(), m_sources.end(), m_sources.begin());
    m_source.resize(m_sources.back());
    std::vector<std::uint32_t> next(m_sources.begin(), m_sources.end() - 1);
    std::size_t target = 0;
    for (std::size_t k = 0; k < nodes; ++k)
        for (std::uint32_t b = m_start[k] + 1; b < m_start[k + 1]; ++b) {
            const std::uint32_t count = m_start[k + 1] - b;
            m_source[next[m_row[b]]++] = {std::uint32_t(k), b, count, target};
            target += count;
        }
}

// Columns that follow each other until they are worth taking.
void BlockCholesky::shareOut()
{
    m_share.assign(1, 0);
    std::size_t products = 0;
    for (std::uint32_t k = 0; k < m_place.size(); ++k) {
        for (std::uint32_t s = m_sources[k]; s < m_sources[k + 1]; ++s)
            products += m_source[s].count;
        if (products < productsOfShare && k + 1 < m_place.size())
            continue;
        m_share.push_back(k + 1);
        products = 0;
    }
    m_done.assign(m_place.size(), 0);
    m_round = 0;
}

RIPSTOP_CLONES
void BlockCholesky::takeProducts(std::span<const Source> sources)
{
    take(sources, m_target.data(), m_block.data());
}

RIPSTOP_CLONES
bool BlockCholesky::finishColumn(std::size_t column)
{
    return finish(m_block.data() + m_start[column], m_block.data() + m_start[column + 1]);
}

RIPSTOP_CLONES
bool BlockCholesky::factorizeAlone()
{
    for (std::size_t k = 0; k < m_place.size(); ++k) {
        take(sourcesOf(k), m_target.data(), m_block.data());
        if (!finish(m_block.data() + m_start[k], m_block.data() + m_start[k + 1]))
            return false;
    }
    return true;
}

bool BlockCholesky::factorize(ThreadPool& pool)
{
    if (pool.threads() == 1 || products() < productsOfThreads)
        return factorizeAlone();
    ++m_round;
    m_nextShare = 0;
    m_hasFailed = 0;
    pool.onEachThread([this](int) { factorizeShares(); });
    return m_hasFailed == 0;
}

// Shares are taken in their order, so that who waits for a column waits for a thread that works on
// it, or for one that this one waits for in turn.
void BlockCholesky::factorizeShares()
{
    std::atomic_ref next(m_nextShare);
    for (std::uint32_t share;
         (share = next.fetch_add(1, std::memory_order_relaxed)) + 1 < m_share.size();)
        for (std::uint32_t k = m_share[share]; k < m_share[share + 1]; ++k) {
            if (!factorizeWithOthers(k)) {
                std::atomic_ref(m_hasFailed).store(1, std::memory_order_relaxed);
                return;
            }
            std::atomic_ref(m_done[k]).store(m_round, std::memory_order_release);
        }
}

bool BlockCholesky::factorizeWithOthers(std::size_t column)
{
    std::span<const Source> sources = sourcesOf(column);
    while (!sources.empty()) {
        if (!await(sources.front().column))
            return false;
        std::size_t ready = 1;
        while (ready < sources.size() && isDone(sources[ready].column))
            ++ready;
        takeProducts(sources.first(ready));
        sources = sources.subspan(ready);
    }
    return finishColumn(column);
}

bool BlockCholesky::isDone(std::uint32_t column)
{
    return std::atomic_ref(m_done[column]).load(std::memory_order_acquire) == m_round;
}

// Returns when the column is there, with whether it will ever be.
bool BlockCholesky::await(std::uint32_t column)
{
    for (int looks = 0; !isDone(column); ++looks) {
        if (std::atomic_ref(m_hasFailed).load(std::memory_order_relaxed) != 0)
            return false;
        if (looks > patientLooks) // its thread may not be running
            std::this_thread::yield();
    }
    return true;
}

void BlockCholesky::solve(std::span<Row> x)
{
    const std::size_t nodes = m_x.size();
    for (std::size_t i = 0; i < nodes; ++i)
        m_x[m_place[i]] = x[i];
    solve(nodes, m_start.data(), m_row.data(), m_block.data(), m_x.data());
    for (std::size_t i = 0; i < nodes; ++i)
        x[i] = m_x[m_place[i]];
}

RIPSTOP_CLONES
void BlockCholesky::solve(std::size_t nodes, const std::uint32_t* start, const std::uint32_t* row,
                          Block* block, Row* x)
{
    for (std::size_t k = 0; k < nodes; ++k) {
        double* const own = x[k].v;
        forward(block[start[k]], own);
        for (std::size_t i = start[k] + 1; i < start[k + 1]; ++i) {
            Block& b = block[i];
            pack(x[row[i]].v) -= pack(b.column[0]) * own[0] + pack(b.column[1]) * own[1]
                                 + pack(b.column[2]) * own[2];
        }
    }
    for (std::size_t k = nodes; k-- > 0;) {
        Pack sum[3]{};
        for (std::size_t i = start[k] + 1; i < start[k + 1]; ++i)
            for (int c = 0; c < 3; ++c)
                sum[c] += pack(block[i].column[c]) * pack(x[row[i]].v);
        double* const own = x[k].v;
        for (int c = 0; c < 3; ++c)
            own[c] -= sum[c][0] + sum[c][1] + sum[c][2];
        backward(block[start[k]], own);
    }
}

} // namespace ripstop
