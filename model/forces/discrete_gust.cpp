#include "forces/discrete_gust.h"

#include "base/portable_math.h"
#include "laws/gust_train.h"

#include <algorithm>
#include <numbers>

namespace ripstop {

Vec3 velocityOf(const DiscreteGust& gust, double time)
{
    const std::optional<GustMoment> now = gustAt(gust, time);
    if (!now)
        return Vec3::Zero();
    // (1 - cos 2x) / 2 = sin^2 x, and a gust falls as it has grown.
    const double half = std::min(now->since, gust.duration - now->since) / gust.duration;
    const double sine = portableSine(std::numbers::pi * std::max(0.0, half));
    return now->strength * sine * sine * gust.velocity;
}

} // namespace ripstop
