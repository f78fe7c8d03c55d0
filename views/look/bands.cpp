// A Fabric knows which panels meet at a side. strip() goes round both ends of a side, from panel to
// panel, for as long as these lie beside it: how far each of their corners is from the line through
// the side follows from the shape at rest, as does the piece that is nearer than the width.
//
// straightenBorders() looks at what stands on the edge of the fabric: two panels of one colour that
// are neighbours along it, with another colour in the gap between them, are teeth. Teeth that hang
// together are one border.
#include "look/bands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace ripstop {
namespace {

constexpr double seamWidth = 0.012;      // m
constexpr double straightest = 0.5;      // rad, that a border may turn from one side to the next
using Shares = std::array<float, 3>;     // of the corners of a panel
using Distances = std::array<double, 3>; // m, of the corners of a panel from a line
using Ends = std::pair<int, int>;        // particles, the lower first

Ends endsOf(int a, int b) { return std::minmax(a, b); }

class Fabric
{
public:
    Fabric(std::span<const Corners> panels, std::span<const std::array<ClothPoint, 3>> points)
        : m_panels(panels)
        , m_points(points)
    {
        for (int p = 0; p < int(panels.size()); ++p)
            for (int i = 0; i < 3; ++i)
                m_sides.push_back({endsOf(panels[p][i], panels[p][(i + 1) % 3]), p});
        std::ranges::sort(m_sides);
    }

    using Row = std::pair<Ends, int>;
    std::span<const Row> at(const Ends& side) const
    {
        return {std::ranges::lower_bound(m_sides, side, {}, &Row::first),
                std::ranges::upper_bound(m_sides, side, {}, &Row::first)};
    }
    const std::vector<Row>& sides() const { return m_sides; } // ascending

    int cornerAt(int panel, int particle) const
    {
        return int(std::ranges::find(m_panels[panel], particle) - m_panels[panel].begin());
    }
    int third(int panel, const Ends& side) const // particle
    {
        for (const int corner : m_panels[panel])
            if (corner != side.first && corner != side.second)
                return corner;
        return m_panels[panel][0];
    }
    // The panel on the other side; -1 where there is none, or more than one.
    int across(int panel, const Ends& side) const
    {
        const auto both = at(side);
        return both.size() == 2 ? both[both[0].second == panel ? 1 : 0].second : -1;
    }
    double length(int panel, int a, int b) const
    {
        return std::hypot(way(panel, a, b)[0], way(panel, a, b)[1]);
    }
    double angle(int panel, int at, int a, int b) const // rad
    {
        const auto u = way(panel, at, a), v = way(panel, at, b);
        return std::abs(std::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]));
    }
    double area(int panel) const
    {
        const Corners& c = m_panels[panel];
        const auto u = way(panel, c[0], c[1]), v = way(panel, c[0], c[2]);
        return 0.5 * std::abs(u[0] * v[1] - u[1] * v[0]);
    }

private:
    std::array<double, 2> way(int panel, int from, int to) const
    {
        const ClothPoint& a = m_points[panel][cornerAt(panel, from)];
        const ClothPoint& b = m_points[panel][cornerAt(panel, to)];
        return {double(b[0] - a[0]), double(b[1] - a[1])};
    }

    std::span<const Corners> m_panels;
    std::span<const std::array<ClothPoint, 3>> m_points;
    std::vector<Row> m_sides;
};

// What of a panel is nearer to the line than the width.
std::vector<Shares> nearer(const Distances& away, double width)
{
    std::vector<Shares> piece;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        Shares corner{};
        if (away[i] <= width) {
            corner[i] = 1.0F;
            piece.push_back(corner);
        }
        if ((away[i] <= width) != (away[j] <= width)) {
            const double share = (width - away[i]) / (away[j] - away[i]);
            corner = {};
            corner[i] = float(1.0 - share);
            corner[j] = float(share);
            piece.push_back(corner);
        }
    }
    return piece;
}

struct Ink
{
    double width; // m
    Color color;
    BandKind kind;
};

class Cutter
{
public:
    Cutter(const Fabric& fabric, Bands& bands)
        : m_fabric(fabric)
        , m_bands(bands)
    {}

    // The strip beside a side, on this panel that has it and on those that go round its ends.
    void strip(int panel, const Ends& side, const Ink& ink)
    {
        turn(panel, side.first, side.second, ink);
        turn(panel, side.second, side.first, ink);
    }

private:
    // Round `hub`, beginning at the side from there to `from`.
    void turn(int panel, int hub, int from, const Ink& ink)
    {
        const int start = from;
        double angle = 0.0;
        for (bool isFirst = true; panel >= 0 && angle < 0.5 * std::numbers::pi; isFirst = false) {
            const int next = m_fabric.third(panel, endsOf(hub, from));
            const double opened = angle + m_fabric.angle(panel, hub, from, next);
            Distances away{};
            away[m_fabric.cornerAt(panel, from)] =
                m_fabric.length(panel, hub, from) * std::sin(angle);
            away[m_fabric.cornerAt(panel, next)] =
                m_fabric.length(panel, hub, next) * std::sin(std::min(opened, std::numbers::pi));
            if (!isFirst || hub < start) // its own panel is met from both ends
                add(panel, away, ink);
            panel = m_fabric.across(panel, endsOf(hub, next));
            from = next;
            angle = opened;
        }
    }

    void add(int panel, const Distances& away, const Ink& ink)
    {
        auto piece = nearer(away, ink.width);
        if (piece.size() >= 3)
            m_bands.pieces.push_back({panel, ink.color, ink.kind, std::move(piece)});
    }

    const Fabric& m_fabric;
    Bands& m_bands;
};

// --- borders ---------------------------------------------------------------------------------

class Borders
{
public:
    Borders(const Fabric& fabric, const Look& look)
        : m_fabric(fabric)
        , m_look(look)
    {}

    void straighten(Cutter& cutter, Bands& bands)
    {
        collect();
        for (std::size_t i = 0; i < m_teeth.size(); ++i)
            for (const int end : {m_teeth[i].side.first, m_teeth[i].side.second})
                join(int(i), end);
        std::map<int, std::pair<double, double>> sums; // area and length by root
        for (std::size_t i = 0; i < m_teeth.size(); ++i) {
            auto& [area, length] = sums[root(int(i))];
            const Tooth& tooth = m_teeth[i];
            area += m_fabric.area(tooth.panel);
            length += m_fabric.length(tooth.panel, tooth.side.first, tooth.side.second);
        }
        for (std::size_t i = 0; i < m_teeth.size(); ++i) {
            const Tooth& tooth = m_teeth[i];
            if (!tooth.isOfBorder)
                continue;
            const auto& [area, length] = sums[root(int(i))];
            const Color color = m_look.panelColor[tooth.panel];
            bands.panelColor[tooth.panel] = tooth.below;
            cutter.strip(tooth.panel, tooth.side, {area / length, color, BandKind::Border});
        }
    }

private:
    struct Tooth // a panel that stands on the edge of the fabric
    {
        Ends side;
        int panel;
        int parent; // of the teeth that hang together
        bool isOfBorder = false;
        Color below{};
    };

    void collect()
    {
        const auto& sides = m_fabric.sides();
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const bool isEdge = (i == 0 || sides[i - 1].first != sides[i].first)
                                && (i + 1 == sides.size() || sides[i + 1].first != sides[i].first);
            if (!isEdge || !m_look.panelCloth[sides[i].second].isBuilt)
                continue;
            const int number = int(m_teeth.size());
            m_teeth.push_back({sides[i].first, sides[i].second, number});
            m_at.emplace(sides[i].first.first, number);
            m_at.emplace(sides[i].first.second, number);
        }
    }

    int root(int tooth) const
    {
        while (m_teeth[tooth].parent != tooth)
            tooth = m_teeth[tooth].parent;
        return tooth;
    }

    // Goes round a particle of the edge from one tooth to the next.
    void join(int number, int hub)
    {
        const Tooth& tooth = m_teeth[number];
        const Color color = m_look.panelColor[tooth.panel];
        int from = tooth.side.first == hub ? tooth.side.second : tooth.side.first;
        int panel = tooth.panel;
        double angle = 0.0;
        std::optional<Color> gap;
        while (panel >= 0) {
            if (m_look.panelColor[panel] != color)
                gap = m_look.panelColor[panel];
            const int next = m_fabric.third(panel, endsOf(hub, from));
            angle += m_fabric.angle(panel, hub, from, next);
            const int beyond = m_fabric.across(panel, endsOf(hub, next));
            if (beyond < 0 && panel != tooth.panel && gap && m_look.panelColor[panel] == color
                && std::abs(angle - std::numbers::pi) < straightest)
                tie(number, toothAt(hub, endsOf(hub, next)), *gap);
            panel = beyond;
            from = next;
        }
    }

    int toothAt(int hub, const Ends& side) const
    {
        const auto [first, last] = m_at.equal_range(hub);
        for (auto at = first; at != last; ++at)
            if (m_teeth[at->second].side == side)
                return at->second;
        return -1;
    }

    void tie(int a, int b, const Color& below)
    {
        if (b < 0)
            return;
        for (const int tooth : {a, b}) {
            m_teeth[tooth].isOfBorder = true;
            m_teeth[tooth].below = below;
        }
        m_teeth[root(b)].parent = root(a);
    }

    const Fabric& m_fabric;
    const Look& m_look;
    std::vector<Tooth> m_teeth;
    std::multimap<int, int> m_at; // teeth by particle
};

void sew(const Fabric& fabric, const Layout& layout, const Look& look, Cutter& cutter)
{
    for (std::size_t i = 0; i < layout.links.size(); ++i) {
        if (look.linkForm[i] != Look::Form::Sewn || !look.linkShown[i])
            continue;
        const Ends side = endsOf(layout.links[i].a, layout.links[i].b);
        const auto both = fabric.at(side);
        const double width = both.size() == 1 ? seamWidth : 0.5 * seamWidth;
        for (const auto& [shared, panel] : both)
            cutter.strip(panel, side, {width, look.linkColor[i], BandKind::Sewn});
    }
}

} // namespace

Bands bandsOf(std::span<const Corners> panels, std::span<const std::array<ClothPoint, 3>> points,
              const Layout& layout, const Look& look)
{
    Bands bands{look.panelColor, {}};
    const bool isBuilt = std::ranges::any_of(look.panelCloth, &Look::Cloth::isBuilt);
    const bool isSewn = std::ranges::find(look.linkForm, Look::Form::Sewn) != look.linkForm.end();
    if (!isBuilt && !isSewn)
        return bands;
    const Fabric fabric(panels, points);
    Cutter cutter(fabric, bands);
    Borders(fabric, look).straighten(cutter, bands);
    sew(fabric, layout, look, cutter);
    return bands;
}

} // namespace ripstop
