#include "layers/wind_layer.h"

#include "look/steady_range.h"
#include "scene/wind.h"

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <cmath>

namespace ripstop {
namespace {

constexpr int arrowsAcross = 2;       // to either side of the middle
constexpr double longestArrow = 0.85; // of the step between arrows

// Step of the grid, m, for the size of what is shown.
double stepOf(const Eigen::AlignedBox3d& bounds)
{
    const double size = bounds.isEmpty() ? 1.0 : std::max(bounds.diagonal().norm(), 0.2);
    return roundedUp(0.35 * size);
}

} // namespace

std::vector<WindArrow> windField(const Scene& scene, const Vec3& gust,
                                 const Eigen::AlignedBox3d& bounds)
{
    const double step = stepOf(bounds);
    const Vec3 middle = bounds.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(bounds.center());
    const auto nearest = [&](int axis) { return std::round(middle[axis] / step); };
    const std::vector<Airflow> flows = airflowsOf(scene);
    std::vector<WindArrow> arrows;
    for (int i = -arrowsAcross; i <= arrowsAcross; ++i)
        for (int j = -arrowsAcross; j <= arrowsAcross; ++j)
            for (int k = -arrowsAcross; k <= arrowsAcross; ++k) {
                const Vec3 place =
                    step * Vec3(nearest(0) + i, nearest(1) + j + 0.5, nearest(2) + k);
                const Vec3 velocity = velocityAt(flows, place) + gust;
                if (place.y() > 0.0 && velocity.norm() > 1e-3)
                    arrows.push_back({place, velocity});
            }
    return arrows;
}

WindLayer::WindLayer() { m_arrows.actor().SetVisibility(false); }

void WindLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(&m_arrows.actor()); }

void WindLayer::setShown(bool shown)
{
    m_shown = shown;
    m_arrows.actor().SetVisibility(shown);
}

void WindLayer::rebuild(const Picture& picture)
{
    m_arrows.style(picture.theme.wind, picture.pixelRatio);
}

void WindLayer::update(const Picture& picture)
{
    if (!m_shown)
        return;
    const auto arrows = windField(picture.scene, picture.frame.gust, picture.bounds);
    double fastest = 0.0;
    for (const WindArrow& arrow : arrows)
        fastest = std::max(fastest, arrow.velocity.norm());
    const double scale = longestArrow * stepOf(picture.bounds) / fastest;
    m_arrows.clear();
    for (const WindArrow& arrow : arrows)
        m_arrows.add(arrow.place - 0.5 * scale * arrow.velocity, scale * arrow.velocity);
    m_arrows.finish();
}

} // namespace ripstop
