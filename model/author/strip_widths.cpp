// Part by part: Strips notes the links that may become strips and the sides of panels, finds the
// cells, and gives each link its width. A link is a side before it is a diagonal.
#include "author/strip_widths.h"

#include "derived/link_stiffness.h"
#include "derived/panel_fabric.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ripstop {
namespace {

using ParticlePair = std::pair<Id, Id>; // two particles of the mesh, the lower id first

ParticlePair pairOf(Id a, Id b) { return {std::min(a, b), std::max(a, b)}; }

struct StripSide
{
    std::vector<std::size_t> panels; // beside it
    std::vector<Id> opposite;        // the corner of each that is not on the side
};

class Strips
{
public:
    Strips(const Part& part, const std::vector<Id>& materials)
        : m_part(part)
    {
        for (const Link& link : part.links)
            if (std::ranges::count(materials, link.material) > 0 && !isOfFabric(link))
                m_links.emplace(pairOf(link.from, link.to), link.id);
        for (std::size_t i = 0; i < part.panels.size(); ++i) {
            const Panel& panel = part.panels[i];
            addSide(panel.a, panel.b, panel.c, i);
            addSide(panel.b, panel.c, panel.a, i);
            addSide(panel.c, panel.a, panel.b, i);
            m_area.push_back(0.5
                             * (at(panel.b) - at(panel.a)).cross(at(panel.c) - at(panel.a)).norm());
        }
        countTies();
    }

    // Calls set(link, role, width in m) for each link that stands for a strip.
    template <typename Set>
    void forEachStrip(Set set) const
    {
        for (const auto& [tie, side] : m_sides) {
            if (const auto link = m_links.find(tie); link != m_links.end()) {
                if (isDiagonal(tie, side))
                    set(link->second, LinkRole::Bias, cellWidth(tie, side));
                else
                    set(link->second, LinkRole::Thread, areaBeside(side) / length(tie));
            }
            const auto across = linkAcross(tie, side);
            if (across == m_links.end())
                continue;
            const double area = m_area[side.panels[0]] + m_area[side.panels[1]];
            set(across->second, LinkRole::Bias,
                isDiagonal(tie, side) ? cellWidth(tie, side)
                                      : 8.0 / 3.0 * area / length(across->first));
        }
    }

private:
    using Links = std::map<ParticlePair, Id>;

    Vec3 at(Id particle) const
    {
        const Particle* row = findRow(m_part.particles, particle);
        return row ? row->position : Vec3(Vec3::Zero()); // the check reports it
    }
    double length(const ParticlePair& tie) const { return (at(tie.second) - at(tie.first)).norm(); }

    void addSide(Id a, Id b, Id opposite, std::size_t panel)
    {
        StripSide& side = m_sides[pairOf(a, b)];
        side.panels.push_back(panel);
        side.opposite.push_back(opposite);
    }

    // Where the way between the corners opposite to a side crosses it, from 0 to 1 along the side.
    // The panels are taken as unfolded into a plane.
    double crossing(const ParticlePair& pair, const StripSide& side) const
    {
        const Vec3 along = at(pair.second) - at(pair.first);
        const auto placeOf = [&](Id corner) { // along the side, and away from it
            const Vec3 way = at(corner) - at(pair.first);
            const double t = way.dot(along) / along.squaredNorm();
            return std::pair(t, (way - t * along).norm());
        };
        const auto [t, height] = placeOf(side.opposite[0]);
        const auto [u, depth] = placeOf(side.opposite[1]);
        return (t * depth + u * height) / (height + depth);
    }

    // The link between the corners opposite to a side of two panels, or the end. What is the side
    // of another panel goes along that one, and what runs through an end of this side, as bend
    // springs over two cells do, does not cross it.
    Links::const_iterator linkAcross(const ParticlePair& pair, const StripSide& side) const
    {
        constexpr double margin = 0.05;
        if (side.panels.size() != 2 || !(std::abs(crossing(pair, side) - 0.5) < 0.5 - margin))
            return m_links.end();
        const ParticlePair across = pairOf(side.opposite[0], side.opposite[1]);
        return m_sides.contains(across) ? m_links.end() : m_links.find(across);
    }

    void countTies()
    {
        m_across.resize(m_area.size());
        for (const auto& [tie, side] : m_sides)
            if (linkAcross(tie, side) != m_links.end())
                for (const std::size_t panel : side.panels)
                    ++m_across[panel];
    }

    // Whether the side is a diagonal of a cell: its panels are tied across it, and across no other.
    bool isDiagonal(const ParticlePair& tie, const StripSide& side) const
    {
        return m_links.contains(tie) && linkAcross(tie, side) != m_links.end()
               && m_across[side.panels[0]] == 1 && m_across[side.panels[1]] == 1;
    }

    // The side across which the panel makes a cell, or null.
    const StripSide* cellSide(std::size_t panel) const
    {
        const Panel& row = m_part.panels[panel];
        for (const ParticlePair& tie :
             {pairOf(row.a, row.b), pairOf(row.b, row.c), pairOf(row.c, row.a)})
            if (const StripSide& side = m_sides.at(tie); isDiagonal(tie, side))
                return &side;
        return nullptr;
    }

    // m^2, of fabric that a side stands for.
    double areaBeside(const StripSide& side) const
    {
        double area = 0.0;
        for (const std::size_t panel : side.panels) {
            const StripSide* cell = cellSide(panel);
            area +=
                cell ? 0.5 * (m_area[cell->panels[0]] + m_area[cell->panels[1]]) : m_area[panel];
        }
        return area;
    }

    // m, of either diagonal of the cell.
    double cellWidth(const ParticlePair& tie, const StripSide& side) const
    {
        const Vec3 a = at(tie.first), b = at(side.opposite[0]), c = at(tie.second),
                   d = at(side.opposite[1]);
        return biasWidth(0.5 * ((b - a).norm() + (d - c).norm()),
                         0.5 * ((c - b).norm() + (a - d).norm()));
    }

    const Part& m_part;
    Links m_links; // that may become strips
    std::map<ParticlePair, StripSide> m_sides;
    std::vector<double> m_area; // [panels] m^2
    std::vector<int> m_across;  // [panels] sides across which the panel is tied
};

} // namespace

Result<StripWidths> widthsFromMesh(const Scene& scene, const std::vector<Id>& materials)
{
    StripWidths made{{Message("Widths from the mesh"), {}}};
    std::map<Id, std::pair<LinkRole, double>> strips; // each link once
    forEachPart(scene, [&](Id, const Part& part) {
        Strips(part, materials).forEachStrip([&](Id link, LinkRole role, double width) {
            if (width > 0.0 && std::isfinite(width)) // beside a side with length and area
                strips.try_emplace(link, role, width);
        });
    });
    SetValues roles{&propertyOf<&Link::role>(), {}, {}};
    SetValues widths{&propertyOf<&Link::width>(), {}, {}};
    for (const auto& [link, strip] : strips) {
        roles.targets.push_back(link);
        roles.values.emplace_back(std::string(choiceNames<LinkRole>[std::size_t(strip.first)]));
        widths.targets.push_back(link);
        widths.values.emplace_back(strip.second);
        ++(strip.first == LinkRole::Thread ? made.threads : made.biases);
    }
    if (widths.targets.empty())
        return Failure("No link of this material lies along a panel, so that none gets a width: "
                       "draw panels between its links first.");
    made.edit.changes.emplace_back(std::move(roles));
    made.edit.changes.emplace_back(std::move(widths));
    return made;
}

} // namespace ripstop
