// Opens the mesh at each link that has torn and waits in State::tearHolds, and at each panel that
// State::panelHold says has yet to open.
//
// openTears() works on a copy of the list, as parting adds to it. Opening::open() passes over links
// whose panels are gone and divides the panels at both ends of the others by their angles from the
// link. Where nothing would stay behind at either end, the panels beside the link go. Otherwise the
// link is whole again, and the mesh parts at the end where something stays behind, or of two such
// ends at the one that preference() ranks higher. anglesFrom() sums the angles of panels outwards
// from the link until none becomes smaller; panels that it does not reach stay.
//
// For a panel, fanOut() does so from the two sides of the panel, in both ways around the corner, as
// the direction of its threads is that of no link.
#include "tearing/tear_opening.h"

#include "base/portable_math.h"
#include "tearing/mesh_parting.h"
#include "tearing/panel_tearing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numbers>

namespace ripstop {
namespace {

class Opening
{
public:
    Opening(const System& system, State& state)
        : m_system(system)
        , m_state(state)
        , m_parting(system, state)
        , m_mesh(m_parting.mesh())
    {}

    void open(const TearHold& tear)
    {
        const auto [a, b] = m_mesh.ends(tear.link);
        if (!m_mesh.isEdge(tear.link)) // of panels that are gone
            return;
        const Sides atA = sides(a, tear.link);
        const Sides atB = sides(b, tear.link);
        if (!atA.leaves && !atB.leaves)
            return crumble(tear.link);
        setTorn(tear.link, 0);
        if (!atB.leaves || (atA.leaves && preference(a) >= preference(b)))
            m_parting.part(a, atA, tear.ratio);
        else
            m_parting.part(b, atB, tear.ratio);
    }

    void open(const Membrane& membrane)
    {
        const int panel = membrane.panel;
        double& hold = m_state.panelHold[std::size_t(panel)];
        hold = -hold;
        if (m_state.panelGone[std::size_t(panel)]) // with a crumb beside it
            return;
        const int threads = judge(m_system, m_state, membrane).worst.threads;
        const Vec3 pulled = directionOf(m_system, m_state, membrane, threads);
        std::optional<Way> best;
        for (const int corner : m_mesh.corners(panel))
            if (Way way = wayAt(corner, panel, pulled);
                way.sides.leaves && (!best || best->rank < way.rank))
                best = std::move(way);
        if (best)
            m_parting.part(best->corner, best->sides, hold);
        else
            crumble(membrane);
    }

private:
    // To part the mesh at a corner of a panel.
    struct Way
    {
        int corner;
        Sides sides;
        std::pair<int, double> rank; // preference, and the cosine from the pull to the panel
    };

    void setTorn(int link, std::uint8_t torn)
    {
        const LinkPlace& place = m_system.links[std::size_t(link)];
        (place.kind == LinkKind::Rod ? m_state.rodTorn
                                     : m_state.springTorn)[std::size_t(place.index)] = torn;
    }

    void crumble(int link)
    {
        for (const int panel : m_mesh.panelsBeside(link))
            m_state.panelGone[std::size_t(panel)] = 1;
    }

    // A panel that holds on to nothing lets go of what it holds.
    void crumble(const Membrane& membrane)
    {
        const Key key = m_system.panelKey[std::size_t(membrane.panel)];
        const auto torn =
            std::find_if(m_state.tears.rbegin(), m_state.tears.rend(),
                         [&](const State::Tear& tear) { return tear.element == key; });
        if (torn != m_state.tears.rend())
            torn->energy = elasticEnergyIn(m_system, m_state, membrane.panel);
        m_state.panelGone[std::size_t(membrane.panel)] = 1;
    }

    int preference(int particle) const
    {
        return m_parting.isOnTear(particle) ? 2 : m_mesh.isOnHem(particle) ? 1 : 0;
    }

    // Angles to the middles of the panels around `from`, from the direction of `along`, rad.
    std::vector<double> anglesFrom(int from, int along, const std::vector<int>& panels) const
    {
        struct Spoke
        {
            int to;
            double angle;
        };
        std::vector<Spoke> spokes{{along, 0.0}};
        const auto spoke = [&](int to) {
            const auto found = std::find_if(spokes.begin(), spokes.end(),
                                            [&](const Spoke& s) { return s.to == to; });
            return found == spokes.end() ? std::numeric_limits<double>::infinity() : found->angle;
        };
        const auto reach = [&](int to, double angle) {
            const auto found = std::find_if(spokes.begin(), spokes.end(),
                                            [&](const Spoke& s) { return s.to == to; });
            if (found == spokes.end())
                spokes.push_back({to, angle});
            else if (angle < found->angle)
                found->angle = angle;
            else
                return false;
            return true;
        };
        for (bool nearer = true; nearer;) {
            nearer = false;
            for (const int panel : panels) {
                const auto [p, q] = m_mesh.othersOf(panel, from);
                const double wide = m_mesh.angle(panel, from);
                const double toP = spoke(p), toQ = spoke(q);
                if (toP + wide < toQ)
                    nearer |= reach(q, toP + wide);
                if (toQ + wide < toP)
                    nearer |= reach(p, toQ + wide);
            }
        }
        std::vector<double> middle;
        for (const int panel : panels) {
            const auto [p, q] = m_mesh.othersOf(panel, from);
            middle.push_back(std::min(spoke(p), spoke(q)) + 0.5 * m_mesh.angle(panel, from));
        }
        return middle;
    }

    Sides sides(int from, int torn) const
    {
        constexpr double square = 0.5 * std::numbers::pi - 1e-9;
        const int along = m_mesh.otherEnd(torn, from);
        const std::vector<int> panels = m_mesh.panelsAt(from);
        const std::vector<double> angle = anglesFrom(from, along, panels);
        std::vector<std::uint8_t> isNear;
        for (std::size_t i = 0; i < panels.size(); ++i)
            isNear.push_back(m_mesh.hasCorner(panels[i], along) || angle[i] < square);
        return m_parting.sides(from, panels, isNear,
                               m_mesh.position(along) - m_mesh.position(from));
    }

    // From one direction to another, in the plane of both, as seen from the tip of `normal`.
    static double turn(const Vec3& from, const Vec3& to, const Vec3& normal)
    {
        const Vec3 axis = from.cross(to);
        const double angle = portableAngle(from.dot(to), axis.norm());
        return axis.dot(normal) < 0.0 ? -angle : angle;
    }

    // Least angles to the middles of panels, in the order of `panels`, that are reached from the
    // edge to a particle on going around `from` away from the panel `first`.
    //   angle  rad, of the edge; it grows on the way
    void fanOut(int from, int first, int edge, double angle, const std::vector<int>& panels,
                std::vector<double>& middle) const
    {
        std::vector<std::pair<int, double>> edges{{edge, angle}};
        std::vector<int> seen{first};
        for (std::size_t next = 0; next < edges.size(); ++next)
            for (std::size_t i = 0; i < panels.size(); ++i) {
                const auto [at, turned] = edges[next];
                if (!m_mesh.hasCorner(panels[i], at)
                    || std::find(seen.begin(), seen.end(), panels[i]) != seen.end())
                    continue;
                seen.push_back(panels[i]);
                const auto [p, q] = m_mesh.othersOf(panels[i], from);
                const double wide = m_mesh.angle(panels[i], from);
                middle[i] = std::min(middle[i], std::abs(turned + 0.5 * wide));
                edges.emplace_back(p == at ? q : p, turned + wide);
            }
    }

    // The panels whose middles are less than a right angle from the pull, on the side of `panel`.
    Way wayAt(int corner, int panel, Vec3 pulled) const
    {
        constexpr double pi = std::numbers::pi;
        const std::vector<int> panels = m_mesh.panelsAt(corner);
        const auto [p, q] = m_mesh.othersOf(panel, corner);
        const Vec3 toP = m_mesh.position(p) - m_mesh.position(corner);
        const Vec3 toQ = m_mesh.position(q) - m_mesh.position(corner);
        const double wide = m_mesh.angle(panel, corner);
        if (pulled.dot(toP.normalized() + toQ.normalized()) < 0.0)
            pulled = -pulled;
        double atP = turn(pulled, toP, toP.cross(toQ));
        if (atP > 0.5 * pi) // the other way around, as the middle is less than that from the pull
            atP -= 2.0 * pi;
        std::vector<double> middle(panels.size(), std::numeric_limits<double>::infinity());
        fanOut(corner, panel, q, atP + wide, panels, middle);
        fanOut(corner, panel, p, -atP, panels, middle);
        constexpr double square = 0.5 * pi - 1e-9;
        std::vector<std::uint8_t> isNear;
        for (std::size_t i = 0; i < panels.size(); ++i)
            isNear.push_back(panels[i] == panel || middle[i] < square);
        const Vec3 toMiddle = toP.normalized() + toQ.normalized();
        return {corner,
                m_parting.sides(corner, panels, isNear, pulled),
                {preference(corner), pulled.dot(toMiddle.normalized())}};
    }

    const System& m_system;
    State& m_state;
    MeshParting m_parting;
    const FabricMesh& m_mesh; // of m_parting
};

} // namespace

bool openTears(const System& system, State& state)
{
    const auto isPending = [&](const TearHold& hold) {
        return isTorn(system.links[std::size_t(hold.link)], state);
    };
    const auto hasYetToOpen = [](double hold) { return hold < 0.0; };
    const std::size_t before = state.splits.size();
    if (std::ranges::none_of(state.tearHolds, isPending)
        && std::ranges::none_of(state.panelHold, hasYetToOpen))
        return false;
    Opening opening(system, state);
    const std::vector<TearHold> holds = state.tearHolds;
    for (const TearHold& hold : holds)
        if (isPending(hold))
            opening.open(hold);
    for (const Membrane& membrane : system.membranes)
        if (hasYetToOpen(state.panelHold[std::size_t(membrane.panel)]))
            opening.open(membrane);
    return state.splits.size() > before;
}

} // namespace ripstop
