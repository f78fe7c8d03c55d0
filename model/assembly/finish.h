// Makes a System whole: whatever follows from its own arrays is filled in here, once when it is
// made and again, in part, when it was changed in place.
//
// It stands above the rooms of system, forces and constraints, since the order of rods and
// what forces derive from the rest are their knowledge. None of this may run beside a step.
#pragma once

#include "constraints/rod_order.h"
#include "system/system.h"

namespace ripstop {

// Fills what follows from the rest: the order of `rods` (and of the indices that point into it),
// incidence lists, the sizes of `start`. It is called once and last. It needs inverseMass, springs,
// rods, panels and start.position. Keys and links that are left empty are numbered; masses that are
// left empty follow from inverseMass; velocities that are missing are zero.
void finish(System& system);

// finish() for a system whose rods stand in this order already, and whose links say so.
void finishOrdered(System& system, RodOrder order);

// Whoever changes a finished system in place, and is its only owner, says so with these, and with
// listForces() (forces/forces.h).
void listTearable(System& system);                  // after a tear rule
void touch(System& system, const Touched& changed); // after these inverse masses and rods
void touchAll(System& system);

} // namespace ripstop
