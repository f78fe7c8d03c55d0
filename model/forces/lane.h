// What a force does to its elements, on the way to the particles.
//
// A force is computed once for each of its elements (a spring, a panel, a line) and then gathered
// at each particle from the elements there, in ascending order, so that a sum does not depend on
// who computed what when. A lane is one such array of elements with the way to share it out. The
// stepper gathers lanes for accelerations, the energy ledger for power.
#pragma once

#include "base/rows.h"
#include "base/vec3.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ripstop {

// Of the three ways to share an element out, the first that is given holds: `minus`, `weight`,
// equal parts.
struct Lane
{
    const PaddedVec3* load = nullptr;    // [elements] N; null where there is nothing to gather
    const Rows* at = nullptr;            // [particles] elements there
    const std::uint8_t* minus = nullptr; // [at->items] 1 where the particle takes the opposite
    const double* weight = nullptr;      // [at->items] 1, what the particle takes of the element
    double parts = 1.0;                  // how many particles share an element
};

// Accelerations of particles first .. last - 1, m/s^2: that which all have, and the sum of the
// lanes, in their order, times the inverse mass; zero for what is pinned.
//   inverseMass, acceleration  [particles]  1/kg, m/s^2
void gatherAccelerations(std::span<const Lane> lanes, const Vec3& common, const double* inverseMass,
                         PaddedVec3* acceleration, std::size_t first, std::size_t last);

// Adds what the particles take of a lane.
//   force  [particles]  N
void addForces(const Lane& lane, std::span<Vec3> force);

} // namespace ripstop
