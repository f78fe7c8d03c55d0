// The wind of a system: what is the same everywhere, and what depends on the place.
//
// Uniform winds and gusts are found once for all places; profiles over height, jets and the fan in
// a hand (base/airflow.h) are asked for at each place, and only where hasLocalWind() says that
// there are any. All of them add up. The functions change nothing, so threads share them in a step.
#pragma once

#include "system/system.h"

namespace ripstop {

Vec3 commonWind(const System& system, const State& state); // m/s, uniform wind and gusts
Vec3 localWind(const System& system, const Vec3& place);   // m/s, profiles and jets
bool hasLocalWind(const System& system, const State& state);
Vec3 localWind(const System& system, const State& state,
               const Vec3& place); // m/s, with the fan in a hand
Vec3 windAt(const System& system, const State& state, const Vec3& place); // m/s, all of it

} // namespace ripstop
