// The air force on what a probe looks at, split into lift and drag as fliers do, in SI units.
// Without wind there is no direction to split by, and both are not a number.
#pragma once

#include "measure/probe.h"

namespace ripstop {

// m/s, the air over the ground, at the same place as the relative wind.
Vec3 windOver(const ProbeSpec& probe, Readings& readings);

// m/s, the air as it passes the centre of mass of the probe's particles, or of the corners of its
// panels where it has no particles.
Vec3 relativeWind(const ProbeSpec& probe, Readings& readings);

// N. Drag is along the relative wind, lift across it in the vertical plane of it, positive upwards.
struct LiftAndDrag
{
    double lift;
    double drag;
};
LiftAndDrag liftAndDrag(const ProbeSpec& probe, Readings& readings);

// m: the mean of the middles of the panels, each by the part of its load that is along the whole.
Vec3 centreOfPressure(const ProbeSpec& probe, Readings& readings);

} // namespace ripstop
