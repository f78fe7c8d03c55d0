#include "base/airflow.h"

#include "base/portable_math.h"

#include <algorithm>

namespace ripstop {
namespace {

Vec3 jetAt(const Airflow& flow, const Vec3& place)
{
    const double speed = flow.velocity.norm();
    if (speed == 0.0)
        return Vec3::Zero();
    const Vec3 from = place - flow.origin;
    const double along = from.dot(flow.velocity) / speed;
    if (along < 0.0)
        return Vec3::Zero();
    const double radius = flow.radius + along * flow.widening;
    const double offAxis = std::max(0.0, from.squaredNorm() - along * along);
    const double inside = 1.0 - offAxis / (radius * radius);
    if (inside <= 0.0)
        return Vec3::Zero();
    return (flow.radius / radius * inside * inside) * flow.velocity;
}

} // namespace

Vec3 velocityAt(const Airflow& flow, const Vec3& place)
{
    const double height = place.y();
    switch (flow.kind) {
    case WindKind::Uniform:
        return flow.velocity;
    case WindKind::PowerLaw:
        if (height <= 0.0)
            return Vec3::Zero();
        return portableExp(flow.exponent * portableLog(height / flow.referenceHeight))
               * flow.velocity;
    case WindKind::LogLaw:
        if (height <= flow.roughness)
            return Vec3::Zero();
        return (portableLog(height / flow.roughness)
                / portableLog(flow.referenceHeight / flow.roughness))
               * flow.velocity;
    case WindKind::Jet:
        return jetAt(flow, place);
    case WindKind::Gusts:
    case WindKind::DiscreteGust:
    case WindKind::Measured:
        break;
    }
    return Vec3::Zero();
}

} // namespace ripstop
