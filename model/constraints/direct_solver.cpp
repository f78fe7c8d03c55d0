// Newton's method for a block of rods, which direct_prepare.cpp has made ready. project() makes
// iterations of three stages: assemble() (direct_assemble.cpp), factorise and solve, then
// arrive() where the move leads, which go() takes less of while it does not bring the sum down.
// In the end keepCenters() takes back what rounding moved the centres of islands, and positions and
// multipliers are handed back.
#include "constraints/direct_solver.h"

#include "constraints/guides.h"
#include "constraints/rod_damping.h"
#include "constraints/rod_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ripstop {
namespace {

constexpr double strainOfRigid = 1e-4; // under `greatLoad`
constexpr double greatLoad = 100.0;    // m/s^2, ten times gravity on all masses
constexpr double leastSoftness = 1e-8; // of the inverse masses of the ends
constexpr double greatestSoftness = 1e-4;
constexpr int halvings = 6;

constexpr int mostIterations = 200;
constexpr int fewIterations = 6;         // no more are tried of what can be factorised
constexpr double leftByIterations = 0.2; // of the accuracy; both together stay within it
constexpr double longSwing = 2.0;        // steps within a radian of it, squared
constexpr double leastOfPulls = 1e-4;    // of their energy, that iterations look at
constexpr double leftByNewton = 0.5;

} // namespace

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
    for (std::size_t i = 0; i < m_island.size(); ++i)
        if (m_island[i] >= 0) {
            const auto island = std::size_t(m_island[i]);
            pack(m_position[i].v) -= pack(m_drift[island].v) / m_islandMass[island];
        }
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
    for (std::size_t k = 0; k < m_drift.size(); ++k) {
        const Vec3 off = m_islandDrag[k].inverse() * vec(m_drift[k]);
        m_drift[k] = {{off.x(), off.y(), off.z(), 0.0}};
    }
    for (std::size_t i = 0; i < m_island.size(); ++i)
        if (m_island[i] >= 0)
            pack(m_position[i].v) -= pack(m_drift[std::size_t(m_island[i])].v);
}

void DirectSolver::takeDamping(const RodTask& task)
{
    m_drag.resize(task.damping.empty() ? 0 : nodes());
    for (std::size_t i = 0; i < m_drag.size(); ++i)
        m_drag[i] = task.h * task.damping[std::size_t(m_particle[i])];
}

void DirectSolver::soften(const System& system, double h)
{
    m_h = h;
    const double load = greatLoad * std::accumulate(m_mass.begin(), m_mass.end(), 0.0);
    for (Bar& bar : m_bars) {
        const Rod& rod = system.rods[std::size_t(bar.rod)];
        const double unseen = strainOfRigid * rod.restLength / load;
        bar.softness = bar.isElastic
                           ? std::max(complianceOver(rod, h) / (h * h), leastSoftness * bar.weight)
                           : std::clamp(unseen / (h * h), leastSoftness * bar.weight,
                                        greatestSoftness * bar.weight);
    }
}

void DirectSolver::start(const RodTask& task, std::span<const double> multiplier)
{
    if (task.h != m_h)
        soften(task.system, task.h);
    m_accuracy = task.system.accuracy;
    takeDamping(task);
    m_pulls = 0.0;
    for (Bar& bar : m_bars) {
        const auto r = std::size_t(bar.rod);
        bar.torn = task.torn[r] != 0;
        bar.rest = task.restLength[r];
        bar.multiplier = bar.atStart = bar.torn ? 0.0 : multiplier[r];
        m_pulls += energyOfPull(bar);
    }
    m_panels.start(task.system, task.gone, {task.before, task.drift, task.substep, task.h});
}

int DirectSolver::project(const RodTask& task, std::span<double> multiplier, int iterations,
                          double tolerance)
{
    if (isEmpty())
        return 0;
    const System& system = task.system;
    for (std::size_t i = 0; i < m_particle.size(); ++i) {
        const Vec3& x = task.position[std::size_t(m_particle[i])];
        m_position[i] = {{x.x(), x.y(), x.z(), 0.0}};
    }
    std::copy_n(m_position.begin(), nodes(), m_guess.begin());

    m_iterates = m_hasGrid;
    m_loads = std::numeric_limits<double>::max();
    if ((m_iterates || !m_panels.empty()) && !task.before.empty())
        startNearer(task);
    else
        measure(system);
    m_pulls += m_panels.energy();
    m_panelErrors = 0.0;
    int taken = 0;
    for (bool near = false; !near && taken < iterations; ++taken) {
        std::copy_n(m_position.begin(), nodes(), m_from.begin());
        const double before = assemble(system);
        if (!solveForMoves(system)) // something is not a number, which the watchdog will see
            break;
        moveAlongGuides();
        const Arrival arrival = arrive(system);
        near = arrival.worst < tolerance
               && std::sqrt(arrival.errors) <= leftByNewton * m_accuracy * std::sqrt(m_pulls);
        double share = 1.0;
        for (int i = 0; i < halvings && !near && merit() > before; ++i)
            go(share *= 0.5, system);
        if (share < 1.0)
            takeShare(share, system);
    }

    m_residual = 0.0;
    if (m_pulls > 0.0) {
        const double left = m_left / scaleOfErrors();
        m_residual = std::sqrt(left * left + m_panelErrors / m_pulls);
    }
    keepCenters();
    for (std::size_t i = 0; i < nodes(); ++i)
        task.position[std::size_t(m_particle[i])] =
            Vec3(m_position[i].v[0], m_position[i].v[1], m_position[i].v[2]);
    for (const Bar& bar : m_bars)
        multiplier[std::size_t(bar.rod)] = pullOf(bar);
    return taken;
}

// Of a move that went only part of its way.
void DirectSolver::takeShare(double share, const System& system)
{
    m_pulls = 0.0;
    for (Bar& bar : m_bars) {
        bar.multiplier = bar.before + share * (bar.multiplier - bar.before);
        m_pulls += energyOfPull(bar);
    }
    m_panels.settle(share);
    const ElasticPanels::Account account = m_panels.account(system);
    m_pulls += account.pulls;
    m_panelErrors = account.errors;
}

bool DirectSolver::hasImpact() const
{
    return m_hasOneWay && std::ranges::any_of(m_bars, [](const Bar& bar) {
        return bar.resists != Resists::Both && std::abs(pullOf(bar)) > 2.0 * std::abs(bar.atStart);
    });
}

// Where forces and rods are near their balance, as in all that hangs or is in the wind, particles
// go on as they were: that is a better start than where the forces alone take them.
RIPSTOP_CLONES
void DirectSolver::startNearer(const RodTask& task)
{
    std::copy_n(m_position.begin(), nodes(), m_from.begin());
    double here = 0.0; // twice the sum that is minimised
    m_loads = 0.0;
    for (std::size_t i = 0; i < nodes(); ++i) {
        const auto p = std::size_t(m_particle[i]);
        pack(m_position[i].v) -= (task.h * task.h) * pack(task.acceleration[p]);
        m_loads += energyOfWay(i);
    }
    double nearer = m_loads;
    const auto from = [this](std::uint32_t row) -> const Row& {
        return row < nodes() ? m_from[row] : m_position[row];
    };
    for (Bar& bar : m_bars) {
        ripstop::measure(bar, from(bar.a), from(bar.b));
        bar.active = acts(bar);
        here += energyOf(bar);
        ripstop::measure(bar, m_position[bar.a], m_position[bar.b]);
        bar.active = acts(bar);
        nearer += energyOf(bar);
    }
    if (!m_panels.empty()) {
        std::swap_ranges(m_from.begin(), m_from.end(), m_position.begin());
        here += m_panels.measure(task.system, m_position);
        std::swap_ranges(m_from.begin(), m_from.end(), m_position.begin());
        nearer += m_panels.measure(task.system, m_position);
    }
    if (nearer < here)
        return;
    std::copy_n(m_from.begin(), nodes(), m_position.begin());
    measure(task.system);
}

// Puts the moves in place of the right-hand side.
bool DirectSolver::solveForMoves(const System& system)
{
    m_left = 0.0;
    if (m_iterates && !iterate(system))
        return false;
    if (m_iterates)
        return true;
    if (!m_factor.factorize())
        return false;
    m_factor.solve(m_move);
    return true;
}

// Where iterations are not soon at an end, and there is another way, takes that from now on.
bool DirectSolver::iterate(const System& system)
{
    if (!m_grid.factorize())
        return false;
    const auto keepOnGuides = [this](std::span<Row> rows) {
        for (std::size_t i = 0; i < m_guides.size() && i < rows.size(); ++i)
            moveAlongGuide(i, rows[i]);
    };
    const double goal = leftByIterations * m_accuracy * scaleOfErrors();
    m_left = m_grid.solve({m_move.data(), nodes()}, goal,
                          m_hasFactor ? fewIterations : mostIterations, keepOnGuides);
    if (m_hasFactor && m_left > goal) {
        m_left = 0.0;
        m_iterates = false;
        assemble(system);
    }
    return true;
}

// What iterations leave is forces, and moves particles in each of the steps of a slow swing alike.
// For the share of a swing that a step is, loads move particles by less than pulls give way.
double DirectSolver::scaleOfErrors() const
{
    return std::sqrt(std::clamp(longSwing * m_loads, leastOfPulls * m_pulls, m_pulls));
}

// Measures rods and panels with their ends where they are now.
void DirectSolver::measure(const System& system)
{
    for (Bar& bar : m_bars)
        ripstop::measure(bar, m_position[bar.a], m_position[bar.b]);
    m_panels.measure(system, m_position);
}

// The moves lead along the guides but for rounding errors, which are taken out here.
void DirectSolver::moveAlongGuides()
{
    for (std::size_t i = 0; i < std::min(m_guides.size(), nodes()); ++i)
        moveAlongGuide(i, m_move[i]);
}

void DirectSolver::moveAlongGuide(std::size_t row, Row& move) const
{
    const Vec3 along = m_guides[row].freePart(Vec3(move.v[0], move.v[1], move.v[2]));
    for (int c = 0; c < 3; ++c)
        move.v[c] = along[c];
}

// Foresees the multiplier at the end of the move, as if the rod kept its direction.
RIPSTOP_INLINE void DirectSolver::foresee(Bar& bar) const
{
    bar.before = bar.multiplier;
    bar.multiplier = 0.0;
    if (!bar.active)
        return;
    Row opening;
    pack(opening.v) = pack(m_move[bar.b].v) - pack(m_move[bar.a].v);
    if (bar.rest == 0.0) {
        pack(opening.v) += bar.length * pack(bar.direction.v);
        bar.multiplier = std::sqrt(dot(opening, opening)) / bar.softness;
    } else {
        bar.multiplier = (bar.stretch + dot(bar.direction, opening)) / bar.softness;
    }
}

// Goes the whole way. One pass over the rods does all that has to be known of them there, since a
// large network is more than the processor keeps near.
RIPSTOP_CLONES
DirectSolver::Arrival DirectSolver::arrive(const System& system)
{
    for (std::size_t i = 0; i < m_from.size(); ++i)
        pack(m_position[i].v) = pack(m_from[i].v) + pack(m_move[i].v);
    Arrival arrival;
    m_pulls = 0.0;
    for (Bar& bar : m_bars) {
        foresee(bar);
        ripstop::measure(bar, m_position[bar.a], m_position[bar.b]);
        m_pulls += energyOfPull(bar);
        arrival.errors += energyOfError(bar);
        const double off = missOf(bar);
        if (!(off <= arrival.worst * bar.rest))
            arrival.worst = bar.rest > 0.0 ? off / bar.rest : off;
    }
    if (!m_panels.empty()) {
        m_panels.foresee(system, m_move);
        m_panels.measure(system, m_position);
        const ElasticPanels::Account account = m_panels.account(system);
        m_pulls += account.pulls;
        m_panelErrors = account.errors;
        arrival.errors += account.errors;
    }
    return arrival;
}

void DirectSolver::go(double share, const System& system)
{
    for (std::size_t i = 0; i < m_from.size(); ++i)
        pack(m_position[i].v) = pack(m_from[i].v) + share * pack(m_move[i].v);
    measure(system);
}

// The sum that is minimised, for the rods that are active now; kg m^2.
double DirectSolver::merit() const
{
    double twice = 0.0;
    for (std::size_t i = 0; i < m_mass.size(); ++i)
        twice += energyOfWay(i);
    for (const Bar& bar : m_bars)
        twice += energyOf(bar);
    return 0.5 * (twice + m_panels.energy());
}

} // namespace ripstop
