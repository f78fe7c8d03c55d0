#include "scene/wind.h"

#include <cmath>
#include <numbers>

namespace ripstop {

Airflow airflowOf(const Wind& wind)
{
    if (wind.kind == WindKind::Measured)
        return {WindKind::Uniform, meanVelocity(wind.velocities)};
    return {wind.kind,
            wind.velocity,
            wind.referenceHeight,
            wind.exponent,
            wind.roughness,
            wind.position,
            wind.radius,
            std::tan(wind.spread * std::numbers::pi / 180.0)};
}

Vec3 meanVelocity(const NumberRows& rows)
{
    const auto at = [](const std::vector<double>& row) { return Vec3(row[1], row[2], row[3]); };
    Vec3 way = Vec3::Zero(); // m
    for (std::size_t i = 1; i < rows.size(); ++i)
        way += 0.5 * (rows[i][0] - rows[i - 1][0]) * (at(rows[i - 1]) + at(rows[i]));
    const double time = rows.back()[0] - rows.front()[0];
    return time > 0.0 ? Vec3(way / time) : at(rows.front());
}

std::vector<Airflow> airflowsOf(const Scene& scene)
{
    std::vector<Airflow> flows;
    for (const Entry& entry : scene.items)
        if (const Wind* wind = std::get_if<Wind>(&entry.item))
            flows.push_back(airflowOf(*wind));
    return flows;
}

Vec3 velocityAt(const std::vector<Airflow>& flows, const Vec3& place)
{
    Vec3 sum = Vec3::Zero();
    for (const Airflow& flow : flows)
        sum += velocityAt(flow, place);
    return sum;
}

Vec3 meanWindAt(const Scene& scene, const Vec3& place)
{
    return velocityAt(airflowsOf(scene), place);
}

} // namespace ripstop
