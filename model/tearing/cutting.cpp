// A cut runs in two stages. Each flat piece of the stroke marks the links and panels that it
// crosses and to which side particles and panels lean; after the last piece, links break and the
// mesh parts at the particles where both sides meet, or crossed panels vanish.
//
// Marking comes first for all pieces, so that the outcome does not hang on how the stroke was
// sampled.
#include "tearing/cutting.h"

#include "tearing/mesh_parting.h"
#include "tearing/tearing.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

// The knife between two points of its stroke.
class Blade
{
public:
    Blade(const Cut::Edge& from, const Cut::Edge& to)
        : m_corners{from.near, from.far, to.far, to.near}
        , m_normal((from.far - from.near).cross(to.far - from.near))
    {}

    const Vec3& normal() const { return m_normal; }
    double side(const Vec3& place) const { return (place - m_corners[0]).dot(m_normal); }

    bool crosses(const Vec3& a, const Vec3& b) const
    {
        const double atA = side(a), atB = side(b);
        if ((atA < 0.0) == (atB < 0.0))
            return false;
        const Vec3 place = a + atA / (atA - atB) * (b - a);
        // inside when it lies on the same side of all four edges
        bool left = true, right = true;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 edge = m_corners[(i + 1) % 4] - m_corners[i];
            const double turn = edge.cross(place - m_corners[i]).dot(m_normal);
            left &= turn >= 0.0;
            right &= turn <= 0.0;
        }
        return left || right;
    }

private:
    std::array<Vec3, 4> m_corners;
    Vec3 m_normal; // not of unit length; it points to one side of the stroke
};

class Knife
{
public:
    Knife(const System& system, State& state)
        : m_system(system)
        , m_state(state)
        , m_isBeyond(system.key.size(), 0)
        , m_lean(system.key.size(), 0)
        , m_crossedPanel(system.panels.size(), 0)
        , m_panelLean(system.panels.size(), 0)
        , m_crossedLink(system.links.size(), 0)
        , m_across(system.key.size(), Vec3::Zero())
    {}

    void slash(const Blade& blade)
    {
        // most of a large mesh is on one side of its plane
        for (std::size_t i = 0; i < m_isBeyond.size(); ++i)
            m_isBeyond[i] = blade.side(m_state.position[i]) < 0.0;
        const auto crosses = [&](int first, int second) {
            const auto a = std::size_t(first), b = std::size_t(second);
            return m_isBeyond[a] != m_isBeyond[b]
                   && blade.crosses(m_state.position[a], m_state.position[b]);
        };
        for (std::size_t i = 0; i < m_system.links.size(); ++i) {
            const LinkPlace& link = m_system.links[i];
            if (!isTorn(link, m_state) && crosses(link.a, link.b))
                m_crossedLink[i] = 1;
        }
        for (std::size_t i = 0; i < m_system.panels.size(); ++i) {
            const auto& corner = m_system.panels[i].corner;
            for (std::size_t k = 0; k < 3 && !m_state.panelGone[i]; ++k) {
                const int a = corner[k], b = corner[(k + 1) % 3];
                if (!crosses(a, b))
                    continue;
                m_crossedPanel[i] = 1;
                m_panelLean[i] += signOf(blade.side(middleOf(i)));
                lean(a, blade);
                lean(b, blade);
            }
        }
    }

    bool cut()
    {
        const bool splits = m_system.tearMesh == TearMesh::Split;
        std::vector<std::uint8_t> isEdge(m_system.links.size(), 0);
        for (std::size_t i = 0; i < m_system.links.size(); ++i)
            isEdge[i] = splits && hasPanel(int(i));
        for (std::size_t i = 0; i < m_system.links.size(); ++i)
            if (m_crossedLink[i])
                (isEdge[i] ? noteBreak : breakLink)(m_system, m_state, int(i));
        if (splits)
            return part();
        for (std::size_t i = 0; i < m_system.panels.size(); ++i)
            if (m_crossedPanel[i])
                m_state.panelGone[i] = 1;
        return false;
    }

private:
    void lean(int particle, const Blade& blade)
    {
        const auto p = std::size_t(particle);
        m_lean[p] += signOf(blade.side(m_state.position[p]));
        m_across[p] += blade.normal().normalized();
    }

    bool hasPanel(int link) const
    {
        const Rows& beside = m_system.panelsBeside;
        for (int k = beside.start[std::size_t(link)]; k < beside.start[std::size_t(link) + 1]; ++k)
            if (!m_state.panelGone[std::size_t(beside.items[std::size_t(k)])])
                return true;
        return false;
    }

    static int signOf(double side) { return side < 0.0 ? -1 : 1; }

    Vec3 middleOf(std::size_t panel) const
    {
        const auto [a, b, c] = m_system.panels[panel].corner;
        return (m_state.position[std::size_t(a)] + m_state.position[std::size_t(b)]
                + m_state.position[std::size_t(c)])
               / 3.0;
    }

    bool part()
    {
        const std::size_t before = m_state.splits.size();
        MeshParting parting(m_system, m_state);
        for (std::size_t p = 0; p < m_lean.size(); ++p)
            if (m_lean[p] != 0)
                partAt(parting, int(p));
        return m_state.splits.size() > before;
    }

    // The twin takes the panels of the other side.
    void partAt(MeshParting& parting, int particle)
    {
        const int here = signOf(m_lean[std::size_t(particle)]);
        const std::vector<int> panels = parting.mesh().panelsAt(particle);
        std::vector<std::uint8_t> isNear;
        for (const int panel : panels)
            isNear.push_back(m_crossedPanel[std::size_t(panel)]
                             && signOf(m_panelLean[std::size_t(panel)]) != here);
        const auto near = std::count(isNear.begin(), isNear.end(), 1);
        if (near == 0)
            return;
        const Vec3 across = double(-here) * m_across[std::size_t(particle)];
        const Sides sides = parting.sides(particle, panels, isNear, across);
        if (sides.leaves)
            parting.part(particle, sides, std::nullopt);
    }

    const System& m_system;
    State& m_state;
    std::vector<std::uint8_t> m_isBeyond;     // [particles] the plane of the blade
    std::vector<int> m_lean;                  // [particles] to which side, by how many crossings
    std::vector<std::uint8_t> m_crossedPanel; // [panels]
    std::vector<int> m_panelLean;             // [panels] the same, of their middles
    std::vector<std::uint8_t> m_crossedLink;  // [links]
    std::vector<Vec3> m_across;               // [particles] to the side of +1
};

} // namespace

bool cutAlong(const System& system, State& state, const Cut& cut)
{
    Knife knife(system, state);
    for (std::size_t i = 0; i + 1 < cut.edges.size(); ++i)
        if (const Blade blade(cut.edges[i], cut.edges[i + 1]); blade.normal().norm() > 0.0)
            knife.slash(blade);
    return knife.cut();
}

} // namespace ripstop
