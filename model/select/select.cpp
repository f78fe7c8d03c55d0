// Selections from selections, each on a Net and marks by row (net.h): growing and shrinking move
// the edge by one ring, connected() joins particles into sets and takes those of the seeds, the
// boundary is the sides with one panel, and turnedInto() goes over particles. loop() and similar()
// stand in sources of their own.
#include "select/select.h"

#include "base/joined_sets.h"
#include "select/net.h"

#include <algorithm>

namespace ripstop {
namespace {

// The particles that sides of panels join to some particles.
class Rings
{
public:
    // Collects them for the ends of `links`.
    Rings(const Net& net, const std::vector<std::size_t>& links)
        : m_place(net.all.particles.size(), -1)
    {
        for (const std::size_t link : links)
            for (const int end : net.ends[link])
                if (int& place = m_place[std::size_t(end)]; place < 0) {
                    place = int(m_rings.size());
                    m_rings.emplace_back();
                }
        for (const auto& corners : net.corners)
            for (const int corner : corners)
                if (net.isWhole(corners) && m_place[std::size_t(corner)] >= 0)
                    for (const int other : corners)
                        if (other != corner)
                            m_rings[std::size_t(m_place[std::size_t(corner)])].push_back(other);
    }

    // True when a third particle is beside both.
    bool meet(const std::array<int, 2>& ends) const
    {
        const auto& a = m_rings[std::size_t(m_place[std::size_t(ends[0])])];
        const auto& b = m_rings[std::size_t(m_place[std::size_t(ends[1])])];
        return std::ranges::any_of(
            a, [&](int other) { return std::ranges::find(b, other) != b.end(); });
    }

private:
    std::vector<int> m_place; // [particles] in m_rings, or -1
    std::vector<std::vector<int>> m_rings;
};

// Sets the mark of all particles that have a neighbour marked otherwise.
void moveParticles(const Net& net, const std::vector<char>& before, char to,
                   std::vector<char>& after)
{
    const auto differ = [&](std::span<const int> row) {
        return net.isWhole(row) && std::ranges::any_of(row, [&](int particle) {
                   return before[std::size_t(particle)] != before[std::size_t(row[0])];
               });
    };
    const auto set = [&](std::span<const int> row) {
        for (const int particle : row)
            after[std::size_t(particle)] = to;
    };
    for (const auto& corners : net.corners)
        if (differ(corners))
            set(corners);
    std::vector<std::size_t> leaving; // links out of the selection
    for (std::size_t i = 0; i < net.ends.size(); ++i)
        if (differ(net.ends[i]))
            leaving.push_back(i);
    if (leaving.empty())
        return;
    const Rings rings(net, leaving);
    for (const std::size_t link : leaving)
        if (!rings.meet(net.ends[link]))
            set(net.ends[link]);
}

// The particles of the marked rows.
template <typename Ends>
std::vector<char> touched(const Net& net, const std::vector<Ends>& rows,
                          const std::vector<char>& marks, bool marked)
{
    std::vector<char> particles(net.all.particles.size(), 0);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (bool(marks[i]) == marked && net.isWhole(rows[i]))
            for (const int particle : rows[i])
                particles[std::size_t(particle)] = 1;
    return particles;
}

template <typename Ends>
void setWhereTouched(const Net& net, const std::vector<Ends>& rows,
                     const std::vector<char>& particles, char to, std::vector<char>& marks)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (net.isWhole(rows[i]) && std::ranges::any_of(rows[i], [&](int particle) {
                return particles[std::size_t(particle)] != 0;
            }))
            marks[i] = to;
}

// Moves the edge of the selection by one ring: outwards (to = 1) or inwards (to = 0).
std::vector<Id> moved(const Scene& scene, const std::vector<Id>& selected, char to)
{
    const Net net(scene);
    const Marks before(net, scene, selected);
    Marks after = before;
    const auto has = [](const std::vector<char>& marks) {
        return std::ranges::find(marks, 1) != marks.end();
    };
    if (has(before.particles))
        moveParticles(net, before.particles, to, after.particles);
    if (has(before.links))
        setWhereTouched(net, net.ends, touched(net, net.ends, before.links, to != 0), to,
                        after.links);
    if (has(before.panels))
        setWhereTouched(net, net.corners, touched(net, net.corners, before.panels, to != 0), to,
                        after.panels);
    return after.ids(net);
}

} // namespace

std::vector<Id> grown(const Scene& scene, const std::vector<Id>& selected)
{
    return moved(scene, selected, 1);
}

std::vector<Id> shrunk(const Scene& scene, const std::vector<Id>& selected)
{
    return moved(scene, selected, 0);
}

std::vector<Id> connected(const Scene& scene, const std::vector<Id>& selected)
{
    const Net net(scene);
    const Marks seeds(net, scene, selected);
    JoinedSets sets(net.all.particles.size());
    for (const auto& ends : net.ends)
        if (net.isWhole(ends))
            sets.join(ends[0], ends[1]);
    for (const auto& corners : net.corners)
        if (net.isWhole(corners)) {
            sets.join(corners[0], corners[1]);
            sets.join(corners[0], corners[2]);
        }

    std::vector<char> wanted(net.all.particles.size(), 0); // by the particle that stands for a set
    const auto want = [&](const auto& particles) {
        if (net.isWhole(particles))
            wanted[std::size_t(sets.of(particles[0]))] = 1;
    };
    for (std::size_t i = 0; i < seeds.particles.size(); ++i)
        if (seeds.particles[i])
            want(std::array{int(i)});
    for (std::size_t i = 0; i < net.ends.size(); ++i)
        if (seeds.links[i])
            want(net.ends[i]);
    for (std::size_t i = 0; i < net.corners.size(); ++i)
        if (seeds.panels[i])
            want(net.corners[i]);

    Marks tied = seeds;
    const auto isWanted = [&](int particle) {
        return char(particle >= 0 && wanted[std::size_t(sets.of(particle))]);
    };
    for (std::size_t i = 0; i < tied.particles.size(); ++i)
        tied.particles[i] |= isWanted(int(i));
    for (std::size_t i = 0; i < net.ends.size(); ++i)
        tied.links[i] |= isWanted(net.ends[i][0]);
    for (std::size_t i = 0; i < net.corners.size(); ++i)
        tied.panels[i] |= isWanted(net.corners[i][0]);
    return tied.ids(net);
}

std::vector<Id> inverted(const Scene& scene, const std::vector<Id>& selected)
{
    const Net net(scene);
    Marks marks(net, scene, selected);
    const auto flip = [](std::vector<char>& rows, bool always) {
        if (always || std::ranges::find(rows, 1) != rows.end())
            for (char& row : rows)
                row = !row;
    };
    const bool nothing = marks.ids(net).empty();
    flip(marks.particles, nothing);
    flip(marks.links, nothing);
    flip(marks.panels, nothing);
    return marks.ids(net);
}

std::vector<Id> boundary(const Scene& scene, const std::vector<Id>& selected)
{
    const Net net(scene);
    const Marks chosen(net, scene, selected);
    const bool some = std::ranges::find(chosen.panels, 1) != chosen.panels.end();
    std::vector<NetSide> edge = sidesOf(net, some ? chosen.panels : std::vector<char>());
    std::erase_if(edge, [](const NetSide& side) { return side.panels > 1; });

    Marks marks(net);
    for (const NetSide& side : edge)
        marks.particles[std::size_t(side.low)] = marks.particles[std::size_t(side.high)] = 1;
    for (std::size_t i = 0; i < net.ends.size(); ++i) {
        const auto [low, high] = std::minmax(net.ends[i][0], net.ends[i][1]);
        marks.links[i] =
            low >= 0 && marks.particles[std::size_t(low)] && marks.particles[std::size_t(high)]
            && std::ranges::binary_search(edge, std::pair(low, high), {}, [](const NetSide& side) {
                   return std::pair(side.low, side.high);
               });
    }
    return marks.ids(net);
}

std::vector<Id> turnedInto(Kind kind, const Scene& scene, const std::vector<Id>& selected)
{
    const Net net(scene);
    const Marks chosen(net, scene, selected);
    Marks result(net);
    std::vector<char> particles = chosen.particles;
    const auto add = [&](const std::vector<char>& others) {
        for (std::size_t i = 0; i < particles.size(); ++i)
            particles[i] |= others[i];
    };
    add(touched(net, net.ends, chosen.links, true));
    add(touched(net, net.corners, chosen.panels, true));
    const auto areIn = [&](std::span<const int> row) {
        return char(net.isWhole(row) && std::ranges::all_of(row, [&](int particle) {
                        return particles[std::size_t(particle)] != 0;
                    }));
    };
    if (kind == Kind::Particle)
        result.particles = std::move(particles);
    for (std::size_t i = 0; kind == Kind::Link && i < net.ends.size(); ++i)
        result.links[i] = areIn(net.ends[i]);
    for (std::size_t i = 0; kind == Kind::Panel && i < net.corners.size(); ++i)
        result.panels[i] = areIn(net.corners[i]);
    return result.ids(net);
}

} // namespace ripstop
