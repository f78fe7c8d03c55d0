// Newton's method for a block of rods, which direct_prepare.cpp has made ready. project() makes
// iterations of three stages: assemble() (direct_assemble.cpp), solveForMoves() (direct_moves.cpp),
// then arrive() where the move leads, which go() takes less of while it does not bring the sum
// down. In the end keepCenters() (direct_islands.cpp) takes back what rounding moved the centres of
// islands, and positions and multipliers are handed back.
#include "constraints/direct_solver.h"

#include "constraints/guides.h"
#include "constraints/rod_damping.h"
#include "constraints/rod_solver.h"
#include "parallel/ordered_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ripstop {
namespace {

constexpr double leastShareOfMove = 1.0 / 64.0;

constexpr double leftByNewton = 0.5;
// Much of it lets pulls settle soon and folds a little later. In wind, what folds pull counts, and
// with so much of it an iteration may bring only 2 % less of the error: where there are many, each
// keeps less of it than the one before. Contacts cannot wait for folds, nor settle while it
// changes.
constexpr KeptByFolds keptInTheAir{.most = 1e-2, .least = 1e-5};
constexpr KeptByFolds keptOnObstacles{.most = 1e-3, .least = 1e-3};
constexpr int manyIterations = 5;

} // namespace

void DirectSolver::takeDamping(const RodTask& task)
{
    m_drag.resize(task.damping.empty() ? 0 : nodes());
    for (std::size_t i = 0; i < m_drag.size(); ++i)
        m_drag[i] = task.h * task.damping[std::size_t(m_particle[i])];
}

void DirectSolver::start(const RodTask& task, std::span<const double> multiplier, ThreadPool& pool)
{
    if (task.h != m_h)
        soften(task.system, task.h);
    m_accuracy = task.system.accuracy;
    takeDamping(task);
    m_pulls = orderedSum(pool, m_bars.size(), [&](std::size_t first, std::size_t last) {
        return startBars(task, multiplier, first, last);
    });
    m_panels.start(task.system, task.gone, {task.before, task.drift, task.substep, task.h}, pool);
    m_bends.start(task.system, task.torn, task.h);
    m_fabricBends.start(task.gone);
}

double DirectSolver::startBars(const RodTask& task, std::span<const double> multiplier,
                               std::size_t first, std::size_t last)
{
    double pulls = 0.0;
    for (Bar& bar : std::span(m_bars).subspan(first, last - first)) {
        const auto r = std::size_t(bar.rod);
        bar.torn = task.torn[r] != 0;
        bar.rest = task.restLength[r];
        bar.multiplier = bar.atStart = bar.torn ? 0.0 : multiplier[r];
        pulls += energyOfPull(bar);
        if (bar.resists != Resists::Both)
            bar.foreseen = foreseenPull(bar, task);
    }
    return pulls;
}

// Without a past that tells how ends came, any load may have stopped them.
double DirectSolver::foreseenPull(const Bar& bar, const RodTask& task) const
{
    if (task.drift.empty())
        return std::numeric_limits<double>::infinity();
    const auto a = std::size_t(m_particle[bar.a]), b = std::size_t(m_particle[bar.b]);
    const Vec3 separation = task.before[b] - task.before[a];
    const Vec3 next = separation + task.substep * (task.drift[b] - task.drift[a]);
    const double pull = (next.norm() - bar.rest) / bar.softness;
    return bar.resists == Resists::Tension ? std::max(pull, 0.0) : std::min(pull, 0.0);
}

void DirectSolver::takePositions(std::span<const PaddedVec3> position, ThreadPool& pool)
{
    pool.parallelFor(m_particle.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Vec3& x = position[std::size_t(m_particle[i])];
            m_position[i] = {{x.x(), x.y(), x.z(), 0.0}};
        }
    });
}

int DirectSolver::project(const RodTask& task, std::span<double> multiplier, int iterations,
                          ThreadPool& pool, double tolerance)
{
    if (isEmpty())
        return 0;
    takePositions(task.position, pool);
    std::copy_n(m_position.begin(), nodes(), m_guess.begin());

    guessPushes(task);
    m_contacts.start(task.contacts, rowsThatMove(), m_mass, m_from,
                     m_panels.empty() ? Friction::Firm : Friction::Giving);
    m_panels.setKeptByFolds(m_contacts.empty() ? keptInTheAir : keptOnObstacles);
    m_iterates = m_hasGrid;
    m_loads = std::numeric_limits<double>::max();
    if ((m_iterates || !m_panels.empty() || !task.nearby.empty()) && !task.before.empty())
        startNearer(task, pool);
    else
        measure(pool);
    m_contacts.follow(rowsThatMove(), m_mass, m_position);
    m_pulls += m_panels.energy();
    m_tripleErrors = 0.0;
    int taken = 0;
    double share = 1.0; // of the last move
    for (bool near = false; !near && taken < iterations; ++taken) {
        std::copy_n(m_position.begin(), nodes(), m_from.begin());
        const double before = assemble(pool);
        if (!solveForMoves(pool)) // something is not a number or negative: the watchdog sees it
            break;
        if (taken >= manyIterations && share == 1.0)
            m_panels.keepLess();
        moveAlongGuides();
        const Arrival arrival = arrive(pool);
        near = arrival.worst < tolerance
               && std::sqrt(arrival.errors) <= leftByNewton * m_accuracy * std::sqrt(pulls())
               && m_contacts.isSettled(leftByNewton * m_accuracy, taken);
        share = near ? 1.0 : goDown(before, pool);
        near &= m_contacts.follow(rowsThatMove(), m_mass, m_position);
        if (near)
            near = !m_contacts.holdHarder();
    }

    if (share < 1.0 && !m_contacts.empty()) // the balance of contacts was not found
        m_tripleErrors += energyLeft(share);

    m_residual = 0.0;
    if (pulls() > 0.0) {
        const double left = m_left / scaleOfErrors();
        m_residual = std::sqrt(left * left + m_tripleErrors / pulls());
    }
    keepCenters();
    pool.parallelFor(nodes(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            task.position[std::size_t(m_particle[i])] =
                Vec3(m_position[i].v[0], m_position[i].v[1], m_position[i].v[2]);
    });
    pool.parallelFor(m_bars.size(), [&](std::size_t first, std::size_t last) {
        for (const Bar& bar : std::span(m_bars).subspan(first, last - first))
            multiplier[std::size_t(bar.rod)] = pullOf(bar);
    });
    return taken;
}

// Takes as much of the move as brings the sum down, and returns how much of it that is. Where the
// whole of it takes a few particles into surfaces that did not act, those are put onto them and the
// others go all the way: of each step towards them, one surface after the other would stop all.
double DirectSolver::goDown(double before, ThreadPool& pool)
{
    if (merit() <= before)
        return 1.0;
    m_panels.keepMore();
    double share = 1.0;
    const bool lifts = m_guides.empty() && m_contacts.lift(m_position);
    if (lifts)
        measure(pool);
    if (!lifts || merit() > before)
        do
            go(share *= 0.5, pool);
        while (share > leastShareOfMove && merit() > before);
    takeShare(share);
    return share;
}

// Where particles would be in m_from, for the first look at obstacles: pulls of rods are taken as
// they were, since a heavy load on a light rope presses it on by many times its own weight. Panels
// are light and pull little for their masses.
RIPSTOP_CLONES
void DirectSolver::guessPushes(const RodTask& task)
{
    std::copy_n(m_position.begin(), nodes(), m_from.begin());
    if (!task.contacts || !m_panels.empty() || !m_bends.empty() || !m_fabricBends.empty())
        return;
    const std::size_t count = m_mass.size();
    const auto* const before = task.before.data();
    for (const Bar& bar : m_bars) {
        const Pack way = pack(before[m_particle[bar.b]]) - pack(before[m_particle[bar.a]]);
        const double length = __builtin_sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        if (bar.torn || length == 0.0)
            continue;
        const Pack pull = pullOf(bar) / length * way; // kg m
        if (bar.a < count)
            pack(m_from[bar.a].v) += pull / m_mass[bar.a];
        if (bar.b < count)
            pack(m_from[bar.b].v) -= pull / m_mass[bar.b];
    }
}

// Twice the energy of the pulls that a move has left which went only so far, kg m^2.
double DirectSolver::energyLeft(double share) const
{
    double twice = 0.0;
    for (const Bar& bar : m_bars) {
        const double left = (1.0 / share - 1.0) * (bar.multiplier - bar.before);
        twice += bar.isElastic ? bar.softness * left * left : 0.0;
    }
    return twice;
}

// Of a move that went only part of its way. What the linear system gave for the whole of it does
// not let go a line that is too long there: the sum counts it, and no way without it leads down.
void DirectSolver::takeShare(double share)
{
    m_pulls = 0.0;
    for (Bar& bar : m_bars) {
        bar.multiplier = bar.before + share * (bar.multiplier - bar.before);
        if (bar.multiplier * excess(bar) < 0.0)
            bar.multiplier = 0.0;
        m_pulls += energyOfPull(bar);
    }
    m_panels.settle(share);
    m_bends.settle(share);
    m_fabricBends.settle(share);
    m_contacts.settle(share);
    const ElasticPanels::Account account = m_panels.account();
    m_pulls += account.pulls;
    m_tripleErrors = account.errors + m_bends.errors() + m_fabricBends.errors();
}

bool DirectSolver::hasImpact() const
{
    if (m_contacts.hasImpact())
        return true;
    return m_hasOneWay
           && std::ranges::any_of(m_bars, [](const Bar& bar) { return stopsItsEnds(bar); });
}

// Where forces and rods are near their balance, as in all that hangs or is in the wind, particles
// go on as they were: that is a better start than where the forces alone take them. A place nearby
// that is known is better than either.
void DirectSolver::startNearer(const RodTask& task, ThreadPool& pool)
{
    std::copy_n(m_position.begin(), nodes(), m_from.begin());
    m_loads = orderedSum(pool, nodes(), [&](std::size_t first, std::size_t last) {
        double loads = 0.0;
        for (std::size_t i = first; i < last; ++i) {
            const auto p = std::size_t(m_particle[i]);
            pack(m_position[i].v) -= (task.h * task.h) * pack(task.acceleration[p]);
            loads += energyOfWay(i);
        }
        return loads;
    });
    if (!task.nearby.empty()) {
        takePositions(task.nearby, pool);
        return measure(pool);
    }
    double here = 0.0;
    double nearer = m_loads;
    inOrderedParts(
        pool, m_bars.size(),
        [&](std::size_t first, std::size_t last) { return startsOf(first, last); },
        [&](const Starts& part) {
            here += part.here;
            nearer += part.nearer;
        });
    here += m_contacts.energyAt(m_from);
    if (!m_bends.empty()) {
        std::swap_ranges(m_from.begin(), m_from.end(), m_position.begin()); // but for pins
        here += m_bends.measure(m_position);
        std::swap_ranges(m_from.begin(), m_from.end(), m_position.begin());
    }
    nearer += m_contacts.energyAt(m_position);
    nearer += m_bends.measure(m_position) + m_panels.measure(m_position, pool);
    m_fabricBends.measure(m_position, pool); // next to nothing of either
    if (nearer < here)
        return;
    std::swap_ranges(m_from.begin(), m_from.end(), m_position.begin());
    const bool isSure = m_panels.hasMoreThan(nearer - here, m_position);
    if (!isSure && nearer >= here + m_panels.measure(m_position, pool))
        return measure(pool);
    std::swap_ranges(m_from.begin(), m_from.end(), m_position.begin());
    if (!isSure)
        m_panels.measure(m_position, pool);
}

// Of rods, with their ends where m_from has them and where m_position does.
RIPSTOP_CLONES
DirectSolver::Starts DirectSolver::startsOf(std::size_t first, std::size_t last)
{
    const auto from = [this](std::uint32_t row) -> const Row& {
        return row < nodes() ? m_from[row] : m_position[row];
    };
    Starts starts;
    for (Bar& bar : std::span(m_bars).subspan(first, last - first)) {
        ripstop::measure(bar, from(bar.a), from(bar.b));
        bar.active = acts(bar);
        starts.here += energyOf(bar);
        ripstop::measure(bar, m_position[bar.a], m_position[bar.b]);
        bar.active = acts(bar);
        starts.nearer += energyOf(bar);
    }
    return starts;
}

// Measures rods, panels and bends with their ends where they are now.
void DirectSolver::measure(ThreadPool& pool)
{
    pool.parallelFor(m_bars.size(), [&](std::size_t first, std::size_t last) {
        for (Bar& bar : std::span(m_bars).subspan(first, last - first))
            ripstop::measure(bar, m_position[bar.a], m_position[bar.b]);
    });
    m_panels.measure(m_position, pool);
    m_bends.measure(m_position);
    m_fabricBends.measure(m_position, pool);
    m_contacts.measure(m_position);
}

// The moves lead along the guides but for rounding errors, which are taken out here.
void DirectSolver::moveAlongGuides() { keepOnGuides({m_move.data(), nodes()}); }

void DirectSolver::keepOnGuides(std::span<Row> rows) const
{
    for (std::size_t i = 0; i < std::min(m_guides.size(), rows.size()); ++i)
        moveAlongGuide(i, rows[i]);
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
DirectSolver::Arrival DirectSolver::arrive(ThreadPool& pool)
{
    pool.parallelFor(m_from.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            pack(m_position[i].v) = pack(m_from[i].v) + pack(m_move[i].v);
    });
    Arrival arrival;
    inOrderedParts(
        pool, m_bars.size(),
        [&](std::size_t first, std::size_t last) { return arriveOf(first, last); },
        [&](const Arrival& part) {
            arrival.pulls += part.pulls;
            arrival.errors += part.errors;
            if (!(part.worst <= arrival.worst))
                arrival.worst = part.worst;
        });
    m_pulls = arrival.pulls;
    m_tripleErrors = 0.0;
    if (!m_panels.empty()) {
        m_panels.foresee(m_move, pool);
        m_panels.measure(m_position, pool);
        const ElasticPanels::Account account = m_panels.account();
        m_pulls += account.pulls;
        m_tripleErrors = account.errors;
    }
    m_bends.foresee(m_move);
    m_bends.measure(m_position);
    m_fabricBends.foresee(m_move, pool);
    m_fabricBends.measure(m_position, pool);
    m_contacts.foresee(m_move);
    m_contacts.measure(m_position);
    m_tripleErrors += m_bends.errors() + m_fabricBends.errors();
    arrival.errors += m_tripleErrors;
    return arrival;
}

RIPSTOP_CLONES
DirectSolver::Arrival DirectSolver::arriveOf(std::size_t first, std::size_t last)
{
    Arrival arrival;
    for (Bar& bar : std::span(m_bars).subspan(first, last - first)) {
        foresee(bar);
        ripstop::measure(bar, m_position[bar.a], m_position[bar.b]);
        arrival.pulls += energyOfPull(bar);
        arrival.errors += energyOfError(bar);
        const double off = missOf(bar);
        if (!(off <= arrival.worst * bar.rest))
            arrival.worst = bar.rest > 0.0 ? off / bar.rest : off;
    }
    return arrival;
}

void DirectSolver::go(double share, ThreadPool& pool)
{
    for (std::size_t i = 0; i < m_from.size(); ++i)
        pack(m_position[i].v) = pack(m_from[i].v) + share * pack(m_move[i].v);
    measure(pool);
}

// The sum that is minimised, for the rods that are active now; kg m^2.
double DirectSolver::merit() const
{
    double twice = 0.0;
    for (std::size_t i = 0; i < m_mass.size(); ++i)
        twice += energyOfWay(i);
    for (const Bar& bar : m_bars)
        twice += energyOf(bar);
    return 0.5
           * (twice + m_panels.energy() + m_bends.energy() + m_fabricBends.energy()
              + m_contacts.energy());
}

} // namespace ripstop
