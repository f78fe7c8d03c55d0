// The linear system of an iteration of DirectSolver, which direct_assemble.cpp has filled: by a
// factor of its matrix, or by conjugate gradients with coarser networks; and with the bends of
// fabric, which the matrix has only a bound for, by conjugate gradients beside either.
#include "constraints/direct_solver.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int mostIterations = 200;
constexpr double nothing = 1e-5; // of the energy's root
constexpr double leftByIterations =
    0.1;                              // of the accuracy: no pull of a sheet at rest is off by more
constexpr double longSwing = 2.0;     // steps within a radian of it, squared
constexpr double leastOfPulls = 1e-4; // of their energy, that iterations look at

} // namespace

// Puts the moves in place of the right-hand side.
bool DirectSolver::solveForMoves(ThreadPool& pool)
{
    m_left = 0.0;
    if (m_iterates && !iterate(pool))
        return false;
    if (m_iterates)
        return true;
    if (!m_factor.factorize(pool))
        return false;
    if (m_fabricBends.empty())
        m_factor.solve(m_move);
    else
        solveWithBends(pool);
    return true;
}

// With the bound of the bends in the matrix at first. Where that leaves too much, conjugate
// gradients go by its factor. This has taken the place of the matrix, but what it gives need not be
// multiplied by that again: the ways and what they hold are made of the same shares.
void DirectSolver::solveWithBends(ThreadPool& pool)
{
    const std::span<Row> move(m_move.data(), nodes());
    const auto dotOf = [](std::span<const Row> a, std::span<const Row> b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += dot(a[i], b[i]);
        return sum;
    };
    std::ranges::copy(move, m_rest.begin());
    m_factor.solve(m_move);
    keepOnGuides(move);
    const double enough =
        std::max(goalOfIterations() * goalOfIterations(), nothing * nothing * dotOf(m_rest, move));
    std::ranges::fill(m_held, Row{});
    const double off = -addBeyond(move, m_held, pool); // of the energy, at most
    m_left = std::sqrt(std::max(off, 0.0));
    if (!(off > enough))
        return;
    std::ranges::copy(move, m_sum.begin());
    for (std::size_t i = 0; i < nodes(); ++i)
        pack(m_rest[i].v) = -pack(m_held[i].v);
    double before = 0.0;
    for (int taken = 0;; ++taken) {
        std::ranges::copy(m_rest, move.begin());
        m_factor.solve(m_move);
        keepOnGuides(move);
        const double now = dotOf(m_rest, move);
        m_left = std::sqrt(std::max(now, 0.0));
        if (!(now > enough) || taken == mostIterations)
            break;
        const double share = taken == 0 ? 0.0 : now / before;
        before = now;
        for (std::size_t i = 0; i < nodes(); ++i) {
            pack(m_way[i].v) = pack(move[i].v) + share * pack(m_way[i].v);
            pack(m_held[i].v) = pack(m_rest[i].v) + share * pack(m_held[i].v);
        }
        std::ranges::copy(m_held, move.begin());
        addBeyond(m_way, move, pool);
        const double step = now / dotOf(m_way, move);
        for (std::size_t i = 0; i < nodes(); ++i) {
            pack(m_sum[i].v) += step * pack(m_way[i].v);
            pack(m_rest[i].v) -= step * pack(move[i].v);
        }
    }
    std::ranges::copy(m_sum, move.begin());
}

// What the matrix has beyond its blocks.
double DirectSolver::addBeyond(std::span<const Row> x, std::span<Row> y, ThreadPool& pool)
{
    const double product = m_fabricBends.addBeyond(x, y, pool);
    keepOnGuides(y);
    return product;
}

// Where iterations are not soon at an end, and there is another way, takes that from now on.
bool DirectSolver::iterate(ThreadPool& pool)
{
    if (!m_grid.factorize(pool))
        return false;
    Multigrid::Beyond beyond;
    if (!m_fabricBends.empty())
        beyond = [&](std::span<const Row> x, std::span<Row> y) { return addBeyond(x, y, pool); };
    const double goal = goalOfIterations();
    m_left = m_grid.solve(
        {m_move.data(), nodes()}, goal, m_hasFactor ? m_worthIterating : mostIterations,
        [this](std::span<Row> rows) { keepOnGuides(rows); }, pool, beyond);
    if (m_hasFactor && m_left > goal) {
        m_left = 0.0;
        m_iterates = false;
        assemble(pool);
    }
    return true;
}

double DirectSolver::goalOfIterations() const
{
    return leftByIterations * m_accuracy * scaleOfErrors();
}

// What iterations leave is forces, and moves particles in each of the steps of a slow swing alike.
// For the share of a swing that a step is, loads move particles by less than pulls give way.
double DirectSolver::scaleOfErrors() const
{
    return std::sqrt(std::clamp(longSwing * m_loads, leastOfPulls * pulls(), pulls()));
}

} // namespace ripstop
