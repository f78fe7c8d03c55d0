// Panels are laid out flat by the lengths of their sides, as the cloth was cut. Sides and the links
// across them are looked up by their pairs of particles.
#include "derived/lattice_stiffness.h"

#include "derived/cloth_area.h"
#include "derived/link_stiffness.h"
#include "derived/panel_fabric.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <unordered_map>

namespace ripstop {
namespace {

using Point = std::complex<double>;

std::uint64_t pairOf(Id a, Id b) // the same whichever comes first
{
    const auto [low, high] = std::minmax({std::uint32_t(a), std::uint32_t(b)});
    return (std::uint64_t(high) << 32) | low;
}

struct Beside // a side
{
    int panels = 0;
    std::array<Id, 2> opposite{}; // the corners of the first two that are not on it
};

class Threads
{
public:
    Threads(const Part& part, const std::map<Id, const Material*>& materials)
        : m_part(part)
        , m_materials(materials)
        , m_cut(part)
    {
        m_links.reserve(part.links.size());
        m_beside.reserve(2 * part.panels.size());
        for (const Link& link : part.links)
            if (isOfFabric(link))
                m_links.emplace(pairOf(link.from, link.to), &link);
        for (const Panel& panel : part.panels)
            for (const auto& [a, b, c] : turns(panel)) {
                Beside& beside = m_beside[pairOf(a, b)];
                if (beside.panels < 2)
                    beside.opposite[std::size_t(beside.panels)] = c;
                ++beside.panels;
            }
    }

    std::map<Id, LatticeStiffness> means() const
    {
        std::map<Id, LatticeStiffness> sums;
        std::map<Id, double> areas;
        for (const Panel& panel : m_part.panels) {
            const double area = m_cut.of(panel);
            const Id material = materialOf(panel);
            const auto stiffness =
                area > 0.0 && material != noId ? stiffnessOf(panel, area) : std::nullopt;
            if (!stiffness)
                continue;
            areas[material] += area;
            sums[material].along += area * stiffness->along;
            sums[material].shear += area * stiffness->shear;
        }
        for (auto& [material, sum] : sums) {
            sum.along /= areas.at(material);
            sum.shear /= areas.at(material);
        }
        return sums;
    }

private:
    using Turn = std::array<Id, 3>; // a side, and the corner that is not on it
    static std::array<Turn, 3> turns(const Panel& p)
    {
        return {{{p.a, p.b, p.c}, {p.b, p.c, p.a}, {p.c, p.a, p.b}}};
    }

    const Link* linkOn(Id a, Id b) const
    {
        const auto found = m_links.find(pairOf(a, b));
        return found == m_links.end() ? nullptr : found->second;
    }

    // Of the first thread along a side; noId where none is of a known stiffness.
    Id materialOf(const Panel& panel) const
    {
        for (const auto& [a, b, c] : turns(panel))
            if (const Link* link = linkOn(a, b); link && link->role == LinkRole::Thread)
                if (const auto known = m_materials.find(link->material);
                    known != m_materials.end() && known->second->membraneStiffness)
                    return link->material;
        return noId;
    }

    double length(Id a, Id b) const // not a number where one is of no particle of the part
    {
        if (const auto cut = m_cut.lengthOf(a, b))
            return *cut;
        const Particle* const from = findRow(m_part.particles, a);
        const Particle* const to = findRow(m_part.particles, b);
        return from && to ? (to->position - from->position).norm()
                          : std::numeric_limits<double>::quiet_NaN();
    }

    // Where the third corner of a triangle lies to the left of the side from 0 to `side`.
    static Point third(double side, double fromStart, double fromEnd)
    {
        const double x = (side * side + fromStart * fromStart - fromEnd * fromEnd) / (2.0 * side);
        return {x, std::sqrt(std::max(0.0, fromStart * fromStart - x * x))};
    }

    // N m, k L^2; nothing of a link with a stiffness of its own, or with none that is finite.
    std::optional<double> pullOf(const Link& link) const
    {
        const auto known = m_materials.find(link.material);
        if (known == m_materials.end() || link.compliance || link.stiffness)
            return std::nullopt;
        const Material& material = *known->second;
        const double k = link.kind == LinkKind::Rod ? 1.0 / rodCompliance(material, link)
                                                    : springStiffness(material, link);
        const double pull = k * link.restLength * link.restLength;
        return std::isfinite(pull) ? std::optional(pull) : std::nullopt;
    }

    // Calls visit(link, its direction in the plane of the panel, panels that share it).
    template <typename Visit>
    void forEachLink(const Panel& panel, Visit visit) const
    {
        const double ab = length(panel.a, panel.b);
        const std::array<Point, 3> corner{
            Point(0.0), Point(ab), third(ab, length(panel.a, panel.c), length(panel.b, panel.c))};
        const std::array<Turn, 3> sides = turns(panel);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& [a, b, c] = sides[i];
            const Point way = corner[(i + 1) % 3] - corner[i];
            const Beside& beside = m_beside.at(pairOf(a, b));
            if (const Link* along = linkOn(a, b))
                visit(*along, way, double(beside.panels));
            if (beside.panels != 2)
                continue;
            const Id beyond = beside.opposite[beside.opposite[0] == c ? 1 : 0];
            const Link* across = linkOn(c, beyond);
            if (!across || m_beside.contains(pairOf(c, beyond)))
                continue;
            // the panel behind the side, unfolded to its right
            const Point there =
                std::conj(third(std::abs(way), length(a, beyond), length(b, beyond)));
            const Point direction = way / std::abs(way);
            visit(*across, corner[i] + direction * there - corner[(i + 2) % 3], 2.0);
        }
    }

    std::optional<LatticeStiffness> stiffnessOf(const Panel& panel, double area) const
    {
        double weight = 0.0; // N/m, sum W
        Point second = 0.0;  // N/m, sum W exp(2 i a)
        Point fourth = 0.0;  // N/m, sum W exp(4 i a)
        bool isKnown = true;
        forEachLink(panel, [&](const Link& link, const Point& way, double panels) {
            const std::optional<double> pull = pullOf(link);
            isKnown = isKnown && pull;
            const double w = pull.value_or(0.0) / (panels * area);
            const Point turn = way / std::abs(way);
            weight += w;
            second += w * turn * turn;
            fourth += w * std::pow(turn, 4);
        });
        if (!isKnown || !(weight > 0.0))
            return std::nullopt;
        // cos^4 = (3 + 4 cos 2x + cos 4x) / 8, sin^4 = (3 - 4 cos 2x + cos 4x) / 8
        const double most = std::abs(fourth);
        const Point half = std::polar(1.0, -0.5 * std::arg(fourth)); // exp(-2 i t)
        const double twice = (second * half).real();
        const double c11 = (3.0 * weight + 4.0 * twice + most) / 8.0;
        const double c22 = (3.0 * weight - 4.0 * twice + most) / 8.0;
        const double shear = (weight - most) / 8.0;
        if (!(c11 > 0.0 && c22 > 0.0))
            return std::nullopt;
        const double along = c11 - shear * shear / c22, across = c22 - shear * shear / c11;
        return LatticeStiffness{0.5 * (along + across), shear};
    }

    const Part& m_part;
    const std::map<Id, const Material*>& m_materials;
    ClothArea m_cut;
    std::unordered_map<std::uint64_t, const Link*> m_links; // of fabric
    std::unordered_map<std::uint64_t, Beside> m_beside;     // sides of panels
};

} // namespace

std::map<Id, LatticeStiffness> latticeStiffness(const Part& part,
                                                const std::map<Id, const Material*>& materials)
{
    if (materials.empty())
        return {};
    return Threads(part, materials).means();
}

} // namespace ripstop
