// The matrix and the right-hand side of an iteration of DirectSolver: masses and what forces fall
// by with speed, then rods, then panels that carry a pull. Where the matrix is factorised, what is
// on guides is multiplied by them on either side; iterations keep to guides by themselves.
#include "constraints/direct_solver.h"
#include "constraints/guides.h"

#include <algorithm>
#include <array>

namespace ripstop {

// Returns the sum that is minimised, kg m^2.
RIPSTOP_CLONES
double DirectSolver::assemble(const System& system)
{
    double twice = 0.0;
    const std::size_t count = m_mass.size();
    if (m_iterates)
        m_grid.setZero();
    else
        m_factor.setZero();
    for (std::size_t i = 0; i < count; ++i) {
        const double mass = m_mass[i];
        BlockCholesky::Block& block = diagonal(i);
        for (int c = 0; c < 3; ++c)
            block.column[c][c] = mass;
        pack(m_move[i].v) = mass * (pack(m_guess[i].v) - pack(m_position[i].v));
        twice += energyOfWay(i);
    }
    for (std::size_t i = 0; i < m_drag.size(); ++i) {
        BlockCholesky::Block& block = diagonal(i);
        const Pack way = pack(m_guess[i].v) - pack(m_position[i].v);
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) {
                block.column[c][r] += m_drag[i](r, c);
                m_move[i].v[r] += m_drag[i](r, c) * way[c];
            }
    }
    for (Bar& bar : m_bars) {
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
        for (int c = 0; c < 3; ++c) {
            column[c] = n * ((along - across) * n[c]);
            column[c][c] += across;
        }
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
    addPanels(system);
    return 0.5 * (twice + m_panels.energy());
}

void DirectSolver::addPanels(const System& system)
{
    const auto add = [](BlockCholesky::Block& block, const Mat3& value) {
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r)
                block.column[c][r] += value(r, c);
    };
    const bool guided = !m_guides.empty() && !m_iterates;
    const auto onto = [&](std::uint32_t row) {
        Mat3 free;
        for (int c = 0; c < 3; ++c)
            free.col(c) = m_guides[row].freePart(Vec3::Unit(c));
        return free;
    };
    for (const ElasticPanel& panel : m_panels.panels()) {
        if (panel.gone)
            continue;
        PanelBlock part = m_panels.block(system, panel);
        if (guided) {
            const std::array<Mat3, 3> free{onto(panel.row[0]), onto(panel.row[1]),
                                           onto(panel.row[2])};
            for (std::size_t k = 0; k < 3; ++k) {
                part.corner[k] = free[k] * part.corner[k] * free[k];
                part.pair[k] = free[k] * part.pair[k] * free[(k + 1) % 3];
                part.pull[k] = free[k] * part.pull[k];
            }
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = panel.row[k];
            const std::uint32_t to = panel.row[(k + 1) % 3];
            if (from < nodes()) {
                add(diagonal(from), part.corner[k]);
                for (int c = 0; c < 3; ++c)
                    m_move[from].v[c] += part.pull[k][c];
            }
            if (panel.pair[k] < 0)
                continue;
            const bool rowsOfFrom = m_iterates ? from < to : m_factor.isLater(from, to);
            add(pair(std::size_t(panel.pair[k])),
                rowsOfFrom ? part.pair[k] : Mat3(part.pair[k].transpose()));
        }
    }
}

// What assemble() adds of a bar, with P on either side. The row of a pair's block is the node that
// is eliminated later.
void DirectSolver::addOnGuides(const Bar& bar)
{
    const auto onto = [&](std::uint32_t row) {
        Eigen::Matrix3d free;
        for (int c = 0; c < 3; ++c)
            free.col(c) = m_guides[row].freePart(Vec3::Unit(c));
        return free;
    };
    const Vec3 n(bar.direction.v[0], bar.direction.v[1], bar.direction.v[2]);
    const double along = 1.0 / bar.softness;
    const double across = bar.rest == 0.0 ? along : std::max(bar.multiplier, 0.0) / bar.length;
    const Eigen::Matrix3d stiffness =
        (along - across) * n * n.transpose() + across * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d ontoA = onto(bar.a), ontoB = onto(bar.b);
    const auto add = [](BlockCholesky::Block& block, const Eigen::Matrix3d& value) {
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r)
                block.column[c][r] += value(r, c);
    };
    const auto pull = [&](std::uint32_t row, const Vec3& force) {
        for (int c = 0; c < 3; ++c)
            m_move[row].v[c] += force[c];
    };
    if (bar.a < nodes()) {
        add(diagonal(bar.a), ontoA * stiffness * ontoA);
        pull(bar.a, ontoA * (along * bar.stretch * n));
    }
    if (bar.b < nodes()) {
        add(diagonal(bar.b), ontoB * stiffness * ontoB);
        pull(bar.b, ontoB * (-along * bar.stretch * n));
    }
    if (bar.pair >= 0) {
        const bool aIsRow = m_factor.isLater(bar.a, bar.b);
        add(pair(std::size_t(bar.pair)), aIsRow ? Eigen::Matrix3d(-ontoA * stiffness * ontoB)
                                                : Eigen::Matrix3d(-ontoB * stiffness * ontoA));
    }
}

} // namespace ripstop
