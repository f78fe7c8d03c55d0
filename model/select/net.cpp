// Builds the net once per question: ids of particles become indices, links and panels become rows
// of indices, and -1 stands for a particle that is lost. Marks walk the sorted ids along the rows.
// Lists by particle are filled by counting first and placing second, so that each takes two passes
// and two arrays.
#include "select/net.h"

#include <algorithm>

namespace ripstop {
namespace {

template <typename Row>
void mark(const std::vector<const Row*>& rows, const std::vector<Id>& ids, std::vector<char>& marks)
{
    auto id = ids.begin();
    for (std::size_t i = 0; i < rows.size() && id != ids.end(); ++i) {
        while (id != ids.end() && *id < rows[i]->id)
            ++id;
        marks[i] = id != ids.end() && *id == rows[i]->id;
    }
}

template <typename Row>
void collect(const std::vector<const Row*>& rows, const std::vector<char>& marks,
             std::vector<Id>& ids)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (marks[i])
            ids.push_back(rows[i]->id);
}

// Sorts entries into lists by particle. `forEach(add)` calls add(particle, entry), the same twice.
template <typename ForEach>
Lists listed(std::size_t particles, ForEach forEach)
{
    Lists lists;
    lists.first.assign(particles + 1, 0);
    forEach([&](int particle, int) { ++lists.first[std::size_t(particle) + 1]; });
    for (std::size_t i = 1; i < lists.first.size(); ++i)
        lists.first[i] += lists.first[i - 1];
    lists.entry.resize(std::size_t(lists.first.back()));
    std::vector<int> next(lists.first.begin(), lists.first.end() - 1);
    forEach([&](int particle, int entry) {
        lists.entry[std::size_t(next[std::size_t(particle)]++)] = entry;
    });
    return lists;
}

} // namespace

Net::Net(const Scene& scene)
    : all(everyElement(scene))
{
    KeyIndex place(all.particles.size() + all.links.size() + all.panels.size());
    for (std::size_t i = 0; i < all.particles.size(); ++i)
        place.add(std::uint32_t(all.particles[i]->id), int(i));
    const auto at = [&](Id id) { return place(std::uint32_t(id)); };
    ends.reserve(all.links.size());
    for (const Link* link : all.links)
        ends.push_back({at(link->from), at(link->to)});
    corners.reserve(all.panels.size());
    for (const Panel* panel : all.panels)
        corners.push_back({at(panel->a), at(panel->b), at(panel->c)});
}

bool Net::isWhole(std::span<const int> particles) const
{
    return std::ranges::all_of(particles, [](int particle) { return particle >= 0; });
}

Marks::Marks(const Net& net)
    : particles(net.all.particles.size(), 0)
    , links(net.all.links.size(), 0)
    , panels(net.all.panels.size(), 0)
{}

Marks::Marks(const Net& net, const Scene& scene, const std::vector<Id>& selected)
    : Marks(net)
{
    const std::vector<Id> ids = elementsOf(scene, selected);
    mark(net.all.particles, ids, particles);
    mark(net.all.links, ids, links);
    mark(net.all.panels, ids, panels);
}

std::vector<Id> Marks::ids(const Net& net) const
{
    std::vector<Id> ids;
    collect(net.all.particles, particles, ids);
    collect(net.all.links, links, ids);
    collect(net.all.panels, panels, ids);
    if (!std::ranges::is_sorted(ids))
        std::ranges::sort(ids);
    return ids;
}

std::vector<NetSide> sidesOf(const Net& net, std::span<const char> panels)
{
    const Lists lists = listed(net.all.particles.size(), [&](auto add) {
        for (std::size_t i = 0; i < net.corners.size(); ++i) {
            if (!net.isWhole(net.corners[i]) || (!panels.empty() && !panels[i]))
                continue;
            for (int k = 0; k < 3; ++k) {
                const auto [low, high] = std::minmax(net.corners[i][std::size_t(k)],
                                                     net.corners[i][std::size_t((k + 1) % 3)]);
                add(low, high);
            }
        }
    });
    std::vector<NetSide> sides;
    std::vector<int> others;
    for (int low = 0; low + 1 < int(lists.first.size()); ++low) {
        others.assign(lists[low].begin(), lists[low].end());
        std::ranges::sort(others);
        for (const int high : others)
            if (!sides.empty() && sides.back().low == low && sides.back().high == high)
                ++sides.back().panels;
            else
                sides.push_back({low, high, 1});
    }
    return sides;
}

Lists linksOfParticles(const Net& net)
{
    return listed(net.all.particles.size(), [&](auto add) {
        for (std::size_t i = 0; i < net.ends.size(); ++i)
            if (net.isWhole(net.ends[i]))
                for (const int end : net.ends[i])
                    add(end, int(i));
    });
}

} // namespace ripstop
