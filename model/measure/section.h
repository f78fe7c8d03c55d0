// The section of a sail: where the plane through a chord and across the fabric cuts its panels.
//
// The chord goes from the nose, which is the target of the probe, to the tail, its `from`. The
// plane has in it the chord and the mean normal of the panels of the part that the nose is of. What
// of the cut lies between nose and tail is how the sail is arched there.
#pragma once

#include "measure/probe.h"

namespace ripstop {

struct Camber // shares of the chord; not numbers where no panel is cut
{
    double height;   // of what is farthest from the chord, on either side of it
    double position; // of that, from the nose
};

Camber camberOf(const ProbeSpec& probe, Readings& readings);

} // namespace ripstop
