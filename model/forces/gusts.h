// Gusts after Dryden, by the low-altitude model of MIL-F-8785C (1980), 10 to 1000 ft.
//
// Turbulence is taken as frozen and carried past by the mean wind V (Taylor's hypothesis): in a
// time step dt a distance s = V dt of it goes by. A gust is the same everywhere in space, which is
// right for things much smaller than the lengths L, some 70 m and more. With h the height in feet
// and W the wind 20 ft above the ground:
//
//     up              L = h                              sigma = 0.1 W
//     along, across   L = h / (0.177 + 0.000823 h)^1.2   sigma = 0.1 W / (0.177 + 0.000823 h)^0.4
//
// W = 15, 30, 45 kt (7.7, 15.4, 23.2 m/s) are light, moderate and severe turbulence. (MIL-HDBK-1797
// halves the transverse lengths together with another formula; the two do not mix.)
//
// The generator is exact for steps of any length, so that the step changes no statistics. Along the
// wind x' = r x + sqrt(1 - r^2) n, r = exp(-s / L), with autocorrelation exp(-x / L). Across it and
// up, two states obey dx1 = (-x1 + eta) / L, dx2 = (x1 - x2) / L with covariance [[1, 1/2], [1/2,
// 1/2]], and y = (sqrt 3 x1 + (1 - sqrt 3) x2) / sqrt 2 has exp(-x / L) (1 - x / 2L).
//
// The noise n is a hash of seed and step: the same seed gives the same gusts, bit for bit.
#pragma once

#include "system/system.h"

namespace ripstop {

// `mean` carries the gusts past (m/s; its level part counts, and at least 1 m/s of it), `height` is
// that over the ground (m, held between 10 and 1000 ft), `windAt20Feet` is W (m/s).
GustSpec drydenGusts(Key key, const Vec3& mean, double height, double windAt20Feet, int seed);

// States as likely as any: the run begins in the midst of turbulence.
GustState firstGust(const GustSpec& gusts);

void advanceGust(const GustSpec& gusts, double timeStep, std::int64_t step, GustState& state);
void startGusts(System& system);                       // after another seed
void advanceGusts(const System& system, State& state); // by a time step

Vec3 velocityOf(const GustSpec& gusts, const GustState& state); // m/s

} // namespace ripstop
