// Before the first step: how near a design is to what its solver can follow, and what is better
// repaired first.
//
// Four figures are told whatever they are: the substep against the limit of each particle, the
// largest ratio of masses along a rod, the sweeps against the rods that a pull has to pass, and the
// links that are longer at the start than they rest. What is loose, massless or double is told
// where it is found.
#pragma once

#include "check/finding.h"

namespace ripstop {

// The longest a link may be at the start, as a part of its rest length, without being told.
inline constexpr double mostStartStrain = 0.05;

// The largest ratio of the masses at the ends of a rod that sweeps are told to follow well.
inline constexpr double mostMassRatio = 100.0;

// Warnings, and figures that are fine, each with its subject. Warnings come first.
std::vector<Finding> stabilityOf(const Scene& scene);

// How many links a pull has to pass to cross the largest piece of the network: exact for chains and
// trees, a lower bound for others. 0 without links.
int networkLength(const Scene& scene);

} // namespace ripstop
