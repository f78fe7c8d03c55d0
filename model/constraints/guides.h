// Keeps particles on their guides (laws/guide.h).
//
// Forces across a guide are dropped before particles are integrated, rods move what is on one along
// it only, and what a substep did across it in any other way - rounding, a push of fabric - is
// taken back at its end. All of this goes over System::guided, a short list, and touches nothing
// else.
#pragma once

#include "system/system.h"

#include <span>

namespace ripstop {

// The guide of a particle; null when it has none.
const GuidedParticle* guideOf(const System& system, int particle);

// Gives particles these guides; Guide::None takes a guide away. `guides` may stand in any order,
// and name each particle once. For the single owner of a system, and not beside a step.
void setGuides(System& system, std::vector<GuidedParticle> guides);

// Takes what leads across a guide out of accelerations or the like.
//   vector  [particles]
void dropAcrossGuides(const System& system, std::span<PaddedVec3> vector);

// The same for matrices that give forces for motions, on either side.
//   matrix  [particles]
void dropAcrossGuides(const System& system, std::span<Mat3> matrix);

// Takes back what a substep has moved particles across their guides, and what is left of velocities
// there.
//   before  [particles]  m, at the start of the substep
void keepOnGuides(const System& system, std::span<const PaddedVec3> before, State& state);

// Turns the motion of one particle along its guide, as when it has just got it.
void turnAlong(const GuidedParticle& guided, State& state);

} // namespace ripstop
