#include "camera/camera_projection.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {

CameraProjection::CameraProjection(const CameraView& view)
    : CameraProjection(view.camera, view.width, view.height)
{}

CameraProjection::CameraProjection(const Camera& camera, double width, double height)
    : m_camera(camera)
    , m_eye(camera.eye())
    , m_right(camera.right())
    , m_up(camera.up())
    , m_back(camera.back())
    , m_width(width)
    , m_height(height)
    , m_scale(0.5 * height / camera.halfHeight() * (camera.orthographic ? 1.0 : camera.distance))
{}

OnScreen CameraProjection::operator()(const Vec3& place) const
{
    const Vec3 away = place - m_eye;
    const double depth = -away.dot(m_back);
    if (!m_camera.orthographic && !(depth > 0.0))
        return {0.0, 0.0, std::numeric_limits<double>::infinity()};
    const double scale = m_camera.orthographic ? m_scale : m_scale / depth;
    return {0.5 * m_width + scale * away.dot(m_right), 0.5 * m_height - scale * away.dot(m_up),
            depth};
}

CameraProjection::Ray CameraProjection::rayThrough(const Vec3& place) const
{
    if (!m_camera.orthographic)
        return {m_eye, (place - m_eye).normalized()};
    // The ray starts far behind the eye, as a view without perspective sees what is beside it, too.
    return {place + 1e3 * m_camera.distance * m_back, -m_back};
}

CameraProjection::Ray CameraProjection::rayAt(double x, double y) const
{
    const double perPixel = 2.0 * m_camera.halfHeight() / m_height; // m, at the focus
    return rayThrough(m_camera.focus
                      + perPixel * ((x - 0.5 * m_width) * m_right + (0.5 * m_height - y) * m_up));
}

std::optional<QPointF> CameraProjection::pixel(const Vec3& place) const
{
    const OnScreen seen = (*this)(place);
    return seen.isSeen() ? std::optional(QPointF(seen.x, seen.y)) : std::nullopt;
}

double CameraProjection::metresPerPixel(const Vec3& place) const
{
    const double depth = (m_eye - place).dot(m_back);
    const double ratio = m_camera.orthographic ? 1.0 : std::max(depth, 0.0) / m_camera.distance;
    return ratio * 2.0 * m_camera.halfHeight() / std::max(m_height, 1.0);
}

Vec3 CameraProjection::towardsEye(const Vec3& place) const
{
    return m_camera.orthographic ? m_back : Vec3((m_eye - place).normalized());
}

} // namespace ripstop
