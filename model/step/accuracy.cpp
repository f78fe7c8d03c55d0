#include "step/accuracy.h"

#include "constraints/rod_damping.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double unseen = 1e-5; // strain

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
                        std::span<const double> restLength, double reach)
{
    StepAccuracy result;
    double off = 0.0, whole = 0.0, most = 0.0; // J, twice the energies
    for (std::size_t r = 0; r < system.rods.size(); ++r) {
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
            off += share;
            whole += (given * given + unseen * unseen * rest * rest) * stiffness;
            if (share > most) {
                most = share;
                result.pullsRod = int(r);
            }
        } else if (rest > 0.0 && std::abs(stretch) > result.strain * rest) {
            result.strain = std::abs(stretch) / rest;
            result.strainRod = int(r);
        }
    }
    if (whole > 0.0)
        result.pulls = std::sqrt(off / whole);
    return result;
}

} // namespace ripstop
