// Rows take the place of particles in the panels, so that the passes of laws/fabric_bending.h go
// over them as they are. Sums are added panel by panel, in their order.
#include "constraints/fabric_bends.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

double sizeOf(const BentPanel::Plane& share) { return std::hypot(share[0], share[1]); }

bool isSame(const BentPanel& row, const BentPanel& other) { return row.panel == other.panel; }

RIPSTOP_INLINE double sum(const Pack& x) { return x[0] + x[1] + x[2]; }

// Of the rows of a solver; ways beyond them, of what is pinned, are none.
void copyRows(std::span<const Row> from, std::vector<PaddedVec3>& to)
{
    for (std::size_t i = 0; i < from.size(); ++i)
        pack(to[i]) = pack(from[i].v);
}

} // namespace

void FabricBends::prepare(const System& system, std::span<const std::uint32_t> row)
{
    const std::span all = system.of<BendLists>().solvedPanels();
    m_panels.assign(all.begin(), all.end());
    m_bound.assign(all.size(), 0.0);
    std::size_t rows = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        BentPanel& panel = m_panels[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t at = row[std::size_t(panel.corner[k])];
            panel.corner[k] = int(at);
            rows = std::max(rows, std::size_t(at) + 1);
        }
    }
    std::vector<int> placeOf(system.panels.size(), -1);
    for (std::size_t i = 0; i < all.size(); ++i)
        placeOf[std::size_t(all[i].panel)] = int(i);
    m_placeOf.clear();
    for (const Membrane& membrane : system.membranes)
        m_placeOf.push_back(placeOf[std::size_t(membrane.panel)]);
    m_position.assign(rows, {});
    m_way.assign(rows, {});
    m_bending.size(all.size());
    m_bending.sizeChange();
    m_load.assign(3 * all.size(), {});
    m_change.assign(3 * all.size(), {});
    m_foreseen.assign(2 * all.size(), {});
    m_before.assign(2 * all.size(), {});
}

bool FabricBends::areOf(const System& system) const
{
    return std::ranges::equal(m_panels, system.of<BendLists>().solvedPanels(), isSame);
}

void FabricBends::takeValues(const System& system, double h)
{
    const std::span all = system.of<BendLists>().solvedPanels();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::array<int, 3> rows = m_panels[i].corner;
        m_panels[i] = all[i];
        m_panels[i].corner = rows;
        m_panels[i].stiffness *= h * h;
    }
    std::ranges::fill(m_bound, 0.0);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const BentPanel& panel = m_panels[i];
        const double own = sizeOf(panel.own);
        std::array<double, 3> share{};
        std::ranges::transform(panel.share, share.begin(), sizeOf);
        const double scale = panel.stiffness * (own + share[0] + share[1] + share[2]);
        m_bound[i] += scale * own;
        for (std::size_t k = 0; k < 3; ++k) // none where nothing is beside it
            m_bound[std::size_t(panel.beside[k])] += scale * share[k];
    }
}

double FabricBends::measure(std::span<const Row> position, ThreadPool& pool)
{
    if (empty())
        return 0.0;
    copyRows(position.first(m_position.size()), m_position);
    m_bending.fill(m_panels, m_gone, m_position.data(), m_load.data(), pool);
    return m_twice = 2.0 * m_bending.energy(m_panels);
}

RIPSTOP_CLONES
void FabricBends::addBound(int membrane, TripleBlock& block) const
{
    const int place = m_placeOf[std::size_t(membrane)];
    if (place < 0)
        return;
    const auto i = std::size_t(place);
    const BentPanel& panel = m_panels[i];
    const double perArea = m_bending.perArea()[i];
    const double bound = m_bound[i] * perArea * perArea;
    Pack side[3];
    for (std::size_t k = 0; k < 3; ++k)
        side[k] = pack(m_position[std::size_t(panel.corner[(k + 2) % 3])])
                  - pack(m_position[std::size_t(panel.corner[(k + 1) % 3])]);
    const auto add = [&](BlockCholesky::Block& to, std::size_t one, std::size_t other) {
        const double size = bound * sum(side[one] * side[other]);
        if (perArea > 0.0) {
            const Pack normal = pack(m_bending.normals()[i]);
            for (int c = 0; c < 3; ++c)
                pack(to.column[c]) += (size * normal[c]) * normal;
            return;
        }
        for (int c = 0; c < 3; ++c)
            pack(to.column[c]) +=
                BlockCholesky::diagonalPart(c, size) - (bound * side[one][c]) * side[other];
    };
    for (std::size_t k = 0; k < 3; ++k) {
        add(block.corner[k], k, k);
        add(block.pair[k], sidesOfTriple[k].first, sidesOfTriple[k].second);
    }
}

void FabricBends::addLoads(std::span<const PaddedVec3> loads, std::span<Row> to) const
{
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (const auto row = std::size_t(m_panels[i].corner[k]); row < to.size())
                pack(to[row].v) += pack(loads[3 * i + k]);
}

void FabricBends::addPulls(std::span<Row> to) const { addLoads(m_load, to); }

double FabricBends::addBeyond(std::span<const Row> x, std::span<Row> y, ThreadPool& pool)
{
    copyRows(x.first(std::min(x.size(), m_way.size())), m_way);
    m_bending.fillChange(m_panels, m_bound, m_position.data(), m_way.data(), m_change.data(), pool);
    Pack products{};
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto row = std::size_t(m_panels[i].corner[k]);
            if (row >= y.size())
                continue;
            const Pack load = pack(m_change[3 * i + k]);
            pack(y[row].v) -= load;
            products -= load * pack(x[row].v);
        }
    return sum(products);
}

void FabricBends::foresee(std::span<const Row> move, ThreadPool& pool)
{
    if (empty())
        return;
    copyRows(move.first(m_way.size()), m_way);
    m_bending.fillChange(m_panels, {}, m_position.data(), m_way.data(), m_change.data(), pool);
    std::ranges::copy(m_bending.bending(), m_before.begin());
    for (std::size_t i = 0; i < m_before.size(); ++i)
        m_foreseen[i] = m_before[i] + m_bending.bendingChange()[i];
}

void FabricBends::settle(double share)
{
    for (std::size_t i = 0; i < m_before.size(); ++i)
        m_foreseen[i] = m_before[i] + share * (m_foreseen[i] - m_before[i]);
}

double FabricBends::errors() const
{
    double twice = 0.0;
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        if (const double stiffness = m_panels[i].stiffness; stiffness > 0.0)
            twice += ((m_bending.bending()[2 * i] - m_foreseen[2 * i]).squaredNorm()
                      + (m_bending.bending()[2 * i + 1] - m_foreseen[2 * i + 1]).squaredNorm())
                     / stiffness;
    return twice;
}

} // namespace ripstop
