#pragma once

#include <Eigen/Core>

namespace ripstop {

// A point, a displacement or a force; y is up. 24 bytes without padding, so that the viewport can
// show an array of them in place.
using Vec3 = Eigen::Vector3d;

static_assert(sizeof(Vec3) == 3 * sizeof(double));

} // namespace ripstop
