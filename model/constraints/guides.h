// Keeps particles on their guides (base/guide.h).
//
// Forces across a guide are dropped before particles are integrated, rods move what is on one along
// it only, and what a substep did across it in any other way - rounding, a push of fabric - is
// taken back at its end. All of this goes over System::guided, a short list, and touches nothing
// else.
#pragma once

#include "system/system.h"

#include <span>

namespace ripstop {

// Null when the particle has no guide.
const GuidedParticle* guideOf(const System& system, int particle);

// Gives particles these guides; Guide::None takes them away. In any order, each particle once.
void setGuides(System& system, std::vector<GuidedParticle> guides);

//   vector  [particles]
void dropAcrossGuides(const System& system, std::span<PaddedVec3> vector);

//   before  [particles]  m, at the start of the substep
void keepOnGuides(const System& system, std::span<const PaddedVec3> before, State& state);

// The motion of one particle, when it has just got its guide.
void turnAlong(const GuidedParticle& guided, State& state);

} // namespace ripstop
