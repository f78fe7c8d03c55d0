// The winds of a scene.
#pragma once

#include "base/airflow.h"
#include "scene/scene.h"

namespace ripstop {

Airflow airflowOf(const Wind& wind);

// m/s at a place, all winds of the scene but gusts, which depend on time.
Vec3 meanWindAt(const Scene& scene, const Vec3& place);

} // namespace ripstop
