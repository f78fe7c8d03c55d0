// Opens the mesh at each link that has torn and waits in State::tearHolds.
//
// openTears() works on a copy of the list, as parting adds to it. Opening::open() passes over links
// whose panels are gone and divides the panels at both ends of the others by their angles from the
// link. Where nothing would stay behind at either end, the panels beside the link go. Otherwise the
// link is whole again, and the mesh parts at the end where something stays behind, or of two such
// ends at the one that preference() ranks higher. anglesFrom() sums the angles of panels outwards
// from the link until none becomes smaller; panels that it does not reach stay.
#include "tearing/tear_opening.h"

#include "tearing/mesh_parting.h"

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

private:
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
    const std::size_t before = state.splits.size();
    if (std::none_of(state.tearHolds.begin(), state.tearHolds.end(), isPending))
        return false;
    Opening opening(system, state);
    const std::vector<TearHold> holds = state.tearHolds;
    for (const TearHold& hold : holds)
        if (isPending(hold))
            opening.open(hold);
    return state.splits.size() > before;
}

} // namespace ripstop
