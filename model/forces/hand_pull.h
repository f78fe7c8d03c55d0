// The pull of a hand: a damped spring between a grip and a place in the air.
//
//     F = k (to - p) - c v,   p = sum of s x, v = sum of s v over the particles of the grip
//
// k is the stiffness, |F| at most HandPull::most, and each particle takes its share s of F, so that
// forces and torques on a panel are those of a pull at the point itself. With the mass in the grip
// 1 / m = sum of s^2 / m, the damping is c = 2 z sqrt(k m) / (1 + h c / m), z that of HandPull:
// what a substep of h would overshoot is left out.
//
// A hand must not be what blows up a step: k is lowered where (h w)^2 + 2 h c / m would leave what
// the springs at the grip leave of the limit of 4 (laws/step_limit.h). Rods do not count, as they
// are projected.
#pragma once

#include "system/system.h"

#include <span>

namespace ripstop {

// The particles of a grip in one system.
struct HeldGrip
{
    Grip grip;
    std::array<int, 3> particle{-1, -1, -1}; // indices, -1 without a share
    std::uint64_t serial = 0;                // of the system

    bool isOf(const System& system, const Grip& other) const
    {
        return serial == system.serial && grip == other;
    }
    bool holds() const; // whether all particles of the grip are there
};

HeldGrip findGrip(const System& system, const Grip& grip);

struct HandForce
{
    Vec3 point = Vec3::Zero(); // m, in the grip
    Vec3 force = Vec3::Zero(); // N, on it
    double stiffness = 0.0;    // N/m, that the time step allows
};

// The force of the hand as it is in a state; zero when particles of the grip are not there.
//   h  s, of a substep
HandForce handForce(const System& system, const State& state, const HandPull& pull,
                    const HeldGrip& held, double h);

// Adds the pull of state.hands, which must have one, to the particles of its grip.
//   acceleration  [particles]  m/s^2
void addHandPull(const System& system, const State& state, const HeldGrip& held, double h,
                 std::span<PaddedVec3> acceleration);

} // namespace ripstop
