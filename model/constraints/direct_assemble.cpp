// The matrix and the right-hand side of an iteration of DirectSolver: masses and what forces fall
// by with speed, then rods, then panels that carry a pull and bends of spars. Where the matrix is
// factorised, what is on guides is multiplied by them on either side; iterations keep to guides by
// themselves.
#include "constraints/direct_solver.h"
#include "constraints/guides.h"
#include "parallel/ordered_parts.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace ripstop {
namespace {

constexpr std::size_t panelsOfThreads = 2000; // fewer are not worth handing out

RIPSTOP_INLINE void add(BlockCholesky::Block& sum, const BlockCholesky::Block& value)
{
    for (int c = 0; c < 3; ++c)
        pack(sum.column[c]) += pack(value.column[c]);
}

} // namespace

// Returns the sum that is minimised, kg m^2. Threads share the stripes of the grid, each with the
// bars and panels of which the first row is in it.
double DirectSolver::assemble(ThreadPool& pool)
{
    double twice = 0.0;
    if (m_iterates) {
        m_grid.setZero(pool);
        twice += orderedSum(pool, nodes(), [this](std::size_t first, std::size_t last) {
            return addMasses(first, last);
        });
        const Stripes& stripes = m_grid.stripes();
        stripes.forEachByColour(pool, [&](const Stripe& stripe) {
            const std::size_t s = stripes.placeOf(stripe);
            m_energyOf[s] = addBars(m_barsOf[s], m_barsOf[s + 1]);
            addPanels(m_panelsOf[s], m_panelsOf[s + 1], allNodes());
        });
        twice += std::accumulate(m_energyOf.begin(), m_energyOf.end(), 0.0);
    } else {
        m_factor.setZero(pool);
        twice += addMasses(0, nodes());
        twice += addBars(0, m_bars.size());
        addPanelsByNodes(pool);
    }
    for (const SparBend& bend : m_bends.bends())
        if (!bend.gone)
            addTriple(bend, m_bends.block(bend), allNodes());
    m_fabricBends.addPulls({m_move.data(), nodes()});
    if (!m_fabricBends.empty() && !m_iterates)
        keepOnGuides({m_move.data(), nodes()}); // as what bars and triples add
    addContacts();
    return 0.5
           * (twice + m_panels.energy() + m_bends.energy() + m_fabricBends.energy()
              + m_contacts.energy());
}

// Each thread goes over all panels and adds what concerns its own nodes, so that what comes
// together there does so in the order of the panels, by any number of threads.
void DirectSolver::addPanelsByNodes(ThreadPool& pool)
{
    const std::size_t panels = m_panels.panels().size();
    const std::size_t shares =
        panels < panelsOfThreads ? 1 : std::min(std::size_t(pool.threads()), nodes());
    pool.forEach(shares, [&](std::size_t share) {
        addPanels(0, panels,
                  {std::uint32_t(nodes() * share / shares),
                   std::uint32_t(nodes() * (share + 1) / shares)});
    });
}

void DirectSolver::addPanels(std::size_t first, std::size_t last, const NodeRange& to)
{
    TripleBlock block;
    for (std::size_t i = first; i < last; ++i) {
        const ElasticPanel& panel = m_panels.panels()[i];
        if (panel.gone || !std::ranges::any_of(panel.row, [&](auto row) { return to.has(row); }))
            continue;
        m_panels.fillBlock(i, block);
        if (!m_fabricBends.empty())
            m_fabricBends.addBound(panel.membrane, block);
        addTriple(panel, block, to);
    }
}

RIPSTOP_CLONES
double DirectSolver::addMasses(std::size_t first, std::size_t last)
{
    double twice = 0.0;
    for (std::size_t i = first; i < last; ++i) {
        const double mass = m_mass[i];
        BlockCholesky::Block& block = diagonal(i);
        for (int c = 0; c < 3; ++c)
            block.column[c][c] = mass;
        pack(m_move[i].v) = mass * (pack(m_guess[i].v) - pack(m_position[i].v));
        twice += energyOfWay(i);
    }
    for (std::size_t i = first; i < std::min(last, m_drag.size()); ++i) {
        BlockCholesky::Block& block = diagonal(i);
        const Pack way = pack(m_guess[i].v) - pack(m_position[i].v);
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) {
                block.column[c][r] += m_drag[i](r, c);
                m_move[i].v[r] += m_drag[i](r, c) * way[c];
            }
    }
    return twice;
}

RIPSTOP_CLONES
double DirectSolver::addBars(std::size_t first, std::size_t last)
{
    const std::size_t count = m_mass.size();
    double twice = 0.0;
    for (Bar& bar : std::span(m_bars).subspan(first, last - first)) {
        bar.active = acts(bar);
        twice += energyOf(bar);
        const bool apart = bar.guided && !m_iterates; // iterations keep to guides by themselves
        if (bar.active && apart)
            addOnGuides(bar);
        if (!bar.active || apart)
            continue;
        const Pack n = pack(bar.direction.v);
        const double along = 1.0 / bar.softness;
        const double across = bar.rest == 0.0 ? along : std::max(bar.multiplier, 0.0) / bar.length;
        Pack column[3];
        for (int c = 0; c < 3; ++c)
            column[c] = n * ((along - across) * n[c]) + BlockCholesky::diagonalPart(c, across);
        const Pack pull = n * (along * bar.stretch);
        if (bar.a < count) {
            BlockCholesky::Block& block = diagonal(bar.a);
            for (int c = 0; c < 3; ++c)
                pack(block.column[c]) += column[c];
            pack(m_move[bar.a].v) += pull;
        }
        if (bar.b < count) {
            BlockCholesky::Block& block = diagonal(bar.b);
            for (int c = 0; c < 3; ++c)
                pack(block.column[c]) += column[c];
            pack(m_move[bar.b].v) -= pull;
        }
        if (bar.pair >= 0) {
            BlockCholesky::Block& block = pair(std::size_t(bar.pair));
            for (int c = 0; c < 3; ++c)
                pack(block.column[c]) -= column[c];
        }
    }
    return twice;
}

void DirectSolver::addContacts()
{
    m_contacts.assemble([this](std::uint32_t row, const Mat3& stiffness, const Vec3& pull) {
        add(diagonal(row), blockOf(stiffness));
        for (int c = 0; c < 3; ++c)
            m_move[row].v[c] += pull[c];
    });
}

// Pairs belong to the lower of their nodes.
void DirectSolver::addTriple(const Triple& triple, const TripleBlock& block, const NodeRange& to)
{
    if (m_guides.empty() || m_iterates)
        return addFreeTriple(triple, block, to);
    const std::array<Mat3, 3> free{onGuides(triple.row[0]), onGuides(triple.row[1]),
                                   onGuides(triple.row[2])};
    TripleBlock kept;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [one, other] = sidesOfTriple[k];
        const auto& pull = block.pull[k].v;
        const Vec3 left = free[k] * Vec3(pull[0], pull[1], pull[2]);
        kept.corner[k] = blockOf(free[k] * matrixOf(block.corner[k]) * free[k]);
        kept.pair[k] = blockOf(free[one] * matrixOf(block.pair[k]) * free[other]);
        kept.pull[k] = {{left[0], left[1], left[2], 0.0}};
    }
    addFreeTriple(triple, kept, to);
}

RIPSTOP_CLONES
void DirectSolver::addFreeTriple(const Triple& triple, const TripleBlock& block,
                                 const NodeRange& to)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t one = triple.row[sidesOfTriple[k].first];
        const std::uint32_t other = triple.row[sidesOfTriple[k].second];
        if (to.has(one)) {
            add(diagonal(one), block.corner[k]);
            pack(m_move[one].v) += pack(block.pull[k].v);
        }
        if (triple.pair[k] < 0 || !to.has(std::min(one, other)))
            continue;
        const bool rowsOfOne = m_iterates ? one < other : m_factor.isLater(one, other);
        add(pair(std::size_t(triple.pair[k])),
            rowsOfOne ? block.pair[k] : transposed(block.pair[k]));
    }
}

// P of a row.
Mat3 DirectSolver::onGuides(std::uint32_t row) const
{
    Mat3 free;
    for (int c = 0; c < 3; ++c)
        free.col(c) = m_guides[row].freePart(Vec3::Unit(c));
    return free;
}

// What assemble() adds of a bar, with P on either side. The row of a pair's block is the node that
// is eliminated later.
void DirectSolver::addOnGuides(const Bar& bar)
{
    const Vec3 n(bar.direction.v[0], bar.direction.v[1], bar.direction.v[2]);
    const double along = 1.0 / bar.softness;
    const double across = bar.rest == 0.0 ? along : std::max(bar.multiplier, 0.0) / bar.length;
    const Mat3 stiffness = (along - across) * n * n.transpose() + across * Mat3::Identity();
    const Mat3 ontoA = onGuides(bar.a), ontoB = onGuides(bar.b);
    const auto pull = [&](std::uint32_t row, const Vec3& force) {
        for (int c = 0; c < 3; ++c)
            m_move[row].v[c] += force[c];
    };
    if (bar.a < nodes()) {
        add(diagonal(bar.a), blockOf(ontoA * stiffness * ontoA));
        pull(bar.a, ontoA * (along * bar.stretch * n));
    }
    if (bar.b < nodes()) {
        add(diagonal(bar.b), blockOf(ontoB * stiffness * ontoB));
        pull(bar.b, ontoB * (-along * bar.stretch * n));
    }
    if (bar.pair >= 0) {
        const bool aIsRow = m_factor.isLater(bar.a, bar.b);
        add(pair(std::size_t(bar.pair)),
            blockOf(aIsRow ? Mat3(-ontoA * stiffness * ontoB) : Mat3(-ontoB * stiffness * ontoA)));
    }
}

} // namespace ripstop
