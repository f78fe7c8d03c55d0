// What a substep does to each particle, apart from the rods: integrate, and turn what the rods
// did to positions into velocity.
#pragma once

#include "system/system.h"

#include <cstddef>

namespace ripstop {

struct ParticleMotion // arrays of [particles]
{
    PaddedVec3* position;           // m
    PaddedVec3* velocity;           // m/s
    PaddedVec3* drift;              // m/s, what both Verlets remember
    PaddedVec3* before;             // m, at the start of the substep
    PaddedVec3* predicted;          // m, before projection; explicit Euler only
    const PaddedVec3* acceleration; // m/s^2
    const double* inverseMass;      // 1/kg
    double h;                       // s
    double keep;                    // share of the speed that viscosity leaves
    bool drifts;                    // `drift` is of a substep of this length
};

enum class ParticlePass {
    Predict,          // where particles would be without rods
    FollowRods,       // velocities that take over what the rods did
    ForeseeVelocities // velocity Verlet: the velocities that forces at the end of the step see
};

// For particles first .. last - 1.
void runPass(ParticlePass pass, Integrator integrator, const ParticleMotion& motion,
             std::size_t first, std::size_t last);

} // namespace ripstop
