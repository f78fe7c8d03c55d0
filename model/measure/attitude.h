// How something stands in the air, by three of its particles: the nose (the probe's target), the
// tail (`from`) and one on the right (`side`). All angles in degrees; not a number when a particle
// is missing.
#pragma once

#include "measure/probe.h"

namespace ripstop {

double pitch(const ProbeSpec& probe, Readings& readings);   // -90 to 90, nose above tail
double heading(const ProbeSpec& probe, Readings& readings); // -180 to 180, from +x towards +z
double roll(const ProbeSpec& probe, Readings& readings);    // -180 to 180, right side down

// -180 to 180: the wind comes from below the chord. In the plane across the span.
double angleOfAttack(const ProbeSpec& probe, Readings& readings);

} // namespace ripstop
