// Each break joins the events of the breaks before it that reach its particles; sets that are
// joined keep the first of their breaks as root, so that events come out in order.
#include "run/tear_events.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace ripstop {
namespace {

using Ids = std::set<std::uint32_t>;

// The particles of an element that has torn, and with those that a link or a panel ties to them.
struct Reach
{
    Ids own, tied;
};

template <typename Look> // look(element, its particles, by index)
void forEachElement(const Layout& layout, Look look)
{
    for (const Layout::Link& link : layout.links)
        look(link.id, std::array{link.a, link.b});
    for (std::size_t i = 0; i < layout.panelId.size(); ++i)
        look(layout.panelId[i], layout.panelCorners[i]);
}

// By element. What a split has doubled is of the same ids.
std::map<std::uint32_t, Reach> reachesOf(std::span<const Tear> tears, const Layout& layout)
{
    std::map<std::uint32_t, Reach> reaches;
    for (const Tear& tear : tears)
        reaches[tear.element];
    const auto idOf = [&](int particle) { return layout.particleId[std::size_t(particle)]; };
    forEachElement(layout, [&](std::uint32_t element, const auto& particles) {
        if (const auto torn = reaches.find(element); torn != reaches.end())
            for (const int particle : particles)
                torn->second.own.insert(idOf(particle));
    });
    std::map<std::uint32_t, Ids> ties; // of the particles of what has torn
    for (auto& [element, reach] : reaches)
        for (const std::uint32_t particle : reach.own)
            ties[particle];
    forEachElement(layout, [&](std::uint32_t, const auto& particles) {
        for (const int particle : particles)
            if (const auto tied = ties.find(idOf(particle)); tied != ties.end())
                for (const int other : particles)
                    tied->second.insert(idOf(other));
    });
    for (auto& [element, reach] : reaches)
        for (const std::uint32_t particle : reach.own)
            reach.tied.insert(ties[particle].begin(), ties[particle].end());
    return reaches;
}

} // namespace

TearEvents tearEvents(std::span<const Tear> tears, const Layout& layout)
{
    const std::map<std::uint32_t, Reach> reaches = reachesOf(tears, layout);
    std::vector<std::size_t> root(tears.size());
    std::iota(root.begin(), root.end(), std::size_t(0));
    const auto rootOf = [&](std::size_t i) {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    };
    std::map<std::uint32_t, std::vector<std::size_t>> breaks; // within whose reach a particle is
    for (std::size_t i = 0; i < tears.size(); ++i) {
        const Reach& reach = reaches.at(tears[i].element);
        for (const std::uint32_t particle : reach.own) {
            const std::vector<std::size_t>& there = breaks[particle]; // from the newest on
            for (auto before = there.rbegin(); before != there.rend(); ++before) {
                if (tears[i].time - tears[*before].time > TearEvent::pause)
                    break;
                const std::size_t a = rootOf(*before), b = rootOf(i);
                root[std::max(a, b)] = std::min(a, b);
            }
        }
        for (const std::uint32_t particle : reach.tied)
            breaks[particle].push_back(i);
    }

    TearEvents events;
    events.of.resize(tears.size());
    for (std::size_t i = 0; i < tears.size(); ++i) {
        const std::size_t first = rootOf(i);
        if (first == i) {
            events.of[i] = events.all.size();
            events.all.push_back(
                {tears[i].time, tears[i].time, 0, 0.0, tears[i].element, tears[i].place});
        }
        events.of[i] = events.of[first];
        TearEvent& event = events.all[events.of[i]];
        event.end = tears[i].time;
        event.energy += tears[i].energy;
        ++event.count;
    }
    return events;
}

} // namespace ripstop
