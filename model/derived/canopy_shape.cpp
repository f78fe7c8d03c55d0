// Finds the pieces of a canopy in these stages:
// 1. It refuses a part without panels, with corners in other parts, or with more than two panels
//    at an edge, because "beside" and "inside" have no meaning there.
// 2. It collects the panels that share edges into pieces and turns each to face as its neighbour
//    does; a piece that cannot be turned so has one side only.
// 3. The edges with one panel are followed into loops. The loop with the most links to particles
//    outside the piece is the mouth, the longest of equal ones; the others are vents.
// 4. The sign of the volume over the middle of the mouth, with the vents closed, says whether all
//    facets must be turned. A volume near zero leaves no inside to tell.
#include "derived/canopy_shape.h"

#include "derived/cloth_area.h"
#include "scene/scene.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace ripstop {
namespace {

using Edge = std::pair<Id, Id>; // the lower id first

Edge edgeOf(Id a, Id b) { return {std::min(a, b), std::max(a, b)}; }

struct Side // of a panel
{
    int panel;
    bool rising; // goes from the lower id to the higher
};

using Sides = std::map<Edge, std::vector<Side>>;

class PieceFinder
{
public:
    explicit PieceFinder(const Part& part)
        : m_part(part)
        , m_piece(part.panels.size(), -1)
        , m_turned(part.panels.size(), false)
        , m_cloth(part)
    {}

    Result<std::vector<CanopyPiece>> run()
    {
        if (m_part.panels.empty())
            return refusal(
                Message("has canopy pressure and no panels to hold the air: add panels"));
        for (const Panel& row : m_part.panels)
            for (const Id id : {row.a, row.b, row.c})
                if (!findRow(m_part.particles, id))
                    return refusal(
                        Message("has canopy pressure, and panel %1 has a corner that is not a "
                                "particle of this part: join the two parts",
                                std::uint32_t(row.id)));
        noteSides();
        for (const auto& [edge, sides] : m_sides)
            if (sides.size() > 2)
                return refusal(Message("has canopy pressure, and more than two panels meet between "
                                       "particles %1 and %2: remove all but two of them",
                                       std::uint32_t(edge.first), std::uint32_t(edge.second)));
        std::vector<CanopyPiece> pieces;
        for (int panel = 0; panel < int(m_part.panels.size()); ++panel) {
            if (m_piece[std::size_t(panel)] >= 0)
                continue;
            if (!collect(panel, int(pieces.size())))
                return refusal(
                    Message("has canopy pressure and fabric with one side only, like a twisted "
                            "ribbon: remove a panel of the twist"));
            CanopyPiece piece = facetsOf(int(pieces.size()));
            if (!findEdges(piece))
                return refusal(
                    Message("has canopy pressure and closed fabric that no air can enter: leave "
                            "a mouth open"));
            if (!faceOutwards(piece))
                return refusal(
                    Message("has canopy pressure and lies flat where the run starts, so that "
                            "neither side is the inside: give it a hollow"));
            pieces.push_back(std::move(piece));
        }
        return pieces;
    }

private:
    Failure refusal(const Message& what) const
    {
        return Failure("Part %1 %2, or set its canopyPressure to 0.", m_part.name, what);
    }

    std::array<Id, 3> cornersOf(int panel) const
    {
        const Panel& row = m_part.panels[std::size_t(panel)];
        if (m_turned[std::size_t(panel)])
            return {row.a, row.c, row.b};
        return {row.a, row.b, row.c};
    }

    void noteSides()
    {
        for (int panel = 0; panel < int(m_part.panels.size()); ++panel) {
            const std::array<Id, 3> corner = cornersOf(panel);
            for (std::size_t k = 0; k < 3; ++k) {
                const Id a = corner[k];
                const Id b = corner[(k + 1) % 3];
                m_sides[edgeOf(a, b)].push_back({panel, a < b});
            }
        }
    }

    // Collects all panels that hang together with this one and turns them to face the same way.
    // Returns false when they cannot all be turned so.
    bool collect(int first, int piece)
    {
        std::vector<int> found{first};
        m_piece[std::size_t(first)] = piece;
        for (std::size_t next = 0; next < found.size(); ++next) {
            const int panel = found[next];
            const std::array<Id, 3> corner = cornersOf(panel);
            for (std::size_t k = 0; k < 3; ++k) {
                const Id a = corner[k];
                const Id b = corner[(k + 1) % 3];
                for (const Side& side : m_sides[edgeOf(a, b)]) {
                    const auto other = std::size_t(side.panel);
                    if (side.panel == panel)
                        continue;
                    const bool alike = (a < b) == (side.rising != m_turned[other]);
                    if (m_piece[other] < 0) {
                        m_piece[other] = piece;
                        m_turned[other] = alike;
                        found.push_back(side.panel);
                    } else if (alike) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    CanopyPiece facetsOf(int piece) const
    {
        CanopyPiece made;
        for (int panel = 0; panel < int(m_part.panels.size()); ++panel)
            if (m_piece[std::size_t(panel)] == piece)
                made.facets.push_back(
                    {panel, cornersOf(panel), m_cloth.of(m_part.panels[std::size_t(panel)])});
        return made;
    }

    Vec3 at(Id particle) const { return findRow(m_part.particles, particle)->position; }

    Vec3 middleOf(const std::vector<Id>& loop) const
    {
        Vec3 sum = Vec3::Zero();
        for (const Id id : loop)
            sum += at(id);
        return sum / double(loop.size());
    }

    // Sorts the edges of the piece into its mouth and its vents. Returns false without edges.
    bool findEdges(CanopyPiece& piece)
    {
        std::multimap<Id, Id> next; // along the edge, as the panels beside it go
        for (const CanopyPiece::Facet& facet : piece.facets)
            for (std::size_t k = 0; k < 3; ++k) {
                const Id a = facet.corner[k];
                const Id b = facet.corner[(k + 1) % 3];
                if (m_sides[edgeOf(a, b)].size() == 1)
                    next.emplace(a, b);
            }
        std::vector<std::vector<Id>> loops;
        while (!next.empty()) {
            loops.emplace_back();
            for (auto step = next.begin(); step != next.end();) {
                loops.back().push_back(step->first);
                const Id ahead = step->second;
                next.erase(step);
                step = next.find(ahead);
            }
        }
        if (loops.empty())
            return false;
        const auto mouth =
            std::max_element(loops.begin(), loops.end(), [&](const auto& one, const auto& other) {
                return std::pair(tiesOutside(piece, one), lengthOf(one))
                       < std::pair(tiesOutside(piece, other), lengthOf(other));
            });
        piece.mouth = std::move(*mouth);
        loops.erase(mouth);
        piece.vents = std::move(loops);
        return true;
    }

    int tiesOutside(const CanopyPiece& piece, const std::vector<Id>& loop) const
    {
        std::vector<Id> inside;
        for (const CanopyPiece::Facet& facet : piece.facets)
            inside.insert(inside.end(), facet.corner.begin(), facet.corner.end());
        std::sort(inside.begin(), inside.end());
        std::vector<Id> edge = loop;
        std::sort(edge.begin(), edge.end());
        const auto has = [](const std::vector<Id>& list, Id id) {
            return std::binary_search(list.begin(), list.end(), id);
        };
        return int(std::count_if(m_part.links.begin(), m_part.links.end(), [&](const Link& link) {
            return (has(edge, link.from) && !has(inside, link.to))
                   || (has(edge, link.to) && !has(inside, link.from));
        }));
    }

    double lengthOf(const std::vector<Id>& loop) const // m
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < loop.size(); ++i)
            sum += (at(loop[(i + 1) % loop.size()]) - at(loop[i])).norm();
        return sum;
    }

    // Returns false when the piece holds no volume to tell its inside from.
    bool faceOutwards(CanopyPiece& piece)
    {
        const Vec3 from = middleOf(piece.mouth);
        const auto cone = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
            return (a - from).dot((b - from).cross(c - from)) / 6.0;
        };
        double volume = 0.0;
        double area = 0.0;
        for (const CanopyPiece::Facet& facet : piece.facets) {
            volume += cone(at(facet.corner[0]), at(facet.corner[1]), at(facet.corner[2]));
            area += facet.area;
        }
        for (const std::vector<Id>& vent : piece.vents) {
            const Vec3 middle = middleOf(vent);
            for (std::size_t i = 0; i < vent.size(); ++i)
                volume += cone(at(vent[(i + 1) % vent.size()]), at(vent[i]), middle);
        }
        if (std::abs(volume) <= 1e-6 * std::pow(area, 1.5))
            return false;
        if (volume > 0.0)
            return true;
        for (CanopyPiece::Facet& facet : piece.facets)
            std::swap(facet.corner[1], facet.corner[2]);
        std::reverse(piece.mouth.begin(), piece.mouth.end());
        for (std::vector<Id>& vent : piece.vents)
            std::reverse(vent.begin(), vent.end());
        return true;
    }

    const Part& m_part;
    std::vector<int> m_piece; // [panels] its piece, -1 before it is found
    std::vector<bool> m_turned;
    Sides m_sides;
    ClothArea m_cloth;
};

} // namespace

Result<std::vector<CanopyPiece>> canopyPieces(const Part& part) { return PieceFinder(part).run(); }

} // namespace ripstop
