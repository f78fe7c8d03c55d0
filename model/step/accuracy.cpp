#include "step/accuracy.h"

#include "constraints/rod_damping.h"
#include "parallel/ordered_parts.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double unseen = 1e-5; // strain

struct Sums // over some rods
{
    double off = 0.0, whole = 0.0; // J, twice the energies
    double most = 0.0;             // J, of one rod
    StepAccuracy worst;

    void add(const Sums& other)
    {
        off += other.off;
        whole += other.whole;
        if (other.most > most) {
            most = other.most;
            worst.pullsRod = other.worst.pullsRod;
        }
        if (other.worst.strain > worst.strain) {
            worst.strain = other.worst.strain;
            worst.strainRod = other.worst.strainRod;
        }
    }
};

Sums sumsOf(const System& system, const State& state, std::span<const double> restLength,
            double reach, std::size_t first, std::size_t last)
{
    Sums sums;
    for (std::size_t r = first; r < last; ++r) {
        const Rod& rod = system.rods[r];
        const double rest = restLength[r];
        const bool isHeld = system.inverseMass[std::size_t(rod.a)] == 0.0
                            && system.inverseMass[std::size_t(rod.b)] == 0.0;
        if (state.rodTorn[r] || isHeld)
            continue;
        const double length =
            (state.position[std::size_t(rod.b)] - state.position[std::size_t(rod.a)]).norm();
        const double stretch = isSlack(rod.resists, length - rest) ? 0.0 : length - rest;
        if (rod.compliance > 0.0) {
            const double compliance = complianceOver(rod, reach);
            const double stiffness = 1.0 / compliance;
            const double given = compliance * state.rodTension[r]; // m, the stretch that it is of
            const double share = (stretch - given) * (stretch - given) * stiffness;
            sums.off += share;
            sums.whole += (given * given + unseen * unseen * rest * rest) * stiffness;
            if (share > sums.most) {
                sums.most = share;
                sums.worst.pullsRod = int(r);
            }
        } else if (rest > 0.0 && std::abs(stretch) > sums.worst.strain * rest) {
            sums.worst.strain = std::abs(stretch) / rest;
            sums.worst.strainRod = int(r);
        }
    }
    return sums;
}

} // namespace

double StepAccuracy::ratio(const System& system) const
{
    return std::max(pulls / system.accuracy, strain / system.strainGoal);
}

int StepAccuracy::worstRod(const System& system) const
{
    return pulls / system.accuracy > strain / system.strainGoal ? pullsRod : strainRod;
}

StepAccuracy accuracyOf(const System& system, const State& state,
                        std::span<const double> restLength, ThreadPool& pool, double reach,
                        double leastEnergy)
{
    Sums all;
    inOrderedParts(
        pool, system.rods.size(),
        [&](std::size_t first, std::size_t last) {
            return sumsOf(system, state, restLength, reach, first, last);
        },
        [&](const Sums& part) { all.add(part); });
    if (all.whole > 0.0)
        all.worst.pulls = std::sqrt(all.off / std::max(all.whole, leastEnergy));
    return all.worst;
}

} // namespace ripstop
