// Islands of DirectSolver: what rods, panels and bends join without reaching a pin. Nothing that is
// solved moves their centres of mass, so that rounding must not either.
#include "constraints/direct_solver.h"

#include <algorithm>
#include <numeric>

namespace ripstop {

void DirectSolver::findIslands()
{
    // Every row points to a lower one of its island until it points to the lowest; those that a pin
    // holds point to -1 in the end.
    std::vector<int> lower(m_particle.size());
    std::iota(lower.begin(), lower.end(), 0);
    const auto lowest = [&](std::uint32_t row) {
        while (lower[row] != int(row))
            row = std::uint32_t(lower[row]);
        return int(row);
    };
    std::vector<std::uint8_t> held(lower.size(), 0);
    const auto forEachTie = [&](const auto& visit) { // ends, the lower row first
        for (const Bar& bar : m_bars)
            visit(std::min(bar.a, bar.b), std::max(bar.a, bar.b));
        forEachTriple([&](const Triple& triple) {
            for (const auto& [from, to] : sidesOfTriple) {
                const auto [low, high] = std::minmax(triple.row[from], triple.row[to]);
                visit(low, high);
            }
        });
    };
    forEachTie([&](std::uint32_t a, std::uint32_t b) {
        if (b >= nodes())
            return;
        const auto [low, high] = std::minmax({lowest(a), lowest(b)});
        lower[std::size_t(high)] = low;
    });
    forEachTie([&](std::uint32_t a, std::uint32_t b) {
        if (a < nodes() && b >= nodes())
            held[std::size_t(lowest(a))] = 1;
    });
    for (std::size_t i = 0; i < m_guides.size(); ++i) // a guide holds across itself
        if (m_guides[i].guide != Guide::None)
            held[std::size_t(lowest(std::uint32_t(i)))] = 1;

    m_island.assign(nodes(), -1);
    m_islandMass.clear();
    std::vector<int> number(nodes(), -1);
    for (std::size_t i = 0; i < nodes(); ++i) {
        const auto root = std::size_t(lowest(std::uint32_t(i)));
        if (held[root])
            continue;
        if (number[root] < 0) {
            number[root] = int(m_islandMass.size());
            m_islandMass.push_back(0.0);
        }
        m_island[i] = number[root];
    }
    m_drift.assign(m_islandMass.size(), Row{});
}

// Rods move no centre of mass. Stiff ones next to light particles would do so by rounding errors.
void DirectSolver::keepCenters()
{
    if (!m_drag.empty())
        return keepDraggedCenters();
    std::fill(m_drift.begin(), m_drift.end(), Row{});
    for (std::size_t i = 0; i < m_island.size(); ++i)
        if (m_island[i] >= 0)
            pack(m_drift[std::size_t(m_island[i])].v) +=
                m_mass[i] * (pack(m_position[i].v) - pack(m_guess[i].v));
    leaveHeldIslands();
    for (std::size_t i = 0; i < m_island.size(); ++i)
        if (m_island[i] >= 0) {
            const auto island = std::size_t(m_island[i]);
            pack(m_position[i].v) -= pack(m_drift[island].v) / m_islandMass[island];
        }
}

// What an obstacle holds has no centre to keep.
void DirectSolver::leaveHeldIslands()
{
    for (const HeldContact& contact : m_contacts.list())
        if (contact.acts && m_island[contact.row] >= 0)
            m_drift[std::size_t(m_island[contact.row])] = {};
}

// With forces that fall as rods move things the sum of M (x - y) is what stays 0.
void DirectSolver::keepDraggedCenters()
{
    std::fill(m_drift.begin(), m_drift.end(), Row{});
    m_islandDrag.assign(m_drift.size(), Mat3::Zero());
    const auto vec = [](const Row& row) { return Vec3(row.v[0], row.v[1], row.v[2]); };
    const auto add = [](Row& row, const Vec3& value) {
        for (int c = 0; c < 3; ++c)
            row.v[c] += value[c];
    };
    for (std::size_t i = 0; i < m_island.size(); ++i)
        if (m_island[i] >= 0) {
            const auto island = std::size_t(m_island[i]);
            const Mat3 inertia = m_mass[i] * Mat3::Identity() + m_drag[i];
            m_islandDrag[island] += inertia;
            add(m_drift[island], inertia * (vec(m_position[i]) - vec(m_guess[i])));
        }
    leaveHeldIslands();
    for (std::size_t k = 0; k < m_drift.size(); ++k) {
        const Vec3 off = m_islandDrag[k].inverse() * vec(m_drift[k]);
        m_drift[k] = {{off.x(), off.y(), off.z(), 0.0}};
    }
    for (std::size_t i = 0; i < m_island.size(); ++i)
        if (m_island[i] >= 0)
            pack(m_position[i].v) -= pack(m_drift[std::size_t(m_island[i])].v);
}

} // namespace ripstop
