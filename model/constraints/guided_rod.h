// Rods that end at a particle on a guide (laws/guide.h).
//
// The rod pulls along its direction n, and the guide lets its particle follow along P n only. So
// the ends come nearer by c = (w_a P_a + w_b P_b) n per multiplier, and XPBD's weight is n c
// instead of w_a + w_b. Where a rod stands nearly across its guide, the straight way of XPBD would
// fling the particle along the guide; the step taken is the one after which the length itself is
// what the straight way would make it, |d - s c|, a quadratic equation for s. Free particles obey
// it too, with s as XPBD has it.
#pragma once

#include "system/system.h"

namespace ripstop {

struct GuidedRod
{
    int a = 0; // particle indices
    int b = 0;
    double inverseMassA = 0.0; // 1/kg, 0 when pinned
    double inverseMassB = 0.0;
    GuidedParticle guideA;
    GuidedParticle guideB;
    double rest = 0.0;     // m
    double softness = 0.0; // 1/kg, compliance / h^2
    double lowest = 0.0;   // kg m, range of the multiplier
    double highest = 0.0;  // kg m
    bool torn = false;
    double multiplier = 0.0; // kg m, of this substep
    double sum = 0.0;        // kg m, over the substeps that are noted
};

// Projects the rod once: moves its ends and adds to its multiplier.
//   position  [particles]  m
void project(GuidedRod& rod, PaddedVec3* position);

struct GuidedPull
{
    Vec3 separation;    // m, from a to b
    Vec3 perMultiplier; // 1/kg, c above
    double rest;        // m
    double softness;    // 1/kg
    double lowest;      // kg m
    double highest;     // kg m
};

// The multiplier after one projection, kg m; it stays what it was when the rod can move nothing.
double multiplierAfter(const GuidedPull& pull, double multiplier);

} // namespace ripstop
