// A scene as a net: which particles its links and panels tie, by index instead of by id.
// Selections, smoothing, the stability look and the totals of the inspector build one, ask it and
// drop it: it points into the scene and is stale when that changes. All rows are in ascending
// order of id.
#pragma once

#include "base/key_index.h"
#include "select/elements.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace ripstop {

struct Net
{
    explicit Net(const Scene& scene);

    Elements all;
    std::vector<std::array<int, 2>> ends; // [links] indices of particles, -1 for one that is lost
    std::vector<std::array<int, 3>> corners; // [panels] indices of particles, or -1

    bool isWhole(std::span<const int> particles) const;
};

// Elements of a net, marked.
struct Marks
{
    explicit Marks(const Net& net);
    Marks(const Net& net, const Scene& scene, const std::vector<Id>& selected);

    std::vector<char> particles; // [particles]
    std::vector<char> links;     // [links]
    std::vector<char> panels;    // [panels]

    std::vector<Id> ids(const Net& net) const; // ascending
};

// The sides of panels, each once: a pair of particles, the lower index first. Those of ids are in
// derived/panel_sides.h.
struct NetSide
{
    int low;
    int high;
    int panels; // number of panels that have this side

    friend bool operator==(const NetSide&, const NetSide&) = default;
};

// Ordered by `low`, then by `high`. Only panels whose mark is set count; all do when there are no
// marks.
std::vector<NetSide> sidesOf(const Net& net, std::span<const char> panels = {});

// For each particle, a list of numbers, in one array.
struct Lists
{
    std::vector<int> first; // [particles + 1]
    std::vector<int> entry;

    std::span<const int> operator[](int particle) const
    {
        const auto at = std::size_t(particle);
        return std::span(entry).subspan(std::size_t(first[at]),
                                        std::size_t(first[at + 1] - first[at]));
    }
};
Lists linksOfParticles(const Net& net);

} // namespace ripstop
