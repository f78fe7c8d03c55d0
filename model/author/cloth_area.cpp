#include "author/cloth_area.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ripstop {

ClothArea::ClothArea(const Part& part)
    : m_part(part)
{
    m_lengths.reserve(part.links.size());
    for (const Link& link : part.links)
        m_lengths.push_back({std::minmax(link.from, link.to), link.restLength});
    std::ranges::sort(m_lengths);
}

double ClothArea::lengthOf(Id a, Id b) const
{
    const Side side = std::minmax(a, b);
    const auto found =
        std::ranges::lower_bound(m_lengths, side, {}, &std::pair<Side, double>::first);
    return found != m_lengths.end() && found->first == side ? found->second : 0.0;
}

double ClothArea::of(const Panel& panel) const
{
    const double a = lengthOf(panel.b, panel.c), b = lengthOf(panel.c, panel.a),
                 c = lengthOf(panel.a, panel.b);
    // Heron; not positive when a side has no link or the sides make no triangle
    const double sixteenfold = (a + b + c) * (b + c - a) * (c + a - b) * (a + b - c);
    if (a > 0.0 && b > 0.0 && c > 0.0 && sixteenfold > 0.0)
        return 0.25 * std::sqrt(sixteenfold);

    const Particle* const at = findRow(m_part.particles, panel.a);
    const Particle* const bt = findRow(m_part.particles, panel.b);
    const Particle* const ct = findRow(m_part.particles, panel.c);
    if (!at || !bt || !ct)
        return 0.0;
    return 0.5 * (bt->position - at->position).cross(ct->position - at->position).norm();
}

double ClothArea::whole() const
{
    double area = 0.0;
    for (const Panel& panel : m_part.panels)
        area += of(panel);
    return area;
}

} // namespace ripstop
