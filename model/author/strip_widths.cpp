// Part by part: Strips notes the links that may become strips and the sides of panels, finds the
// cells, and gives each link its width. A link is a side before it is a diagonal.
#include "author/strip_widths.h"

#include "derived/cloth_area.h"
#include "derived/link_stiffness.h"
#include "derived/panel_fabric.h"
#include "derived/panel_sides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ripstop {
namespace {

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
        , m_cut(part)
    {
        for (const Link& link : part.links)
            if (std::ranges::count(materials, link.material) > 0 && !isOfFabric(link))
                m_links.emplace(sideOf(link.from, link.to), link.id);
        for (std::size_t i = 0; i < part.panels.size(); ++i) {
            const Panel& panel = part.panels[i];
            addSide(panel.a, panel.b, panel.c, i);
            addSide(panel.b, panel.c, panel.a, i);
            addSide(panel.c, panel.a, panel.b, i);
            m_area.push_back(m_cut.of(panel));
        }
        countTies();
    }

    // Calls set(link, strip) for each link that stands for one.
    template <typename Set>
    void forEachStrip(Set set) const
    {
        for (const auto& [tie, side] : m_sides) {
            if (const auto link = m_links.find(tie); link != m_links.end()) {
                if (isDiagonal(tie, side))
                    set(link->second, {LinkRole::Bias, widthIn(cellAt(tie, side))});
                else
                    set(link->second, threadBeside(tie, side));
            }
            const auto across = linkAcross(tie, side);
            if (across == m_links.end())
                continue;
            const double area = m_area[side.panels[0]] + m_area[side.panels[1]];
            set(across->second,
                {LinkRole::Bias, isDiagonal(tie, side) ? widthIn(cellAt(tie, side))
                                                       : 8.0 / 3.0 * area / length(across->first)});
        }
    }

private:
    using Links = std::map<PanelSide, Id>;
    using Sides = std::map<PanelSide, StripSide>;

    Vec3 at(Id particle) const
    {
        const Particle* row = findRow(m_part.particles, particle);
        return row ? row->position : Vec3(Vec3::Zero()); // the check reports it
    }
    double length(Id a, Id b) const
    {
        return m_cut.lengthOf(a, b).value_or((at(b) - at(a)).norm());
    }
    double length(const PanelSide& tie) const { return length(tie.first, tie.second); }

    void addSide(Id a, Id b, Id opposite, std::size_t panel)
    {
        StripSide& side = m_sides[sideOf(a, b)];
        side.panels.push_back(panel);
        side.opposite.push_back(opposite);
    }

    // Where the way between the corners opposite to a side crosses it, from 0 to 1 along the side.
    // The panels are taken as unfolded into a plane.
    double crossing(const PanelSide& pair, const StripSide& side) const
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
    Links::const_iterator linkAcross(const PanelSide& pair, const StripSide& side) const
    {
        constexpr double margin = 0.05;
        if (side.panels.size() != 2 || !(std::abs(crossing(pair, side) - 0.5) < 0.5 - margin))
            return m_links.end();
        const PanelSide across = sideOf(side.opposite[0], side.opposite[1]);
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
    bool isDiagonal(const PanelSide& tie, const StripSide& side) const
    {
        return m_links.contains(tie) && linkAcross(tie, side) != m_links.end()
               && m_across[side.panels[0]] == 1 && m_across[side.panels[1]] == 1;
    }

    // The side across which the panel makes a cell, or the end.
    Sides::const_iterator cellSide(std::size_t panel) const
    {
        const Panel& row = m_part.panels[panel];
        for (const PanelSide& tie : sidesOf(row))
            if (const auto side = m_sides.find(tie); isDiagonal(tie, side->second))
                return side;
        return m_sides.end();
    }

    // The fabric beside a side, shared out among its length.
    FabricStrip threadBeside(const PanelSide& tie, const StripSide& side) const
    {
        double area = 0.0, squaredAspects = 0.0; // m^2, the latter times the area of each
        for (const std::size_t panel : side.panels) {
            const auto cell = cellSide(panel);
            if (cell == m_sides.end()) {
                area += m_area[panel];
                squaredAspects += m_area[panel];
                continue;
            }
            const auto& [diagonal, sides] = *cell;
            const double half = 0.5 * (m_area[sides.panels[0]] + m_area[sides.panels[1]]);
            const Cell lengths = cellAt(diagonal, sides);
            const bool isFirst = tie == sideOf(diagonal.first, sides.opposite[0])
                                 || tie == sideOf(diagonal.second, sides.opposite[1]);
            const double aspect =
                isFirst ? lengths.first / lengths.second : lengths.second / lengths.first;
            area += half;
            squaredAspects += half * aspect * aspect;
        }
        return {LinkRole::Thread, area / length(tie),
                aspectOfCells(std::sqrt(squaredAspects), std::sqrt(area))};
    }

    struct Cell // m, its mean sides
    {
        double first;  // from the lower end of the diagonal to the first corner off it
        double second; // from there to the upper end
    };
    Cell cellAt(const PanelSide& diagonal, const StripSide& side) const
    {
        const Id a = diagonal.first, b = side.opposite[0], c = diagonal.second,
                 d = side.opposite[1];
        return {0.5 * (length(a, b) + length(c, d)), 0.5 * (length(b, c) + length(d, a))};
    }
    static double widthIn(const Cell& cell) { return biasWidth(cell.first, cell.second); }

    const Part& m_part;
    ClothArea m_cut;
    Links m_links; // that may become strips
    Sides m_sides;
    std::vector<double> m_area; // [panels] m^2
    std::vector<int> m_across;  // [panels] sides across which the panel is tied
};

} // namespace

Result<StripWidths> widthsFromMesh(const Scene& scene, const std::vector<Id>& materials)
{
    StripWidths made{{Message("Widths from the mesh"), {}}};
    std::map<Id, FabricStrip> strips; // each link once
    forEachPart(scene, [&](Id, const Part& part) {
        Strips(part, materials).forEachStrip([&](Id link, const FabricStrip& strip) {
            // beside a side with length, and cells with an area
            if (strip.width > 0.0 && std::isfinite(strip.width * strip.cellAspect))
                strips.try_emplace(link, strip);
        });
    });
    SetValues roles{&propertyOf<&Link::role>(), {}, {}};
    SetValues widths{&propertyOf<&Link::width>(), {}, {}};
    SetValues aspects{&propertyOf<&Link::cellAspect>(), {}, {}};
    for (const auto& [link, strip] : strips) {
        const auto set = [link = link](SetValues& values, Value value) {
            values.targets.push_back(link);
            values.values.push_back(std::move(value));
        };
        set(roles, std::string(choiceNames<LinkRole>[std::size_t(strip.role)]));
        set(widths, strip.width);
        if (strip.role == LinkRole::Thread)
            set(aspects, strip.cellAspect);
        ++(strip.role == LinkRole::Thread ? made.threads : made.biases);
    }
    if (widths.targets.empty())
        return Failure("No link of this material lies along a panel, so that none gets a width: "
                       "draw panels between its links first.");
    made.edit.changes.emplace_back(std::move(roles));
    made.edit.changes.emplace_back(std::move(widths));
    if (!aspects.targets.empty())
        made.edit.changes.emplace_back(std::move(aspects));
    return made;
}

} // namespace ripstop
