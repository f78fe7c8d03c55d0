// Parts the mesh at a particle in two stages, after the constructor has found what is held and what
// lies on earlier tears:
//
// 1. sides() divides what ends there and changes nothing. Panels go as the caller says, an edge
//    with panels on both sides is cut, an edge of one side goes with it, and goesAlong() decides
//    for other links. It also finds the share of the mass, and whether something stays behind.
// 2. part() makes the twin, moves panels and links, doubles those that are cut, and notes the
//    Split. It asks linksAcross() before that, since only a comparison with afterwards tells which
//    links near the opening have lost their neighbours and break.
#include "tearing/mesh_parting.h"

#include "base/key_index.h"
#include "tearing/panel_tearing.h"
#include "tearing/tearing.h"

#include <algorithm>

namespace ripstop {

MeshParting::MeshParting(const System& system, State& state)
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
    if (!system.membranes.empty())
        markTips();
}

// Fabric that panels carry has no links along a tear to tell where it ends: there, a panel of
// either lip has the particle as a corner.
void MeshParting::markTips()
{
    KeyIndex particleOf(m_system.key.size());
    for (std::size_t i = 0; i < m_system.key.size(); ++i)
        particleOf.add(m_system.key[i], int(i));
    for (const Split& split : m_state.splits)
        if (const int from = particleOf(split.from), twin = particleOf(split.twin);
            from >= 0 && twin >= 0)
            markTips(from, twin);
}

void MeshParting::markTips(int from, int twin)
{
    m_isOnTear[std::size_t(from)] = 1;
    for (const int ofTwin : m_mesh.panelsAt(twin))
        for (const int corner : m_mesh.corners(ofTwin))
            for (const int panel : m_mesh.panelsAt(from))
                if (m_mesh.hasCorner(panel, corner))
                    m_isOnTear[std::size_t(corner)] = 1;
}

bool MeshParting::isTorn(int link) const
{
    return link < int(m_system.links.size())
           && ripstop::isTorn(m_system.links[std::size_t(link)], m_state);
}

// Whether a link that is no edge at `from` is on the side of the twin.
bool MeshParting::goesAlong(int from, int to, const Vec3& direction, const std::vector<int>& panels,
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

Sides MeshParting::sides(int from, const std::vector<int>& panels,
                         const std::vector<std::uint8_t>& isNear, const Vec3& direction) const
{
    Sides sides;
    double nearArea = 0.0, area = 0.0;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        area += m_mesh.area(panels[i]);
        if (isNear[i]) {
            sides.nearPanels.push_back(panels[i]);
            nearArea += m_mesh.area(panels[i]);
        }
    }
    const bool staysPanel = sides.nearPanels.size() < panels.size();
    sides.leaves = staysPanel || m_isHeld[std::size_t(from)];

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

// Links that are no edges but join particles around `particle` whose panels are neighbours.
std::vector<MeshParting::Across> MeshParting::linksAcross(int particle) const
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

void MeshParting::part(int from, const Sides& sides, std::optional<double> heldRatio)
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
    if (heldRatio) {
        for (const int link : incident)
            hold(link, *heldRatio);
        for (const int end : {from, twin})
            for (const int panel : m_mesh.panelsAt(end))
                holdPanel(panel, *heldRatio);
    }
    if (!m_system.membranes.empty())
        markTips(from, twin);
    for (const Across& one : across) {
        const auto [a, b] = m_mesh.ends(one.link);
        if (m_mesh.nearness(a, b) < one.nearness && one.link < int(m_system.links.size()))
            breakLink(m_system, m_state, one.link);
    }
}

void MeshParting::hold(int link, double ratio)
{
    auto& holds = m_state.tearHolds;
    if (link < int(m_system.links.size()) && !isTorn(link)
        && std::none_of(holds.begin(), holds.end(),
                        [&](const TearHold& held) { return held.link == link; }))
        holds.push_back({link, ratio});
}

void MeshParting::holdPanel(int panel, double ratio)
{
    double& held = m_state.panelHold[std::size_t(panel)];
    if (held == 0.0 && membraneOf(m_system, panel))
        held = ratio;
}

} // namespace ripstop
