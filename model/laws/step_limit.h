// How long a substep with springs may be.
//
// The largest frequency at a particle of mass m is at most w^2 = 2 K / m and the largest rate of
// damping c = 2 N / m (Gershgorin), K and N being the sums of stiffness (N/m) and damping (N s/m)
// of the springs there. Semi-implicit Euler and Verlet are stable while (w h)^2 + 2 c h < 4, so
//
//     h < (sqrt(c^2 + 4 w^2) - c) / w^2,
//
// which is sqrt(2 m / K) without damping. BDF2 with forces that are foreseen is stable for at
// least 0.72 of that, by its recurrence. The check of a scene, the watchdog and the choice of
// substeps all ask here, so that they say the same.
#pragma once

#include "laws/solver_laws.h"

#include <cmath>
#include <limits>

namespace ripstop {

// Substeps of BDF2 that what bends has to be stable for as a force, by the limit below.
constexpr double slowBends = 2.0;

// What substeps that are chosen keep to spare of their limit, as forces change in flight.
constexpr double spareOfSubsteps = 1.05;

// The limit above for one particle, s; infinite where nothing bounds it. The formula is turned
// around so that it holds for w = 0 too.
//   mass, stiffness, damping  kg, N/m, N s/m
inline double springStepLimit(double mass, double stiffness, double damping, Integrator integrator)
{
    constexpr double shareOfBdf2 = 0.7;
    const double w2 = 2.0 * stiffness / mass;
    const double c = 2.0 * damping / mass;
    const double sum = c + std::sqrt(c * c + 4.0 * w2);
    const double share = integrator == Integrator::Bdf2 ? shareOfBdf2 : 1.0;
    return sum > 0.0 ? share * 4.0 / sum : std::numeric_limits<double>::infinity();
}

} // namespace ripstop
