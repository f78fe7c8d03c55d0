// The winds of a scene as base/airflow.h takes them: angles become slopes, and the winds add up.
// Compiling makes the airflows of a system here, and the views ask for the mean wind to draw it in
// a scene that does not run.
#pragma once

#include "base/airflow.h"
#include "scene/scene.h"

namespace ripstop {

// Of a measured wind its mean, which is the same everywhere.
Airflow airflowOf(const Wind& wind);

// m/s, over the time of the record; of a record of one row that one.
//   rows  s, m/s along x, y, z, as Wind::velocities has them
Vec3 meanVelocity(const NumberRows& rows);

// Those of all winds, of gusts such as blow nowhere, for whoever asks for many places: the mean of
// a long record takes as long as it is.
std::vector<Airflow> airflowsOf(const Scene& scene);
Vec3 velocityAt(const std::vector<Airflow>& flows, const Vec3& place); // m/s, their sum

// m/s at a place, m: the sum of all winds of the scene but gusts, which depend on time.
Vec3 meanWindAt(const Scene& scene, const Vec3& place);

} // namespace ripstop
