// What a substep does to each particle, apart from the rods: integrate, and turn what the rods
// did to positions into velocity.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <cstddef>

namespace ripstop {

struct ParticleMotion // arrays of [particles]
{
    PaddedVec3* position;           // m
    PaddedVec3* velocity;           // m/s
    PaddedVec3* drift;              // m/s, (x - previous x) / h, for who looks back
    PaddedVec3* velocityBefore;     // m/s, a substep ago; BDF2's
    PaddedVec3* before;             // m, at the start of the substep
    PaddedVec3* scratch;            // of explicit Euler and BDF2
    const PaddedVec3* acceleration; // m/s^2
    const double* inverseMass;      // 1/kg
    double h;                       // s
    double reach;                   // s, reachOf()
    double keep;                    // share of the speed that viscosity leaves
    bool drifts;                    // `drift` is of a substep of this length, and so on
    bool damps;                     // what forces take from motion joins the masses
};

enum class ParticlePass {
    Foresee,          // BDF2: the motion that forces see; `before` and `scratch` keep that of now
    Predict,          // where particles would be without rods
    PredictAnew,      // BDF2: the same as its first substep, after Predict
    FollowRods,       // velocities that take over what the rods did
    FollowContact,    // BDF2: what contact does, done to what it looks back to as well
    ForeseeVelocities // velocity Verlet: the velocities that forces at the end of the step see
};

// The length of a substep, s, by which rods move what they pull: x - y = reach^2 a.
double reachOf(Integrator integrator, double h, bool drifts);

// What BDF2 looks back to where the substep is not as long as the last one: what was a substep of h
// ago, if things were accelerated then as they were since.
void lookBackAsFar(State& state, double h, ThreadPool& pool);

// For particles first .. last - 1.
void runPass(ParticlePass pass, Integrator integrator, const ParticleMotion& motion,
             std::size_t first, std::size_t last);

} // namespace ripstop
