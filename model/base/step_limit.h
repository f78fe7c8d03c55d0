#pragma once

#include <cmath>
#include <limits>

namespace ripstop {

// The longest substep, s, at which the springs at a particle are sure to be stable with
// semi-implicit Euler or Verlet. The largest frequency there is at most w^2 = 2 K / m and the
// largest rate of damping c = 2 N / m (Gershgorin), K and N being the sums of stiffness (N/m) and
// damping (N s/m) of the springs; stable is (w h)^2 + 2 c h < 4, so h < (sqrt(c^2 + 4 w^2) - c) /
// w^2, written here in a way that holds for w = 0 too. Without damping that is sqrt(2 m / K).
inline double springStepLimit(double mass, double stiffness, double damping)
{
    const double w2 = 2.0 * stiffness / mass;
    const double c = 2.0 * damping / mass;
    const double sum = c + std::sqrt(c * c + 4.0 * w2);
    return sum > 0.0 ? 4.0 / sum : std::numeric_limits<double>::infinity();
}

} // namespace ripstop
