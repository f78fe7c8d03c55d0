#include "derived/cloth_area.h"

#include "scene/particle_of.h"

#include "derived/flat_panel.h"
#include "scene/property.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

ClothArea::ClothArea(const Part& part, const Scene* scene)
    : m_part(part)
    , m_scene(scene)
{
    if (part.carrier == FabricKind::Panels)
        return;
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

std::optional<double> ClothArea::byLinks(const Panel& panel) const
{
    const auto a = lengthOf(panel.a, panel.b), b = lengthOf(panel.b, panel.c),
               c = lengthOf(panel.c, panel.a);
    if (!a || !b || !c)
        return std::nullopt;
    const double s = 0.5 * (*a + *b + *c); // Heron
    const double square = s * (s - *a) * (s - *b) * (s - *c);
    return square > 0.0 ? std::optional(std::sqrt(square)) : std::nullopt;
}

const Particle* ClothArea::at(Id particle) const
{
    if (const Particle* const own = findRow(m_part.particles, particle); own || !m_scene)
        return own;
    return particleOf(*m_scene, particle);
}

double ClothArea::of(const Panel& panel) const
{
    if (const auto area = byLinks(panel))
        return *area;
    const Particle* const a = at(panel.a);
    const Particle* const b = at(panel.b);
    const Particle* const c = at(panel.c);
    if (!a || !b || !c)
        return 0.0;
    return cutArea(panel, a->position, b->position, c->position);
}

double ClothArea::whole() const
{
    double area = 0.0;
    for (const Panel& panel : m_part.panels)
        area += of(panel);
    return area;
}

} // namespace ripstop
