// Statics: the load on a rigid design in a steady wind.
//
// Builders use it to place what a craft hangs from and to start it in trim. Known here is what
// flying designs are built with, the linear-normal law,
//     F = 1/2 rho A (Ca |w| (n.w) n + Cf |wt| wt),   w the wind that the panel feels, m/s,
// and the vortex law (laws/vortex_wing.h).
#pragma once

#include "base/angle.h"
#include "scene/scene.h"

#include <Eigen/Geometry>

#include <cmath>

namespace ripstop {

struct Load
{
    Vec3 force = Vec3::Zero();  // N
    Vec3 moment = Vec3::Zero(); // N m, about the origin
};

// The load on all panels of a part that is at rest in `wind`, m/s.
Load airLoad(const Scene& scene, const Part& part, const Vec3& wind);

struct LumpedMass
{
    double mass = 0.0;          // kg
    Vec3 center = Vec3::Zero(); // m
};
LumpedMass lumpedMassOf(const Part& part);

// Where a function that changes sign between `low` and `high` is zero, by 60 halvings. Without
// a change of sign it is the end at which the function is nearer to zero.
template <typename Function>
double root(const Function& function, double low, double high)
{
    const double atLow = function(low);
    const double atHigh = function(high);
    if ((atLow > 0.0) == (atHigh > 0.0))
        return std::abs(atLow) < std::abs(atHigh) ? low : high;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        ((function(middle) > 0.0) == (atLow > 0.0) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

inline constexpr double pi = std::numbers::pi;

} // namespace ripstop
