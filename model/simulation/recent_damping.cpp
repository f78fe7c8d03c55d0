#include "simulation/recent_damping.h"

#include "measure/diagnostics.h"

#include <algorithm>

namespace ripstop {
namespace {

constexpr double second = 1.0 - 1e-9; // s, of steps that may not add up to it

} // namespace

void RecentDamping::add(const NumericalDamping& step, const System& system, const State& state)
{
    if (m_seconds[m_now].length >= second) {
        m_now = (m_now + 1) % m_seconds.size();
        m_seconds[m_now] = {};
        m_full = std::min(m_full + 1, m_seconds.size() - 1);
    }
    Second& now = m_seconds[m_now];
    now.damping.add(step, system.timeStep);
    for (std::size_t i = 0; i < state.velocity.size(); ++i)
        if (system.inverseMass[i] > 0.0) {
            now.motion += 0.5 * system.mass[i] * state.velocity[i].squaredNorm() * system.timeStep;
            now.mass += system.mass[i] * system.timeStep;
        }
    now.length += system.timeStep;
    if (m_hasBegun && now.length < second)
        return;
    const double energy = energies(system, state).total();
    now.less = m_hasBegun ? m_energy - energy : 0.0;
    m_energy = energy;
    m_hasBegun = true;
}

double RecentDamping::ratio() const
{
    NumericalDamping all;
    for (const Second& one : m_seconds)
        all.add(one.damping, 1.0);
    return moves() ? all.ratio() : 0.0;
}

bool RecentDamping::moves() const
{
    constexpr double still = 0.01; // m/s, in the mean
    double motion = 0.0;
    double mass = 0.0;
    for (const Second& one : m_seconds) {
        motion += one.motion;
        mass += one.mass;
    }
    return 2.0 * motion > still * still * mass;
}

double RecentDamping::lost() const
{
    constexpr double about = 2.0;
    const std::size_t half = m_full / 2;
    if (half == 0 || !moves())
        return 0.0;
    double lost = 0.0;
    for (const std::size_t newest : {std::size_t(1), half + 1}) {
        double taken = 0.0;
        double less = 0.0;
        for (std::size_t age = newest; age < newest + half; ++age) {
            taken += before(age).damping.taken;
            less += before(age).less;
        }
        if (!(taken < about * less && less < about * taken))
            return 0.0;
        lost += std::min(taken, less);
    }
    const double left = before(1).motion / before(1).length;
    return lost / (lost + left);
}

} // namespace ripstop
