// Which rods are worth a direct block (direct_solver.h) beside sweeps.
//
// A sweep passes a pull on by one rod. Along a line of n particles of mass m that carries the load
// M, sweeps need about
//
//     n^2 / 10 + 2 n M / m
//
// passes until the pull is right (the slowest modes of J M^-1 J^T over its diagonal): 20 for a rope
// of 14 equal particles, 13 million for 65 kg on 100 particles of 1 g. The block takes what would
// need more than 200 passes:
//
// - *Rigging*: particles that are not of a mesh (corners of a panel, or of a triangle or square of
//   rods that are not all in a row, whose masses are alike within a factor of five) tied to
//   at most eight others and less than ten times as heavy as these. Those that rods join and that
//   are alike belong together. All their rods are taken, those to the fabric too: sweeps would
//   stretch these, since they take the light particle of a tight line for free. What a rigging ties
//   together are clusters: other particles, with the rods between them. Its load M is the mass of
//   all its clusters but the heaviest, and everything pinned is the heaviest; n is the number of
//   its particles for each end that it has beyond the first.
// - *Small frames*: all rods of a network (what rods join without passing a pin) of at most 500
//   particles that has such a rigging, or a particle 30 times as heavy as half of the others.
//
// A block of fabric soon costs more than its sweeps: a small frame is taken only if an iteration
// has at most 20 000 products of blocks, about 60 us, and else only its rigging. All blocks
// together have at most 500 particles, and the slowest candidates come first.
//
// - *Cheap networks*: all rods of a network of at most as many particles and products that has
//   panels, and of one without them that takes at most 20 products for each particle, as lines and
//   trusses of any size do. What air does to a kite or a glider is many times its weight, and
//   sweeps that hold it to 1 % take some 40 substeps, shake it and bring energy in; a block holds
//   it to 0.01 % in one. A bob on a line and a line between two pins gain energy from sweeps
//   without end, and break away.
//
// - *Flying fabric*: all rods of a network of any size that has panels, none of them at a pin, and
//   that ends in pins, as a kite does by its lines, or carries a particle 30 times as heavy as half
//   of the others, as a parachute does. The estimate above knows of weights and not of the air, so
//   that sweeps miss 1 % in a fifth of the steps, and take longer: a canopy of 5 000 particles
//   flies 2.5 times as fast when it is solved together.
#pragma once

#include "system/system.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace ripstop {

// A rod that never stretches is solved as if it gave way, so that nets of them have a solution:
// over the square of the substep by as much as this share of the inverse masses of its ends, 1/kg,
// at most.
inline constexpr double greatestSoftness = 1e-4;

// Places in system.rods, ascending. The system must be finished. They build arrays of the size of
// the system: they are called when the automatic solver makes its plan (step/solver_plan.h), not in
// each step.
std::vector<int> rodsForDirect(const System& system);
std::vector<int> rodsOfCheapNetworks(const System& system);
std::vector<int> rodsOfFlyingFabric(const System& system);

// All rods of the networks that have a rod like this, whatever their size.
std::vector<int> rodsOfNetworks(const System& system, const std::function<bool(const Rod&)>& isOne);

// m/s^2, by which weights stand for the loads of a design; that of the earth at least, since wind
// loads what floats in space, too.
inline double loadingGravity(const System& system)
{
    return std::max(system.gravity.norm(), 9.80665);
}

} // namespace ripstop
