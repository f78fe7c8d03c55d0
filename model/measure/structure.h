// What fabric and spars of a probe carry: pull per width, wrinkles and bending moments. None fails:
// where there is no fabric that carries a pull, or no spar, it is not a number.
//
// Means are by the area at rest, so that they do not depend on how finely a sail is cut. What has
// torn or is gone is left out.
#pragma once

#include "measure/probe.h"

namespace ripstop {

double fabricStress(const ProbeSpec& probe, Readings& readings); // N/m, the largest

// The mean of one number of the panels that carry a pull.
double meanOfPanels(const ProbeSpec& probe, Readings& readings, double PanelPull::*number);

double wrinkledShare(const ProbeSpec& probe, Readings& readings); // 1

double bendingMoment(const ProbeSpec& probe, Readings& readings); // N m, the largest

} // namespace ripstop
