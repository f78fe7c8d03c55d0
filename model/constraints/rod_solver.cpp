// Which solver holds the rods of a substep, and what their tensions are.
//
// start() prepares the direct solver for all rods, for those marked beside sweeps, or for none.
// project() makes one substep: coloured sweeps and then the direct block, which has the last word
// on its rods; or the direct solver alone; or averaged sweeps, which stand here. takeTensions()
// makes newtons of the multipliers of all substeps.
#include "constraints/rod_solver.h"

#include "constraints/guided_rod.h"
#include "constraints/guides.h"
#include "constraints/rod_damping.h"

#include <algorithm>
#include <limits>

namespace ripstop {
namespace {

double allowed(Resists resists, double multiplier)
{
    switch (resists) {
    case Resists::Tension:
        return std::max(multiplier, 0.0);
    case Resists::Compression:
        return std::min(multiplier, 0.0);
    case Resists::Both:
        break;
    }
    return multiplier;
}

// The most iterations of a direct solve, which ends as soon as it has converged. Two are enough for
// rods; lines that go slack and tight again need more to find out which of them pull: with four, a
// load of 65 000 times the mass of its line flew off. A sheet in the wind folds at every cell and
// may need twenty.
constexpr int enoughIterations = 30;
constexpr int enoughForPanels = 40; // which wrinkle as well

} // namespace

void RodSolver::start(const RodTask& task, std::span<const double> tension)
{
    m_substeps = 0;
    m_multiplier.resize(task.system.rods.size());
    prepareDirect(task);
    if (!m_direct.isEmpty())
        m_tension.assign(tension.begin(), tension.end());
}

void RodSolver::project(const RodTask& task, ThreadPool& pool)
{
    if (task.system.rods.empty() && task.system.membranes.empty())
        return;
    m_substeps += task.note;
    switch (task.solver) {
    case Solver::GaussSeidel:
    case Solver::SmallSteps:
        m_coloured.project(task, pool);
        projectDirect(task, enoughIterations, pool);
        break;
    case Solver::Direct:
        projectDirect(task, std::max(task.sweeps, enoughIterations), pool);
        break;
    case Solver::AveragedJacobi:
    case Solver::PaperJacobi:
        average(task, pool);
        projectDirect(task, enoughIterations, pool); // the panels that carry a pull
        break;
    case Solver::Auto:
        break;
    }
}

void RodSolver::projectDirect(const RodTask& task, int iterations, ThreadPool& pool)
{
    if (m_direct.isEmpty())
        return;
    const double square = task.h * task.h;
    const std::span rods = m_direct.rods();
    pool.parallelFor(rods.size(), [&](std::size_t first, std::size_t last) {
        for (const int rod : rods.subspan(first, last - first))
            m_multiplier[std::size_t(rod)] = m_tension[std::size_t(rod)] * square;
    });
    m_direct.start(task, m_multiplier, pool);
    const int most =
        task.system.membranes.empty() ? iterations : std::max(iterations, enoughForPanels);
    m_direct.project(task, m_multiplier, most, pool, task.tolerance);
    pool.parallelFor(rods.size(), [&](std::size_t first, std::size_t last) {
        for (const int rod : rods.subspan(first, last - first))
            m_tension[std::size_t(rod)] = m_multiplier[std::size_t(rod)] / square;
    });
}

void RodSolver::takeTensions(const RodTask& task, ThreadPool& pool, std::span<double> tension)
{
    if (m_substeps == 0)
        return;
    const double newtons = 1.0 / (task.h * task.h * m_substeps);
    if (task.solver == Solver::GaussSeidel || task.solver == Solver::SmallSteps)
        m_coloured.takeMultipliers(task.system, newtons, pool, tension);
    else if (task.solver != Solver::Direct)
        for (std::size_t i = 0; i < m_sum.size(); ++i)
            tension[i] = m_sum[i] * newtons;
    takeDirectTensions(tension);
    m_substeps = 0;
}

void RodSolver::takeDirectTensions(std::span<double> tension) const
{
    for (const int rod : m_direct.rods())
        tension[std::size_t(rod)] = m_tension[std::size_t(rod)];
}

// The direct solver has all rods, those that are marked, or none; and all elastic panels.
void RodSolver::prepareDirect(const RodTask& task)
{
    const System& system = task.system;
    const bool beside = (task.solver == Solver::GaussSeidel || task.solver == Solver::SmallSteps)
                        && !task.direct.empty();
    const std::size_t count = beside || task.solver == Solver::Direct ? system.rods.size() : 0;
    const std::span<const std::uint8_t> marks = task.direct.first(beside ? count : 0);
    if (system.serial != m_serial || count != m_mayHave || !std::ranges::equal(marks, m_marks)) {
        m_mayHave = count;
        m_marks.assign(marks.begin(), marks.end());
        std::vector<int> rods;
        for (std::size_t i = 0; i < count; ++i)
            if (!beside || task.direct[i])
                rods.push_back(int(i));
        m_direct.prepare(system, rods, DirectSolver::Triples::Taken);
    } else if (system.valuesSerial != m_valuesSerial) {
        m_direct.refresh(system);
    }
    m_serial = system.serial;
    m_valuesSerial = system.valuesSerial;
}

void RodSolver::average(const RodTask& task, ThreadPool& pool)
{
    m_pull.resize(task.system.rods.size());
    std::fill(m_multiplier.begin(), m_multiplier.end(), 0.0);
    countRods(task);
    for (int sweep = 0; sweep < task.sweeps; ++sweep)
        averagedSweep(task, pool);
    if (!task.note)
        return;
    if (m_substeps == 1) // the first that is noted
        m_sum.assign(m_multiplier.begin(), m_multiplier.end());
    else
        for (std::size_t i = 0; i < m_sum.size(); ++i)
            m_sum[i] += m_multiplier[i];
}

void RodSolver::countRods(const RodTask& task)
{
    m_valence.assign(task.system.inverseMass.size(), 0.0);
    for (std::size_t i = 0; i < task.system.rods.size(); ++i)
        if (!task.torn[i]) {
            m_valence[std::size_t(task.system.rods[i].a)] += 1.0;
            m_valence[std::size_t(task.system.rods[i].b)] += 1.0;
        }
}

// One Jacobi sweep: every rod looks at the same positions, every particle averages what its rods
// want. Mass-split (Tonge 2012): each end counts as n w, n its number of rods, so that both ends
// get opposite impulses and momentum is kept. The paper's way (Beaudry, Egli and Patenaude 2005,
// figure 8, with the direction normalised) divides at each end by that end's own number.
void RodSolver::averagedSweep(const RodTask& task, ThreadPool& pool)
{
    const System& system = task.system;
    const bool paper = task.solver == Solver::PaperJacobi;
    const double perSquare = 1.0 / (task.h * task.h);
    constexpr double most = std::numeric_limits<double>::infinity();

    pool.parallelFor(system.rods.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Rod& rod = system.rods[i];
            const auto a = std::size_t(rod.a);
            const auto b = std::size_t(rod.b);
            const Vec3 separation = task.position[b] - task.position[a];
            const double length = separation.norm();
            const double splitA = paper ? 1.0 : m_valence[a];
            const double splitB = paper ? 1.0 : m_valence[b];
            const double softness = paper ? 0.0 : complianceOver(rod, task.h) * perSquare;
            const double weight =
                splitA * system.inverseMass[a] + splitB * system.inverseMass[b] + softness;
            m_pull[i].setZero();
            if (length == 0.0 || weight == 0.0 || task.torn[i])
                continue;

            const double stretch = length - task.restLength[i];
            const double old = m_multiplier[i];
            const GuidedParticle* const guideA = guideOf(system, rod.a);
            const GuidedParticle* const guideB = guideOf(system, rod.b);
            double total = allowed(rod.resists, old + (stretch - softness * old) / weight);
            if (guideA || guideB) {
                const auto move = [&](const GuidedParticle* guide, double inverseMass) {
                    const Vec3 free = inverseMass / length * separation;
                    return guide ? guide->freePart(free) : free;
                };
                const Vec3 perMultiplier = move(guideA, splitA * system.inverseMass[a])
                                           + move(guideB, splitB * system.inverseMass[b]);
                total = multiplierAfter({separation, perMultiplier, task.restLength[i], softness,
                                         allowed(rod.resists, -most), allowed(rod.resists, most)},
                                        old);
            }
            m_pull[i] = ((total - old) / length) * separation;
            // The paper moves the ends by different shares of the pull; the mean share is the
            // best account of the force that it gives.
            const double share = paper ? 0.5 / m_valence[a] + 0.5 / m_valence[b] : 1.0;
            m_multiplier[i] = old + share * (total - old);
        }
    });

    pool.parallelFor(system.inverseMass.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            if (system.inverseMass[p] == 0.0 || m_valence[p] == 0.0)
                continue;
            Vec3 sum = Vec3::Zero();
            for (int k = system.rodsAt.start[p]; k < system.rodsAt.start[p + 1]; ++k) {
                const auto rod = std::size_t(system.rodsAt.items[std::size_t(k)]);
                if (std::size_t(system.rods[rod].a) == p)
                    sum += m_pull[rod];
                else
                    sum -= m_pull[rod];
            }
            if (const GuidedParticle* guide = guideOf(system, int(p)))
                sum = guide->freePart(sum);
            task.position[p] += (system.inverseMass[p] / (paper ? m_valence[p] : 1.0)) * sum;
        }
    });
}

} // namespace ripstop
