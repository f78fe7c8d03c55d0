#include "constraints/guided_rod.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

double multiplierAfter(const GuidedPull& pull, double multiplier)
{
    const double length = pull.separation.norm();
    const double square = pull.perMultiplier.squaredNorm();
    if (length == 0.0 || square == 0.0)
        return multiplier;
    const double along = pull.separation.dot(pull.perMultiplier);
    const double weight = along / length;
    if (weight + pull.softness <= 0.0)
        return multiplier;
    const auto allowed = [&](double total) {
        return std::min(std::max(total, pull.lowest), pull.highest);
    };
    const double stretch = length - pull.rest;
    const double straight =
        allowed(multiplier + (stretch - pull.softness * multiplier) / (weight + pull.softness));
    const double wanted = std::max(length - weight * (straight - multiplier), 0.0);
    const double missing = (length - wanted) * (length + wanted);
    const double root = along * along - square * missing;
    const double step = root > 0.0 ? missing / (along + std::sqrt(root)) : along / square;
    return allowed(multiplier + step);
}

void project(GuidedRod& rod, PaddedVec3* position)
{
    Vec3& a = position[rod.a];
    Vec3& b = position[rod.b];
    const Vec3 separation = b - a;
    if (rod.torn || separation.isZero(0.0))
        return;
    const Vec3 direction = separation.normalized();
    const Vec3 moveA = rod.inverseMassA * rod.guideA.freePart(direction);
    const Vec3 moveB = rod.inverseMassB * rod.guideB.freePart(direction);
    const double total = multiplierAfter(
        {separation, moveA + moveB, rod.rest, rod.softness, rod.lowest, rod.highest},
        rod.multiplier);
    const double change = total - rod.multiplier;
    rod.multiplier = total;
    a += change * moveA;
    b -= change * moveB;
}

} // namespace ripstop
