#include "viewport/lens.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {

Projection::Ray Lens::ray(QPointF place) const
{
    return Projection(camera, width, height).rayAt(place.x(), place.y());
}

std::optional<QPointF> Lens::pixel(const Vec3& place) const
{
    const OnScreen seen = Projection(camera, width, height)(place);
    return seen.isSeen() ? std::optional(QPointF(seen.x, seen.y)) : std::nullopt;
}

double Lens::metresPerPixel(const Vec3& place) const
{
    const double depth = (camera.eye() - place).dot(camera.back());
    const double ratio = camera.orthographic ? 1.0 : std::max(depth, 0.0) / camera.distance;
    return ratio * 2.0 * camera.halfHeight() / std::max(height, 1.0);
}

Vec3 Lens::towardsEye(const Vec3& place) const
{
    return camera.orthographic ? camera.back() : Vec3((camera.eye() - place).normalized());
}

} // namespace ripstop
