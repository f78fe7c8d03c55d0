#include "viewport/projection.h"

#include <Eigen/Geometry>

namespace ripstop {

Projection::Projection(const Sight& sight)
    : Projection(sight.camera, sight.width, sight.height)
{}

Projection::Projection(const Turntable& camera, double width, double height)
    : m_camera(camera)
    , m_eye(camera.eye())
    , m_right(camera.right())
    , m_up(camera.up())
    , m_back(camera.back())
    , m_width(width)
    , m_height(height)
    , m_scale(0.5 * height / camera.halfHeight() * (camera.orthographic ? 1.0 : camera.distance))
{}

OnScreen Projection::operator()(const Vec3& place) const
{
    const Vec3 away = place - m_eye;
    const double depth = -away.dot(m_back);
    if (!m_camera.orthographic && !(depth > 0.0))
        return {0.0, 0.0, std::numeric_limits<double>::infinity()};
    const double scale = m_camera.orthographic ? m_scale : m_scale / depth;
    return {0.5 * m_width + scale * away.dot(m_right), 0.5 * m_height - scale * away.dot(m_up),
            depth};
}

Projection::Ray Projection::rayThrough(const Vec3& place) const
{
    if (!m_camera.orthographic)
        return {m_eye, (place - m_eye).normalized()};
    // from far behind the eye: a view without perspective sees what is beside it, too
    return {place + 1e3 * m_camera.distance * m_back, -m_back};
}

Projection::Ray Projection::rayAt(double x, double y) const
{
    const double perPixel = 2.0 * m_camera.halfHeight() / m_height; // m, at the focus
    return rayThrough(m_camera.focus
                      + perPixel * ((x - 0.5 * m_width) * m_right + (0.5 * m_height - y) * m_up));
}

} // namespace ripstop
