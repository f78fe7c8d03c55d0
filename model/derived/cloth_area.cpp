#include "derived/cloth_area.h"

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
    std::ranges::stable_sort(m_lengths, {}, &std::pair<Side, double>::first);
}

std::optional<double> ClothArea::lengthOf(Id a, Id b) const
{
    const Side side = std::minmax(a, b);
    const auto found =
        std::ranges::lower_bound(m_lengths, side, {}, &std::pair<Side, double>::first);
    return found != m_lengths.end() && found->first == side ? std::optional(found->second)
                                                            : std::nullopt;
}

double ClothArea::of(const std::array<Id, 3>& corner) const
{
    const auto a = lengthOf(corner[0], corner[1]), b = lengthOf(corner[1], corner[2]),
               c = lengthOf(corner[2], corner[0]);
    if (a && b && c) {
        const double s = 0.5 * (*a + *b + *c); // Heron
        const double square = s * (s - *a) * (s - *b) * (s - *c);
        if (square > 0.0)
            return std::sqrt(square);
    }
    std::array<const Particle*, 3> at{};
    for (std::size_t k = 0; k < 3; ++k)
        if (at[k] = findRow(m_part.particles, corner[k]); !at[k])
            return 0.0;
    return 0.5
           * (at[1]->position - at[0]->position).cross(at[2]->position - at[0]->position).norm();
}

double ClothArea::whole() const
{
    double area = 0.0;
    for (const Panel& panel : m_part.panels)
        area += of({panel.a, panel.b, panel.c});
    return area;
}

} // namespace ripstop
