#include "sim/tear_opening.h"

#include "sim/fabric_mesh.h"
#include "sim/split_system.h"
#include "sim/spring_force.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace ripstop {
namespace {

// What goes with the twin of a particle, and what stays.
struct Sides
{
    std::vector<int> nearPanels;
    std::vector<int> nearLinks;              // without those that are cut
    std::vector<std::pair<int, double>> cut; // links and the share of the twin
    double share = 0.5;                      // of the mass, of the twin
    bool leaves = false;                     // something behind
};

class Opening
{
public:
    Opening(const System& system, State& state)
        : m_system(system)
        , m_state(state)
        , m_mesh(system, state)
        , m_pending(system.links.size(), 0)
        , m_isOnTear(system.key.size(), 0)
        , m_isHeld(system.key.size(), 0)
    {
        for (const TearHold& hold : state.tearHolds)
            m_pending[std::size_t(hold.link)] = 1;
        for (std::size_t i = 0; i < system.key.size(); ++i)
            m_isHeld[i] = system.inverseMass[i] == 0.0;
        for (const Input& input : system.inputs)
            if (input.kind == ControlKind::Move)
                for (const int target : input.targets)
                    m_isHeld[std::size_t(target)] = 1;
        for (std::size_t l = 0; l < system.links.size(); ++l)
            if (system.links[l].key >= firstTwinLink)
                m_isOnTear[std::size_t(system.links[l].a)] =
                    m_isOnTear[std::size_t(system.links[l].b)] = 1;
        for (std::size_t i = 0; i < system.key.size(); ++i)
            if (system.key[i] >= firstTwinParticle)
                m_isOnTear[i] = 1;
        for (const Split& split : state.splits)
            m_cuts += split.cut.size();
    }

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
            part(a, atA, tear);
        else
            part(b, atB, tear);
    }

private:
    bool isTorn(int link) const
    {
        return link < int(m_system.links.size())
               && ripstop::isTorn(m_system.links[std::size_t(link)], m_state);
    }

    bool isDead(int link) const { return isTorn(link) && !m_pending[std::size_t(link)]; }

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
        return m_isOnTear[std::size_t(particle)] ? 2 : m_mesh.isOnHem(particle) ? 1 : 0;
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

    // Whether a link that is no edge at `from` is on the side of the twin.
    bool goesAlong(int from, int to, const Vec3& direction, const std::vector<int>& panels,
                   const std::vector<std::uint8_t>& isNear) const
    {
        for (std::size_t i = 0; i < panels.size(); ++i) {
            const auto [p, q] = m_mesh.othersOf(panels[i], from);
            for (const int beyond : m_mesh.panelsAt(to))
                if (m_mesh.hasCorner(beyond, p) && m_mesh.hasCorner(beyond, q))
                    return isNear[i];
        }
        return (m_mesh.position(to) - m_mesh.position(from)).dot(direction) > 0.0;
    }

    Sides sides(int from, int torn) const
    {
        constexpr double square = 0.5 * std::numbers::pi - 1e-9;
        const int along = m_mesh.otherEnd(torn, from);
        const std::vector<int> panels = m_mesh.panelsAt(from);
        const std::vector<double> angle = anglesFrom(from, along, panels);
        Sides sides;
        std::vector<std::uint8_t> isNear;
        double nearArea = 0.0, area = 0.0;
        for (std::size_t i = 0; i < panels.size(); ++i) {
            isNear.push_back(m_mesh.hasCorner(panels[i], along) || angle[i] < square);
            area += m_mesh.area(panels[i]);
            if (isNear.back()) {
                sides.nearPanels.push_back(panels[i]);
                nearArea += m_mesh.area(panels[i]);
            }
        }
        const bool staysPanel = sides.nearPanels.size() < panels.size();
        sides.leaves = staysPanel || m_isHeld[std::size_t(from)];

        const Vec3 direction = m_mesh.position(along) - m_mesh.position(from);
        for (const int link : m_mesh.linksAt(from)) {
            if (isDead(link))
                continue;
            const int to = m_mesh.otherEnd(link, from);
            double near = 0.0, far = 0.0;
            for (std::size_t i = 0; i < panels.size(); ++i)
                if (m_mesh.hasCorner(panels[i], to))
                    ++(isNear[i] ? near : far);
            if (near > 0.0 && far > 0.0)
                sides.cut.emplace_back(link, near / (near + far));
            else if (near > 0.0 || (far == 0.0 && goesAlong(from, to, direction, panels, isNear)))
                sides.nearLinks.push_back(link);
            else if (far == 0.0 && m_mesh.nearness(from, to) == 0)
                sides.leaves = true; // a line
        }

        const auto count = double(panels.size());
        const double mean = area > 0.0 ? area / count : 1.0;
        if (!(area > 0.0)) {
            nearArea = double(sides.nearPanels.size());
            area = count;
        }
        sides.share = staysPanel ? nearArea / area : area / (area + mean);
        // slivers on one side
        sides.share = std::clamp(sides.share, 1e-3, 1.0 - 1e-3);
        return sides;
    }

    struct Across
    {
        int link;
        int nearness;
    };

    // Links that are no edges but join particles around `particle` whose panels are neighbours.
    std::vector<Across> linksAcross(int particle) const
    {
        std::vector<int> around;
        for (const int panel : m_mesh.panelsAt(particle))
            for (const int corner : m_mesh.corners(panel))
                around.push_back(corner);
        std::vector<int> links;
        for (const int corner : around)
            for (const int link : m_mesh.linksAt(corner))
                if (!isTorn(link) && !m_mesh.isEdge(link))
                    links.push_back(link);
        std::sort(links.begin(), links.end());
        links.erase(std::unique(links.begin(), links.end()), links.end());
        std::vector<Across> across;
        for (const int link : links) {
            const auto [a, b] = m_mesh.ends(link);
            if (const int nearness = m_mesh.nearness(a, b); nearness > 0)
                across.push_back({link, nearness});
        }
        return across;
    }

    void part(int from, const Sides& sides, const TearHold& tear)
    {
        const std::vector<Across> across = linksAcross(from);
        Split split;
        split.from = m_mesh.key(from);
        split.twin = firstTwinParticle + Key(m_state.splits.size());
        split.share = sides.share;
        const std::vector<int> incident = m_mesh.linksAt(from);
        const int twin = m_mesh.addTwin(from, split.twin);
        m_isOnTear.push_back(1);
        m_isHeld.push_back(0);
        m_isOnTear[std::size_t(from)] = 1;
        for (const int panel : sides.nearPanels) {
            split.panels.push_back(m_system.panelKey[std::size_t(panel)]);
            m_mesh.moveCorner(panel, from, twin);
        }
        for (const int link : sides.nearLinks) {
            split.links.push_back(m_mesh.linkKey(link));
            m_mesh.moveEnd(link, from, twin);
        }
        for (const auto& [link, share] : sides.cut) {
            const Key key = firstTwinLink + Key(m_cuts++);
            split.cut.push_back({m_mesh.linkKey(link), key, share});
            m_mesh.addTwinLink(link, from, twin, key);
            m_isOnTear[std::size_t(m_mesh.otherEnd(link, from))] = 1;
        }
        m_state.splits.push_back(std::move(split));
        for (const int link : incident)
            hold(link, tear.ratio);
        for (const Across& one : across) {
            const auto [a, b] = m_mesh.ends(one.link);
            if (m_mesh.nearness(a, b) < one.nearness)
                breakAcross(one.link);
        }
    }

    void hold(int link, double ratio)
    {
        auto& holds = m_state.tearHolds;
        if (link < int(m_system.links.size()) && !isTorn(link)
            && std::none_of(holds.begin(), holds.end(),
                            [&](const TearHold& held) { return held.link == link; }))
            holds.push_back({link, ratio});
    }

    void breakAcross(int link)
    {
        if (link >= int(m_system.links.size()))
            return;
        const LinkPlace& place = m_system.links[std::size_t(link)];
        const auto index = std::size_t(place.index);
        const Vec3 apart = m_mesh.position(place.b) - m_mesh.position(place.a);
        State::Tear tear{m_state.time, m_mesh.sceneLink(link),
                         apart.norm(), 0.0,
                         0.0,          0.5 * (m_mesh.position(place.a) + m_mesh.position(place.b))};
        double rest = 0.0;
        if (place.kind == LinkKind::Rod) {
            rest = m_system.rods[index].restLength;
            tear.force = m_state.rodTension[index];
            tear.energy = 0.5 * tear.force * tear.force * m_system.rods[index].compliance;
            m_state.rodTension[index] = 0.0;
        } else {
            const Spring& spring = m_system.springs[index];
            rest = spring.restLength;
            tear.force = springTension(spring, apart,
                                       m_state.velocity[std::size_t(place.b)]
                                           - m_state.velocity[std::size_t(place.a)]);
            tear.energy = elasticEnergy(spring.stiffness, spring.resists, tear.length - rest);
        }
        tear.strain = rest > 0.0 ? tear.length / rest - 1.0 : 0.0;
        setTorn(link, 1);
        m_state.tears.push_back(tear);
    }

    const System& m_system;
    State& m_state;
    FabricMesh m_mesh;
    std::vector<std::uint8_t> m_pending;  // [links] has let go and waits, or is held
    std::vector<std::uint8_t> m_isOnTear; // [particles] and twins
    std::vector<std::uint8_t> m_isHeld;   // [particles] and twins
    std::size_t m_cuts = 0;               // so far
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
