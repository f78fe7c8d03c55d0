// Lines that go on: loop() of select.h. Walker marks links from the selected ones in both
// directions; at a particle it goes on along the edge of fabric, else to the only other link of
// the material, else to the straightest within 40 degrees. The marked links then become links or
// particles, as the selection has them.
#include "select/net.h"
#include "select/select.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

const double straightest = std::cos(40.0 * std::numbers::pi / 180.0);

class Walker
{
public:
    explicit Walker(const Net& net)
        : m_net(net)
        , m_linksAt(linksOfParticles(net))
        , m_edge(sidesOf(net))
        , m_walked(net.ends.size(), 0)
    {
        std::erase_if(m_edge, [](const NetSide& side) { return side.panels > 1; });
        m_onEdge.assign(net.all.particles.size(), 0);
        for (const NetSide& side : m_edge)
            m_onEdge[std::size_t(side.low)] = m_onEdge[std::size_t(side.high)] = 1;
    }

    // Marks the link and what it goes on into at both ends.
    void walkFrom(int link)
    {
        if (!m_net.isWhole(m_net.ends[std::size_t(link)]) || m_walked[std::size_t(link)])
            return;
        m_walked[std::size_t(link)] = 1;
        for (const int end : m_net.ends[std::size_t(link)])
            walk(link, end);
    }

    // A link that a particle alone stands for; -1 where lines meet.
    int lineThrough(int particle) const
    {
        int found = -1;
        for (const int link : m_linksAt[particle])
            if (isOnEdge(link))
                return link;
            else
                found = link;
        return m_linksAt[particle].size() <= 2 ? found : -1;
    }

    const std::vector<char>& walked() const { return m_walked; }

private:
    void walk(int link, int particle)
    {
        for (;;) {
            const int next = after(link, particle);
            if (next < 0 || m_walked[std::size_t(next)])
                return;
            m_walked[std::size_t(next)] = 1;
            const auto& ends = m_net.ends[std::size_t(next)];
            particle = ends[0] == particle ? ends[1] : ends[0];
            link = next;
        }
    }

    // The link that goes on at a particle, -1 when none does.
    int after(int link, int particle) const
    {
        std::vector<int> others; // of the same material
        int edge = -1;
        int edges = 0;
        const Id material = m_net.all.links[std::size_t(link)]->material;
        for (const int other : m_linksAt[particle]) {
            if (other == link)
                continue;
            if (isOnEdge(other)) {
                edge = other;
                ++edges;
            }
            if (m_net.all.links[std::size_t(other)]->material == material)
                others.push_back(other);
        }
        if (isOnEdge(link))
            return edges == 1 ? edge : -1;
        if (others.size() == 1)
            return others.front();
        return straightOn(link, particle, others);
    }

    int straightOn(int link, int particle, const std::vector<int>& others) const
    {
        int best = -1;
        double most = straightest;
        for (const int other : others)
            if (const double cosine = -wayFrom(particle, link).dot(wayFrom(particle, other));
                cosine > most) {
                most = cosine;
                best = other;
            }
        return best;
    }

    Vec3 wayFrom(int particle, int link) const // unit
    {
        const auto& ends = m_net.ends[std::size_t(link)];
        const int other = ends[0] == particle ? ends[1] : ends[0];
        return (m_net.all.particles[std::size_t(other)]->position
                - m_net.all.particles[std::size_t(particle)]->position)
            .normalized();
    }

    bool isOnEdge(int link) const
    {
        const auto [low, high] =
            std::minmax(m_net.ends[std::size_t(link)][0], m_net.ends[std::size_t(link)][1]);
        return m_onEdge[std::size_t(low)] && m_onEdge[std::size_t(high)]
               && std::ranges::binary_search(
                   m_edge, std::pair(low, high), {},
                   [](const NetSide& side) { return std::pair(side.low, side.high); });
    }

    const Net& m_net;
    Lists m_linksAt;
    std::vector<NetSide> m_edge; // of the fabric
    std::vector<char> m_onEdge;  // [particles]
    std::vector<char> m_walked;  // [links]
};

} // namespace

std::vector<Id> loop(const Scene& scene, const std::vector<Id>& selected)
{
    const Net net(scene);
    Marks marks(net, scene, selected);
    const auto particles = std::ranges::count(marks.particles, 1);
    const bool hasLinks = std::ranges::find(marks.links, 1) != marks.links.end();

    Walker walker(net);
    bool joined = false; // two of the selected particles by a link
    for (std::size_t i = 0; i < net.ends.size(); ++i) {
        const auto& ends = net.ends[i];
        const bool between = net.isWhole(ends) && marks.particles[std::size_t(ends[0])]
                             && marks.particles[std::size_t(ends[1])];
        joined |= between;
        if (marks.links[i] || between)
            walker.walkFrom(int(i));
    }
    for (std::size_t i = 0; !joined && i < marks.particles.size(); ++i)
        if (marks.particles[i])
            if (const int line = walker.lineThrough(int(i)); line >= 0)
                walker.walkFrom(line);

    for (std::size_t i = 0; i < net.ends.size(); ++i) {
        if (!walker.walked()[i])
            continue;
        if (hasLinks)
            marks.links[i] = 1;
        if (particles > 0)
            for (const int end : net.ends[i])
                marks.particles[std::size_t(end)] = 1;
    }
    return marks.ids(net);
}

} // namespace ripstop
