// Keeps the changes of the mesh beside a system that itself stays as it is.
//
// Questions look first at what has changed (m_panelsAt, m_linksAt, m_corners, m_ends) and then at
// the system. Numbers beyond the counts of the system are twins and their links; origin() leads a
// twin back to the particle of the system, whose position it still has. The last four functions
// make the changes: addTwin() enters empty lists for a new particle, and moveCorner(), moveEnd()
// and addTwinLink() fill them. They append, so the lists stay in ascending order only as callers
// move panels and links in that order.
#include "tearing/fabric_mesh.h"

#include "base/portable_math.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {

FabricMesh::FabricMesh(const System& system, const State& state)
    : m_system(system)
    , m_state(state)
    , m_origins(state.splits)
{}

int FabricMesh::origin(int particle) const
{
    while (particle >= int(m_system.key.size()))
        particle = m_twins[std::size_t(particle) - m_system.key.size()].first;
    return particle;
}

Key FabricMesh::key(int particle) const
{
    const auto i = std::size_t(particle);
    const std::size_t count = m_system.key.size();
    return i < count ? m_system.key[i] : m_twins[i - count].second;
}

Key FabricMesh::linkKey(int link) const
{
    const auto i = std::size_t(link);
    const std::size_t count = m_system.links.size();
    return i < count ? m_system.links[i].key : m_twinLinks[i - count].second;
}

const Vec3& FabricMesh::position(int particle) const
{
    return m_state.position[std::size_t(origin(particle))];
}

std::vector<int> FabricMesh::panelsAt(int particle) const
{
    std::vector<int> panels;
    if (const auto changed = m_panelsAt.find(particle); changed != m_panelsAt.end()) {
        panels = changed->second;
    } else if (particle < int(m_system.key.size())) {
        const Rows& rows = m_system.panelsAt;
        panels.assign(rows.items.begin() + rows.start[std::size_t(particle)],
                      rows.items.begin() + rows.start[std::size_t(particle) + 1]);
    }
    std::erase_if(panels, [&](int panel) { return m_state.panelGone[std::size_t(panel)] != 0; });
    return panels;
}

std::vector<int> FabricMesh::linksAt(int particle) const
{
    if (const auto changed = m_linksAt.find(particle); changed != m_linksAt.end())
        return changed->second;
    std::vector<int> links;
    if (particle >= int(m_system.key.size()))
        return links;
    const auto add = [&](const Rows& rows, const std::vector<int>& link) {
        const auto p = std::size_t(particle);
        for (int k = rows.start[p]; k < rows.start[p + 1]; ++k)
            links.push_back(link[std::size_t(rows.items[std::size_t(k)])]);
    };
    add(m_system.springsAt, m_system.springLink);
    add(m_system.rodsAt, m_system.rodLink);
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
    return links;
}

std::vector<int> FabricMesh::panelsBeside(int link) const
{
    const auto [a, b] = ends(link);
    std::vector<int> panels = panelsAt(a);
    std::erase_if(panels, [&, other = b](int panel) { return !hasCorner(panel, other); });
    return panels;
}

bool FabricMesh::isOnHem(int particle) const
{
    const std::vector<int> panels = panelsAt(particle);
    const auto isHem = [&](int to) {
        return std::count_if(panels.begin(), panels.end(),
                             [&](int panel) { return hasCorner(panel, to); })
               == 1;
    };
    return std::any_of(panels.begin(), panels.end(), [&](int panel) {
        const auto [p, q] = othersOf(panel, particle);
        return isHem(p) || isHem(q);
    });
}

const std::array<int, 3>& FabricMesh::corners(int panel) const
{
    const auto changed = m_corners.find(panel);
    return changed == m_corners.end() ? m_system.panels[std::size_t(panel)].corner
                                      : changed->second;
}

bool FabricMesh::hasCorner(int panel, int particle) const
{
    const auto& corner = corners(panel);
    return corner[0] == particle || corner[1] == particle || corner[2] == particle;
}

std::pair<int, int> FabricMesh::othersOf(int panel, int corner) const
{
    const auto& c = corners(panel);
    return c[0] == corner ? std::pair(c[1], c[2]) : std::pair(c[0], c[1] == corner ? c[2] : c[1]);
}

double FabricMesh::angle(int panel, int corner) const
{
    const auto [p, q] = othersOf(panel, corner);
    const Vec3 toP = position(p) - position(corner);
    const Vec3 toQ = position(q) - position(corner);
    return portableAngle(toP.dot(toQ), toP.cross(toQ).norm());
}

double FabricMesh::area(int panel) const
{
    const auto& c = corners(panel);
    const auto start = [&](int k) -> const Vec3& {
        return m_system.start.position[std::size_t(origin(c[std::size_t(k)]))];
    };
    return 0.5 * (start(1) - start(0)).cross(start(2) - start(0)).norm();
}

std::pair<int, int> FabricMesh::ends(int link) const
{
    const auto i = std::size_t(link);
    const std::size_t count = m_system.links.size();
    if (i >= count)
        return m_twinLinks[i - count].first;
    const auto changed = m_ends.find(link);
    return changed == m_ends.end() ? std::pair(m_system.links[i].a, m_system.links[i].b)
                                   : changed->second;
}

int FabricMesh::otherEnd(int link, int particle) const
{
    const auto [a, b] = ends(link);
    return a == particle ? b : a;
}

int FabricMesh::nearness(int one, int other) const
{
    int most = 0;
    const std::vector<int> others = panelsAt(other);
    for (const int panel : panelsAt(one))
        for (const int beyond : others) {
            int shared = 0;
            for (const int corner : corners(panel))
                shared += hasCorner(beyond, corner);
            most = std::max(most, shared);
        }
    return most;
}

int FabricMesh::addTwin(int particle, Key key)
{
    m_twins.emplace_back(particle, key);
    const int twin = int(m_system.key.size() + m_twins.size()) - 1;
    m_panelsAt[twin];
    m_linksAt[twin];
    return twin;
}

void FabricMesh::moveCorner(int panel, int from, int to)
{
    std::array<int, 3> corner = corners(panel);
    std::replace(corner.begin(), corner.end(), from, to);
    std::vector<int> left = panelsAt(from);
    std::erase(left, panel);
    m_panelsAt[from] = std::move(left);
    m_panelsAt[to].push_back(panel); // in ascending order
    m_corners[panel] = corner;
}

void FabricMesh::moveEnd(int link, int from, int to)
{
    auto [a, b] = ends(link);
    (a == from ? a : b) = to;
    std::vector<int> left = linksAt(from);
    std::erase(left, link);
    m_linksAt[from] = std::move(left);
    m_linksAt[to].push_back(link);
    if (std::size_t(link) < m_system.links.size())
        m_ends[link] = {a, b};
    else
        m_twinLinks[std::size_t(link) - m_system.links.size()].first = {a, b};
}

int FabricMesh::addTwinLink(int link, int from, int to, Key key)
{
    auto [a, b] = ends(link);
    const int other = a == from ? b : a;
    (a == from ? a : b) = to;
    m_twinLinks.push_back({{a, b}, key});
    const int twin = int(m_system.links.size() + m_twinLinks.size()) - 1;
    for (const int end : {to, other}) {
        std::vector<int> links = linksAt(end);
        links.push_back(twin);
        m_linksAt[end] = std::move(links);
    }
    return twin;
}

} // namespace ripstop
