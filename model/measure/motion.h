// What probes read of particles and links together, in SI units. What has nothing to read from is
// not a number.
#pragma once

#include "measure/probe.h"

namespace ripstop {

// Mean over the particles of the probe, weighted by mass; the plain mean when nothing has mass, not
// a number when there are none.
//   values  [particles]
Vec3 meanOf(const ProbeSpec& probe, const System& system, const std::vector<PaddedVec3>& values);

// Of the centre of mass, m/s^2: the change of its velocity over the last time step. Not a number
// before the first.
Vec3 acceleration(const ProbeSpec& probe, Readings& readings);

Vec3 momentumOf(const ProbeSpec& probe, Readings& readings); // kg m/s, of what can move

// N, on the pinned particles of the probe: what links pull, air presses and weight draws there is
// held by the opposite of it.
Vec3 reaction(const ProbeSpec& probe, Readings& readings);

// 1, of the links of the probe that have not torn. The high one is the 95th percentile, by nearest
// rank.
double meanStrain(const ProbeSpec& probe, Readings& readings);
double highStrain(const ProbeSpec& probe, Readings& readings);

double lengthOf(const ProbeSpec& probe, Readings& readings); // m, of the links that have not torn
double areaOf(const ProbeSpec& probe, Readings& readings);   // m^2, of the panels that are not gone

} // namespace ripstop
