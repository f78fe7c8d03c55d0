// Single gusts of a known size, as airworthiness codes have them (CS-23.333, FAR 25.341): the wind
// grows and falls again by one minus a cosine. With t the time since the gust began, T how long it
// lasts and U its peak,
//
//     u(t) = U / 2 (1 - cos(2 pi t / T)),   0 <= t <= T,
//
// the same everywhere. A train of them begins a gust every P >= T seconds, each stronger by the
// same share r of the first: the peaks are U, (1 + r) U, (1 + 2 r) U, ... The codes give the length
// of a gust as a way, 25 chords of a wing; at the airspeed V that way takes T = 25 c / V.
#pragma once

#include "system/gust_spec.h"

namespace ripstop {

// m/s at a time of the run, s. It has the same bits on every machine. Pure: any thread may call it.
Vec3 velocityOf(const DiscreteGust& gust, double time);

} // namespace ripstop
