#include "sim/rod_solver.h"

#include <algorithm>
#include <numeric>

namespace ripstop {
namespace {

// SplitMix64 (Steele, Lea and Flood 2014): a good hash of a counter.
std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

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

} // namespace

void RodSolver::project(const RodTask& task, Crew& crew)
{
    if (task.system.rods.empty())
        return;
    if (task.system.solver == Solver::GaussSeidel) {
        m_colorOrder.resize(task.system.colorStart.size() - 1);
        std::iota(m_colorOrder.begin(), m_colorOrder.end(), 0);
        for (int sweep = 0; sweep < task.system.sweeps; ++sweep) {
            // A fixed order of colours feeds energy into braced frames: they flutter however many
            // substeps there are. Another order each time, the same in every run, cures it.
            shuffleColors(task.seed * 1000003u + std::uint64_t(sweep));
            colouredSweep(task, crew);
        }
    } else {
        m_pull.resize(task.system.rods.size());
        countRods(task);
        for (int sweep = 0; sweep < task.system.sweeps; ++sweep)
            averagedSweep(task, crew);
    }
}

void RodSolver::shuffleColors(std::uint64_t seed)
{
    for (std::size_t i = m_colorOrder.size(); i > 1; --i)
        std::swap(m_colorOrder[i - 1], m_colorOrder[mixed(seed + i) % i]);
}

// XPBD, Macklin, Mueller and Chentanez 2016, equations 17 and 18, without damping.
void RodSolver::colouredSweep(const RodTask& task, Crew& crew)
{
    const System& system = task.system;
    const double perSquare = 1.0 / (task.h * task.h);
    for (const int color : m_colorOrder) {
        const auto begin = std::size_t(system.colorStart[std::size_t(color)]);
        const auto end = std::size_t(system.colorStart[std::size_t(color) + 1]);
        crew.each(end - begin, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = begin + first; i < begin + last; ++i) {
                const Rod& rod = system.rods[i];
                const auto a = std::size_t(rod.a);
                const auto b = std::size_t(rod.b);
                const double wa = system.inverseMass[a];
                const double wb = system.inverseMass[b];
                const Vec3 separation = task.position[b] - task.position[a];
                const double length = separation.norm();
                const double softness = rod.compliance * perSquare;
                const double weight = wa + wb + softness;
                // Coincident ends have no direction to move along; two rigid pins cannot move.
                if (length == 0.0 || weight == 0.0 || task.torn[i])
                    continue;

                const double stretch = length - task.restLength[i];
                const double old = task.multiplier[i];
                // Clamp the running total, not the change: a line may give back pull it took.
                const double total =
                    allowed(rod.resists, old + (stretch - softness * old) / weight);
                const Vec3 pull = ((total - old) / length) * separation;
                if (wa > 0.0)
                    task.position[a] += wa * pull;
                if (wb > 0.0)
                    task.position[b] -= wb * pull;
                task.multiplier[i] = total;
            }
        });
    }
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
void RodSolver::averagedSweep(const RodTask& task, Crew& crew)
{
    const System& system = task.system;
    const bool paper = system.solver == Solver::PaperJacobi;
    const double perSquare = 1.0 / (task.h * task.h);

    crew.each(system.rods.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Rod& rod = system.rods[i];
            const auto a = std::size_t(rod.a);
            const auto b = std::size_t(rod.b);
            const Vec3 separation = task.position[b] - task.position[a];
            const double length = separation.norm();
            const double splitA = paper ? 1.0 : m_valence[a];
            const double splitB = paper ? 1.0 : m_valence[b];
            const double softness = paper ? 0.0 : rod.compliance * perSquare;
            const double weight =
                splitA * system.inverseMass[a] + splitB * system.inverseMass[b] + softness;
            m_pull[i].setZero();
            if (length == 0.0 || weight == 0.0 || task.torn[i])
                continue;

            const double stretch = length - task.restLength[i];
            const double old = task.multiplier[i];
            const double total = allowed(rod.resists, old + (stretch - softness * old) / weight);
            m_pull[i] = ((total - old) / length) * separation;
            // The paper moves the ends by different shares of the pull; the mean share is the
            // best account of the force that it gives.
            const double share = paper ? 0.5 / m_valence[a] + 0.5 / m_valence[b] : 1.0;
            task.multiplier[i] = old + share * (total - old);
        }
    });

    crew.each(system.inverseMass.size(), [&](std::size_t first, std::size_t last) {
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
            task.position[p] += (system.inverseMass[p] / (paper ? m_valence[p] : 1.0)) * sum;
        }
    });
}

} // namespace ripstop
