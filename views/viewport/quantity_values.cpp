#include "viewport/quantity_values.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace ripstop {
namespace {

void takeLinks(const Frame& frame, const std::vector<double>& source, QuantityValues& values)
{
    constexpr double none = std::numeric_limits<double>::lowest();
    const std::vector<Layout::Link>& links = frame.layout->links;
    values.link.assign(links.size(), 0.0);
    values.particle.assign(frame.position.size(), none);
    for (std::size_t i = 0; i < std::min(links.size(), source.size()); ++i) {
        if (frame.torn[i])
            continue;
        values.link[i] = source[i];
        for (const int end : {links[i].a, links[i].b})
            values.particle[end] = std::max(values.particle[end], source[i]);
    }
    std::ranges::replace(values.particle, none, 0.0);
}

double area(const Frame& frame, const std::array<int, 3>& corners)
{
    const auto& x = frame.position;
    const auto [a, b, c] = corners;
    return 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
}

} // namespace

QuantityValues valuesOf(const Frame& frame, ColorBy colorBy)
{
    QuantityValues values;
    switch (colorBy) {
    case ColorBy::Material:
        break;
    case ColorBy::Strain:
        takeLinks(frame, frame.strain, values);
        break;
    case ColorBy::Tension:
        takeLinks(frame, frame.tension, values);
        break;
    case ColorBy::Speed:
        values.particle.reserve(frame.velocity.size());
        for (const Vec3& velocity : frame.velocity)
            values.particle.push_back(velocity.norm());
        break;
    case ColorBy::PanelLoad: {
        const auto& panels = frame.layout->panelCorners;
        values.panel.assign(panels.size(), 0.0);
        for (std::size_t i = 0; i < std::min(panels.size(), frame.panelLoad.size()); ++i)
            if (const double a = area(frame, panels[i]); a > 0.0 && !frame.gone[i])
                values.panel[i] = frame.panelLoad[i].norm() / a;
        break;
    }
    }
    return values;
}

} // namespace ripstop
