// How far a spar is bent at a particle, and what that costs (bend.h).
#include "laws/bend.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

SparTurn turnOf(const Bend& bend, const std::array<Vec3, 2>& ways)
{
    SparTurn turn{Vec3::Zero(), {}};
    for (std::size_t k = 0; k < 2; ++k) {
        const double turning = bend.weight[k + 1] * bend.length[k]; // m, L
        const double size = ways[k].norm();
        const double length = std::max(size, leastShare * bend.length[k]);
        turn.turn += turning / length * ways[k];
        turn.slope[k] = turning / length * Mat3::Identity();
        if (length == size)
            turn.slope[k] -= turning / (length * length * length) * ways[k] * ways[k].transpose();
    }
    return turn;
}

// The turn is 2 L sin(angle / 2), so that its slope over the angle is L cos(angle / 2). L is what
// turns: less at a clamp, where half of it is held.
double momentOf(const Bend& spar, const std::array<Vec3, 2>& ways)
{
    const double size = turnOf(spar, ways).turn.norm();
    const double length = spar.weight[1] * spar.length[0];
    const double sine = std::min(size / (2.0 * length), 1.0);
    return std::abs(spar.stiffness * (size - spar.restTurn)) * length
           * std::sqrt(1.0 - sine * sine);
}

double energyOf(const Bend& spar, const std::array<Vec3, 2>& ways)
{
    const double over = turnOf(spar, ways).turn.norm() - spar.restTurn;
    return 0.5 * spar.stiffness * over * over;
}

} // namespace ripstop
