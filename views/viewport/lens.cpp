#include "viewport/lens.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {

Ray Lens::ray(double x, double y) const
{
    const double right = (2.0 * x / width - 1.0) * width / height;
    const double up = 1.0 - 2.0 * y / height;
    const double half = camera.halfHeight();
    const Vec3 target = camera.focus + half * (right * camera.right() + up * camera.up());
    if (camera.orthographic) {
        // from far behind the eye: an orthographic camera sees what is beside it, too
        const double away = 1e3 * camera.distance;
        return {target + away * camera.back(), -camera.back()};
    }
    return {camera.eye(), (target - camera.eye()).normalized()};
}

std::optional<QPointF> Lens::pixel(const Vec3& place) const
{
    const Eigen::Vector4d p = camera.projection(width / height) * place.homogeneous();
    if (p.w() <= 0.0)
        return std::nullopt;
    return QPointF(0.5 * (p.x() / p.w() + 1.0) * width, 0.5 * (1.0 - p.y() / p.w()) * height);
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
