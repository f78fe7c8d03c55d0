#include "sim/system.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace ripstop {
namespace {

// Greedy colouring in the order of the rods. Pinned particles are never moved, so rods may share
// one within a colour.
std::vector<int> colorsOf(const System& system)
{
    std::vector<std::vector<std::uint64_t>> used(system.inverseMass.size());
    std::vector<int> color(system.rods.size());
    for (std::size_t r = 0; r < system.rods.size(); ++r) {
        const auto [a, b] = std::pair(system.rods[r].a, system.rods[r].b);
        const bool freeA = system.inverseMass[std::size_t(a)] > 0.0;
        const bool freeB = system.inverseMass[std::size_t(b)] > 0.0;
        const auto wordAt = [&](int particle, std::size_t word) {
            const auto& words = used[std::size_t(particle)];
            return word < words.size() ? words[word] : 0;
        };
        std::size_t word = 0;
        std::uint64_t taken = 0;
        for (;; ++word) {
            taken = (freeA ? wordAt(a, word) : 0) | (freeB ? wordAt(b, word) : 0);
            if (~taken != 0)
                break;
        }
        const int bit = std::countr_one(taken);
        color[r] = int(word) * 64 + bit;
        for (const int particle : {a, b}) {
            auto& words = used[std::size_t(particle)];
            if (words.size() <= word)
                words.resize(word + 1, 0);
            words[word] |= std::uint64_t(1) << bit;
        }
    }
    return color;
}

void groupByColor(System& system)
{
    const std::vector<int> color = colorsOf(system);
    std::vector<int> order(system.rods.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int x, int y) { return color[std::size_t(x)] < color[std::size_t(y)]; });

    std::vector<Rod> sorted;
    std::vector<int> place(order.size());
    sorted.reserve(order.size());
    system.colorStart.assign(1, 0);
    for (const int r : order) {
        if (!sorted.empty()
            && color[std::size_t(r)] != color[std::size_t(order[sorted.size() - 1])])
            system.colorStart.push_back(int(sorted.size()));
        place[std::size_t(r)] = int(sorted.size());
        sorted.push_back(system.rods[std::size_t(r)]);
    }
    if (!sorted.empty())
        system.colorStart.push_back(int(sorted.size()));
    system.rods = std::move(sorted);
    for (LinkPlace& link : system.links)
        if (link.kind == LinkKind::Rod)
            link.index = place[std::size_t(link.index)];
    for (ShiftedRod& shifted : system.shiftedRods)
        shifted.rod = place[std::size_t(shifted.rod)];
}

// Rows of the items that name each of `count` targets, in ascending order of item.
template <typename Items, typename TargetsOf>
Rows incidence(std::size_t count, const Items& items, TargetsOf targetsOf)
{
    Rows rows;
    rows.start.assign(count + 1, 0);
    for (const auto& item : items)
        for (const int target : targetsOf(item))
            ++rows.start[std::size_t(target) + 1];
    std::partial_sum(rows.start.begin(), rows.start.end(), rows.start.begin());
    rows.items.resize(std::size_t(rows.start.back()));
    std::vector<int> next(rows.start.begin(), rows.start.end() - 1);
    for (std::size_t i = 0; i < items.size(); ++i)
        for (const int target : targetsOf(items[i]))
            rows.items[std::size_t(next[std::size_t(target)]++)] = int(i);
    return rows;
}

Rows panelsBesideLinks(const System& system)
{
    Rows rows;
    rows.start.push_back(0);
    for (const LinkPlace& link : system.links) {
        const auto first =
            system.panelsAt.items.begin() + system.panelsAt.start[std::size_t(link.a)];
        const auto last =
            system.panelsAt.items.begin() + system.panelsAt.start[std::size_t(link.a) + 1];
        std::copy_if(first, last, std::back_inserter(rows.items), [&](int panel) {
            const auto& corner = system.panels[std::size_t(panel)].corner;
            return std::find(corner.begin(), corner.end(), link.b) != corner.end();
        });
        rows.start.push_back(int(rows.items.size()));
    }
    return rows;
}

void nameLinks(System& system)
{
    if (system.links.empty()) {
        for (std::size_t i = 0; i < system.springs.size(); ++i)
            system.links.push_back({Key(system.links.size()), LinkKind::Spring, int(i),
                                    system.springs[i].a, system.springs[i].b});
        for (std::size_t i = 0; i < system.rods.size(); ++i)
            system.links.push_back({Key(system.links.size()), LinkKind::Rod, int(i),
                                    system.rods[i].a, system.rods[i].b});
    }
}

void backReferences(System& system)
{
    system.springLink.assign(system.springs.size(), -1);
    system.rodLink.assign(system.rods.size(), -1);
    system.tearable.clear();
    for (std::size_t i = 0; i < system.links.size(); ++i) {
        const LinkPlace& link = system.links[i];
        const bool spring = link.kind == LinkKind::Spring;
        (spring ? system.springLink : system.rodLink)[std::size_t(link.index)] = int(i);
        const TearLimit& tear = spring ? system.springs[std::size_t(link.index)].tear
                                       : system.rods[std::size_t(link.index)].tear;
        if (tear.rule != TearRule::Never)
            system.tearable.push_back(int(i));
    }
}

template <typename T>
void fill(std::vector<T>& values, std::size_t count, const T& value)
{
    if (values.size() != count)
        values.assign(count, value);
}

} // namespace

void finish(System& system)
{
    const std::size_t n = system.start.position.size();
    if (system.key.empty()) {
        system.key.resize(n);
        std::iota(system.key.begin(), system.key.end(), Key(0));
    }
    if (system.mass.empty())
        for (const double w : system.inverseMass)
            system.mass.push_back(w > 0.0 ? 1.0 / w : 0.0);
    fill(system.panelKey, system.panels.size(), Key(0));

    nameLinks(system);
    groupByColor(system);
    backReferences(system);

    const auto ends = [](const auto& link) { return std::array{link.a, link.b}; };
    system.springsAt = incidence(n, system.springs, ends);
    system.rodsAt = incidence(n, system.rods, ends);
    system.panelsAt = incidence(n, system.panels, [](const FabricPanel& p) { return p.corner; });
    system.panelsBeside = panelsBesideLinks(system);

    State& start = system.start;
    fill<Vec3>(start.velocity, n, Vec3::Zero());
    fill<Vec3>(start.drift, n, Vec3::Zero());
    fill(start.inputCommand, system.inputs.size(), 0.0);
    fill(start.inputValue, system.inputs.size(), 0.0);
    fill(start.springTorn, system.springs.size(), std::uint8_t(0));
    fill(start.rodTorn, system.rods.size(), std::uint8_t(0));
    fill(start.panelGone, system.panels.size(), std::uint8_t(0));
    fill(start.rodTension, system.rods.size(), 0.0);
}

} // namespace ripstop
