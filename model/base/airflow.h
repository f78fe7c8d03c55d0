// Wind that depends on the place: profiles over height, and jets. Heights are above y = 0.
//
//     power law  u(h) = U (h / H)^a             a about 1/7 over open land
//     log law    u(h) = U ln(h / z0) / ln(H / z0), 0 below z0   z0: sea 0.0002 m, grass 0.03,
//                                               farmland 0.1, suburbs 0.5 to 1
//     jet        u = U R / r (1 - d^2 / r^2)^2, r = R + s tan(spread)
//
// U is the velocity at the reference height H. A jet leaves a nozzle of radius R; s is the distance
// along its axis and d that from it; where it spreads it slows down such that its flux of momentum
// stays the same (Schlichting 1933). Behind the nozzle and beyond r there is no jet.
#pragma once

#include "base/vec3.h"
#include "base/wind_kind.h"

namespace ripstop {

struct Airflow
{
    WindKind kind = WindKind::Uniform;
    Vec3 velocity = Vec3::Zero();  // m/s, everywhere, at the reference height or in the nozzle
    double referenceHeight = 10.0; // m
    double exponent = 1.0 / 7.0;   // 1, power law
    double roughness = 0.03;       // m, z0 of the log law
    Vec3 origin = Vec3::Zero();    // m, middle of the nozzle
    double radius = 0.5;           // m, of the nozzle
    double widening = 0.2;         // 1, tangent of half the angle of the jet

    friend bool operator==(const Airflow&, const Airflow&) = default;
};

// Velocity of the air at a place, m/s. It is zero for gusts, which are the same everywhere and
// depend on time (forces/gusts.h, forces/discrete_gust.h). Pure: any thread may call it.
Vec3 velocityAt(const Airflow& flow, const Vec3& place);

} // namespace ripstop
