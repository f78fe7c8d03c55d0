#include "viewport/projection.h"

#include <Eigen/Geometry>

namespace ripstop {

Projection::Projection(const Sight& sight)
    : m_camera(sight.camera)
    , m_eye(sight.camera.eye())
    , m_right(sight.camera.right())
    , m_up(sight.camera.up())
    , m_back(sight.camera.back())
    , m_width(sight.width)
    , m_height(sight.height)
    , m_scale(0.5 * sight.height / sight.camera.halfHeight()
              * (sight.camera.orthographic ? 1.0 : sight.camera.distance))
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
