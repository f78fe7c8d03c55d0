// Lines that go on: loop() of select.h. Walker marks links from the selected ones in both
// directions; at a particle it goes on along the edge of fabric, else to the only other link of
// the material, else to the straightest within 40 degrees. The marked links then become links or
// particles, as the selection has them. Rim does the same for particles of an edge of fabric, along
// which there need not be any links.
#include "select/net.h"
#include "select/select.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

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

// The edge of the fabric as particles, each tied to the next by the side of one panel.
class Rim
{
public:
    explicit Rim(const Net& net)
        : m_net(net)
        , m_nextTo(net.all.particles.size())
        , m_walked(net.all.particles.size(), 0)
    {
        for (const NetSide& side : sidesOf(net))
            if (side.panels == 1) {
                m_nextTo[std::size_t(side.low)].push_back(side.high);
                m_nextTo[std::size_t(side.high)].push_back(side.low);
            }
    }

    bool has(int particle) const { return !nextTo(particle).empty(); }
    bool joins(int a, int b) const { return std::ranges::count(nextTo(a), b) > 0; }

    // Marks what the edge goes on into, all ways, as far as it does not branch.
    void walkFrom(int particle)
    {
        m_walked[std::size_t(particle)] = 1;
        for (const int first : nextTo(particle)) {
            int before = particle;
            int at = first;
            while (!m_walked[std::size_t(at)]) {
                m_walked[std::size_t(at)] = 1;
                if (nextTo(at).size() != 2)
                    break;
                before = std::exchange(at, nextTo(at)[nextTo(at)[0] == before ? 1 : 0]);
            }
        }
    }

    // Marks the shortest way from one to the other (Dijkstra 1959). Nothing when they are on edges
    // that do not meet.
    void walkBetween(int from, int to)
    {
        std::vector<double> length(m_nextTo.size(), std::numeric_limits<double>::infinity());
        std::vector<int> before(m_nextTo.size(), -1);
        using Reached = std::pair<double, int>; // m, particle
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
        length[std::size_t(from)] = 0.0;
        for (queue.emplace(0.0, from); !queue.empty() && queue.top().second != to;) {
            const auto [way, at] = queue.top();
            queue.pop();
            if (way > length[std::size_t(at)])
                continue;
            for (const int next : nextTo(at))
                if (const double more = way + (place(next) - place(at)).norm();
                    more < length[std::size_t(next)]) {
                    length[std::size_t(next)] = more;
                    before[std::size_t(next)] = at;
                    queue.emplace(more, next);
                }
        }
        if (before[std::size_t(to)] < 0)
            return;
        for (int at = to; at >= 0; at = before[std::size_t(at)])
            m_walked[std::size_t(at)] = 1;
    }

    const std::vector<char>& walked() const { return m_walked; } // [particles]

private:
    const std::vector<int>& nextTo(int particle) const { return m_nextTo[std::size_t(particle)]; }
    const Vec3& place(int particle) const
    {
        return m_net.all.particles[std::size_t(particle)]->position;
    }

    const Net& m_net;
    std::vector<std::vector<int>> m_nextTo; // [particles]
    std::vector<char> m_walked;             // [particles]
};

std::vector<int> numbersOf(const std::vector<char>& marks)
{
    std::vector<int> numbers;
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (marks[i])
            numbers.push_back(int(i));
    return numbers;
}

// Follows the edge of fabric from particles on it: from two of them that are not neighbours the
// stretch between them, else on from each. Answers false where it is for links to say, as between
// two neighbours across the fabric.
bool followRim(Rim& rim, const std::vector<int>& particles)
{
    if (particles.empty() || !std::ranges::all_of(particles, [&](int at) { return rim.has(at); }))
        return false;
    if (particles.size() == 2 && !rim.joins(particles[0], particles[1]))
        rim.walkBetween(particles[0], particles[1]);
    else
        for (const int particle : particles)
            rim.walkFrom(particle);
    return true;
}

} // namespace

std::vector<Id> loop(const Scene& scene, const std::vector<Id>& selected)
{
    const Net net(scene);
    Marks marks(net, scene, selected);
    const auto particles = std::ranges::count(marks.particles, 1);
    const bool hasLinks = std::ranges::find(marks.links, 1) != marks.links.end();

    Rim rim(net);
    bool joinedAcross = false; // two of the selected particles, by a link within the fabric
    for (const auto& ends : net.ends)
        joinedAcross |= net.isWhole(ends) && marks.particles[std::size_t(ends[0])]
                        && marks.particles[std::size_t(ends[1])] && !rim.joins(ends[0], ends[1]);
    if (!hasLinks && !joinedAcross && followRim(rim, numbersOf(marks.particles))) {
        for (const int particle : numbersOf(rim.walked()))
            marks.particles[std::size_t(particle)] = 1;
        return marks.ids(net);
    }

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
