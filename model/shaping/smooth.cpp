// Smooths places in three stages: neighboursOf() decides what each particle is drawn to, from
// sides of panels or else from links, and nobody for borders that stay; passes then move all
// selected particles at once by a share of the way to their mean, with a second pass of negative
// share for Taubin; and the new places become an edit (transform.h).
#include "shaping/smooth.h"

#include "select/net.h"

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

constexpr double passBand = 0.1; // Taubin's k_PB: 1 / factor + 1 / back = k_PB

using NeighbourLists = std::vector<std::vector<int>>; // [particles of the net]

void join(NeighbourLists& neighbours, int a, int b)
{
    neighbours[std::size_t(a)].push_back(b);
    neighbours[std::size_t(b)].push_back(a);
}

void dropRepeats(std::vector<int>& list)
{
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

// The particles that each particle is drawn to; none for one that stays.
NeighbourLists neighboursOf(const Net& net, Border border)
{
    const std::size_t count = net.all.particles.size();
    NeighbourLists neighbours(count), along(count); // along: of borders
    for (const NetSide& side : sidesOf(net)) {
        join(neighbours, side.low, side.high);
        if (side.panels == 1)
            join(along, side.low, side.high);
    }
    std::vector<std::uint8_t> hasPanels(count);
    std::transform(neighbours.begin(), neighbours.end(), hasPanels.begin(),
                   [](const auto& list) { return !list.empty(); });
    for (const std::array<int, 2>& ends : net.ends)
        for (const auto& [one, other] : {std::pair(ends[0], ends[1]), std::pair(ends[1], ends[0])})
            if (net.isWhole(ends) && !hasPanels[std::size_t(one)])
                neighbours[std::size_t(one)].push_back(other);
    for (std::size_t i = 0; i < count; ++i) {
        dropRepeats(neighbours[i]);
        const bool isBorder = !along[i].empty() || neighbours[i].size() < 2;
        if (!isBorder)
            continue;
        neighbours[i] =
            border == Border::Along && along[i].size() >= 2 ? along[i] : std::vector<int>();
    }
    return neighbours;
}

void pass(const NeighbourLists& neighbours, const std::vector<int>& moving, double share,
          std::vector<Vec3>& place, std::vector<Vec3>& next)
{
    for (const int i : moving) {
        Vec3 mean = Vec3::Zero();
        const std::vector<int>& around = neighbours[std::size_t(i)];
        for (const int other : around)
            mean += place[std::size_t(other)];
        mean /= double(around.size());
        next[std::size_t(i)] = place[std::size_t(i)] + share * (mean - place[std::size_t(i)]);
    }
    for (const int i : moving)
        place[std::size_t(i)] = next[std::size_t(i)];
}

} // namespace

Edit smoothed(const Scene& scene, const std::vector<Id>& ids, const SmoothHow& how,
              RestLengths restLengths)
{
    const Movable movable = movableOf(scene, ids);
    const Net net(scene);
    const NeighbourLists neighbours = neighboursOf(net, how.border);
    std::vector<Vec3> place;
    std::vector<int> moving; // particles of the net
    for (std::size_t i = 0; i < net.all.particles.size(); ++i) {
        place.push_back(net.all.particles[i]->position);
        if (!neighbours[i].empty()
            && std::ranges::binary_search(movable.particles, net.all.particles[i]->id))
            moving.push_back(int(i));
    }
    if (moving.empty() || how.factor == 0.0)
        return {Message("Smooth"), {}};
    std::vector<Vec3> next(place.size());
    for (int i = 0; i < how.iterations; ++i) {
        pass(neighbours, moving, how.factor, place, next);
        if (how.smoothing == Smoothing::Taubin)
            pass(neighbours, moving, 1.0 / (passBand - 1.0 / how.factor), place, next);
    }
    std::vector<std::pair<Id, Vec3>> found;
    for (std::size_t i = 0; i < place.size(); ++i)
        found.emplace_back(net.all.particles[i]->id, place[i]);
    std::ranges::sort(found, {}, &std::pair<Id, Vec3>::first);
    std::vector<Vec3> places;
    for (const Id id : movable.particles)
        places.push_back(
            std::ranges::lower_bound(found, id, {}, &std::pair<Id, Vec3>::first)->second);
    return relocated(movable, places, restLengths, Message("Smooth"));
}

} // namespace ripstop
