// How much the steps themselves damp the motion that they compute, measured in the motion: a step
// may find every pull right, and still let what swings fast die away. true_swings.h says how fast
// that is; this says whether the scene at hand moves so.
//
// Implicit methods take energy from a swing. From their energy balance (Hairer and Wanner, Solving
// Ordinary Differential Equations II, 1996, sections IV.12 and V.6), v0, v1, v2 being the
// velocities of successive substeps:
//
//     backward Euler   sum m |v1 - v0|^2               both of motion and of what is stretched
//     BDF2             sum m |v2 - 2 v1 + v0|^2 / 2    the same
//
// What goes to and fro meanwhile is sum m |v| |v1 - v0| along each axis, four times the energy of a
// swing in each of its periods; what goes round is two swings across each other. A damper that
// takes the share z of the critical takes 4 pi z of that energy, so
//
//     z = taken / (pi turned)
//
// is the damping ratio of the steps; for one swing, h being the substep, it comes to w h / 2 with
// backward Euler and (w h)^3 / 4 with BDF2, as it should. Of many swings it is the mean, weighted
// by how fast their energy turns. Cords have about 0.01 of their own.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>

namespace ripstop {

struct NumericalDamping
{
    double taken = 0.0;  // W, or J of many steps
    double turned = 0.0; // the same

    double ratio() const; // 1, of the critical; 0 where nothing moves

    void add(const NumericalDamping& other, double share);
};

// How a substep came from the velocities at its start.
enum class StepFormula { Euler, Bdf2 };

// Of the last substep, of which `state` is the end. Particles that have met an obstacle in this
// step do not count, as impacts take energy from what falls. Nor do, with other integrators than
// BDF2, particles that no rod or panel is at: what springs alone do to them is told without
// damping.
//   start    [particles] m/s, at its start; or empty, where nothing is known
//   touches  [particles] touchOf() of this step, or empty
NumericalDamping numericalDampingOf(const System& system, const State& state,
                                    std::span<const PaddedVec3> start,
                                    std::span<const std::uint32_t> touches, StepFormula formula,
                                    double substep, ThreadPool& pool);

} // namespace ripstop
