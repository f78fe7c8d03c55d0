#include "scene/wind.h"

#include <cmath>
#include <numbers>

namespace ripstop {

Airflow airflowOf(const Wind& wind)
{
    return {wind.kind,
            wind.velocity,
            wind.referenceHeight,
            wind.exponent,
            wind.roughness,
            wind.position,
            wind.radius,
            std::tan(wind.spread * std::numbers::pi / 180.0)};
}

Vec3 meanWindAt(const Scene& scene, const Vec3& place)
{
    Vec3 sum = Vec3::Zero();
    for (const Entry& entry : scene.items)
        if (const Wind* wind = std::get_if<Wind>(&entry.item))
            sum += velocityAt(airflowOf(*wind), place);
    return sum;
}

} // namespace ripstop
