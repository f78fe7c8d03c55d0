// Loads of the air at the end of a substep, where all rods are solved together and light cloth
// would otherwise need many substeps.
//
// What a load falls by with the speed of a particle, D, joins its mass (withDamping). How loads
// turn with the cloth does not: BDF2 takes them where the cloth is foreseen, as it went on before.
// Where the solve has led a panel elsewhere by an angle that matters, loads are those of a motion
// that did not happen, late by a part of the substep, and what comes late drives a swing instead of
// holding it: light sails of fine meshes flutter in a steady wind. Then the substep is done once
// more with the loads of where the first solve has led, which is one correction of a
// predictor-corrector method (Hairer, Norsett and Wanner, Solving Ordinary Differential Equations
// I, 1993, section III.1). What flies steadily needs none.
#pragma once

#include "forces/force.h"
#include "system/system.h"

#include <span>

namespace ripstop {

// What velocities are looked back to, all of [particles], m/s.
struct SeenVelocities
{
    std::span<const PaddedVec3> seen;   // by the forces
    std::span<const PaddedVec3> now;    // at the start of the substep
    std::span<const PaddedVec3> before; // a substep earlier; empty where nothing is known
};

// Forces F that fall by D for each m/s are not those of the velocity v* that they saw but of the
// one, v, that they lead to: (m + k D) v = m v0 + k (F + D v*), k being the reach
// (particle_motion.h) and v0 what BDF2 begins with, or the velocity at the start.
//   acceleration  [particles]  m/s^2, of F
//   result        [particles]  m/s^2, of what makes v of v0 as F did
void withDamping(const System& system, const Damping& damping, double reach,
                 const SeenVelocities& velocities, std::span<const PaddedVec3> acceleration,
                 std::vector<PaddedVec3>& result);

// Whether a panel that the air meets has turned so far from where it was foreseen that its load is
// another by more than half of the accuracy wanted.
//   start  [particles]  m, at the start of the substep `h`, s; velocities then are velocityBefore
bool hasTurnedFromForeseen(const System& system, const State& state,
                           std::span<const PaddedVec3> start, double h);

} // namespace ripstop
