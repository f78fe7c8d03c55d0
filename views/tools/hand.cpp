#include "tools/hand.h"

#include <Eigen/Dense>

#include <algorithm>

namespace ripstop {

Hand::Hand(const Scene& scene, Id id, const Vec3& place)
    : m_place(place)
{
    for (const Entry& entry : scene.items) {
        const Control* control = std::get_if<Control>(&entry.item);
        if (!control || control->axis.norm() == 0.0
            || std::find(control->targets.begin(), control->targets.end(), id)
                   == control->targets.end())
            continue;
        m_controls.push_back(entry.id);
        m_axes.push_back(control->axis.normalized());
    }
}

std::vector<double> Hand::pull(const Camera& camera, double pictureHeight, double dx,
                               double dy) const
{
    const double depth = camera.orthographic
                             ? camera.distance
                             : std::max((camera.eye() - m_place).dot(camera.back()), 1e-9);
    const double perPixel = 2.0 * camera.halfHeight() * depth / camera.distance / pictureHeight;
    const Eigen::Vector2d way(dx * perPixel, -dy * perPixel); // m, in the picture
    Eigen::Matrix2Xd axes(2, Eigen::Index(m_axes.size()));
    for (std::size_t i = 0; i < m_axes.size(); ++i)
        axes.col(Eigen::Index(i)) << m_axes[i].dot(camera.right()), m_axes[i].dot(camera.up());
    // The damping lets go of axes that are hardly seen from the side.
    constexpr double damping = 1e-3;
    const Eigen::Matrix2d square = axes * axes.transpose() + damping * Eigen::Matrix2d::Identity();
    const Eigen::VectorXd values = axes.transpose() * square.inverse() * way;
    return {values.begin(), values.end()};
}

} // namespace ripstop
