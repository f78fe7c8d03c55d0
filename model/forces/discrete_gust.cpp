#include "forces/discrete_gust.h"

#include "base/portable_math.h"

#include <algorithm>
#include <numbers>

namespace ripstop {

Vec3 velocityOf(const DiscreteGust& gust, double time)
{
    double since = time - gust.onset; // the gust of the moment began
    if (!(since > 0.0))
        return Vec3::Zero();
    double before = 0.0; // so many gusts
    if (gust.interval > 0.0) {
        before = std::floor(since / gust.interval);
        since -= before * gust.interval;
    }
    if (!(since < gust.duration))
        return Vec3::Zero();
    // (1 - cos 2x) / 2 = sin^2 x, and a gust falls as it has grown.
    const double half = std::min(since, gust.duration - since) / gust.duration;
    const double sine = portableSine(std::numbers::pi * std::max(0.0, half));
    return (1.0 + before * gust.growth) * sine * sine * gust.velocity;
}

} // namespace ripstop
