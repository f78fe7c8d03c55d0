// A line is told by the particles along it: where two links meet, and nothing else.
#include "tearing/line_parting.h"

#include "base/joined_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

// Of particles where nothing but links meet: along a line there are two of them, which pull alike,
// and at a loose end there is one.
struct LineNodes
{
    std::vector<int> count;               // [particles] of links left; none at panels and of pins
    std::vector<std::array<int, 2>> link; // [particles] the last two of these

    LineNodes(const System& system, const State& state);

    bool isAlong(int particle) const { return count[std::size_t(particle)] == 2; }
    bool isLooseEnd(int particle) const { return count[std::size_t(particle)] == 1; }
};

LineNodes::LineNodes(const System& system, const State& state)
    : count(state.position.size(), 0)
    , link(state.position.size())
{
    for (std::size_t i = 0; i < system.links.size(); ++i)
        if (const LinkPlace& one = system.links[i]; !isTorn(one, state))
            for (const int end : {one.a, one.b}) {
                const auto p = std::size_t(end);
                link[p] = {link[p][1], int(i)};
                ++count[p];
            }
    for (std::size_t p = 0; p < system.panels.size(); ++p)
        if (!state.panelGone[p])
            for (const int corner : system.panels[p].corner)
                count[std::size_t(corner)] = 0;
    for (std::size_t p = 0; p < count.size(); ++p)
        if (system.inverseMass[p] == 0.0)
            count[p] = 0;
}

// Of the links of one line only the worst stays, of equals the first: when it has parted, the
// others hold nothing.
void leaveWorstOfLines(const System& system, const LineNodes& nodes,
                       std::vector<Overload>& overloads)
{
    JoinedSets lines(overloads.size());
    std::vector<int> firstAt(nodes.count.size(), -1); // overload
    for (std::size_t i = 0; i < overloads.size(); ++i) {
        if (overloads[i].of != Overload::Of::Link)
            continue;
        const LinkPlace& link = system.links[std::size_t(overloads[i].element)];
        for (const int end : {link.a, link.b}) {
            int& first = firstAt[std::size_t(end)];
            if (nodes.isAlong(end) && first >= 0)
                lines.join(first, int(i));
            first = int(i);
        }
    }
    std::vector<int> worst(overloads.size(), -1); // [sets] overload
    for (std::size_t i = 0; i < overloads.size(); ++i) {
        int& best = worst[std::size_t(lines.of(int(i)))];
        if (best < 0 || worstFirst(overloads[i], overloads[std::size_t(best)]))
            best = int(i);
    }
    std::size_t i = 0;
    std::erase_if(overloads, [&](const Overload&) {
        const bool isWorst = worst[std::size_t(lines.of(int(i)))] == int(i);
        ++i;
        return !isWorst;
    });
}

// The links that are left of a line from the end of one that has torn, as far as nothing else is
// tied to it.
std::vector<int> restOfLine(const System& system, const LineNodes& nodes, int end)
{
    std::vector<int> rest;
    for (int at = end; rest.empty() ? nodes.isLooseEnd(at) : nodes.isAlong(at);) {
        const auto [one, other] = nodes.link[std::size_t(at)];
        const int next = rest.empty() || other != rest.back() ? other : one;
        const LinkPlace& link = system.links[std::size_t(next)];
        rest.push_back(next);
        at = link.a == at ? link.b : link.a;
    }
    return rest;
}

// What is left of a line that has parted loses its load as a pull runs along it and back. Until
// then its links may be above their limit, and get further above it by what they are tied to; they
// hold nothing for long all the same.
void leavePartedLines(const System& system, const State& state, const LineNodes& nodes,
                      std::vector<Overload>& overloads)
{
    constexpr double longest = 0.1; // s, of which tears are looked at
    for (auto tear = state.tears.rbegin(); tear != state.tears.rend(); ++tear) {
        const double since = state.time - tear->time;
        if (since > longest)
            break;
        const auto link = std::ranges::find(system.links, tear->element, &LinkPlace::key);
        if (link == system.links.end() || !isTorn(*link, state))
            continue;
        for (const int end : {link->a, link->b}) {
            const std::vector<int> rest = restOfLine(system, nodes, end);
            double crossing = 0.0; // s
            for (const int one : rest)
                crossing += easingTime(system, system.links[std::size_t(one)]);
            if (since < 2.0 * crossing)
                std::erase_if(overloads, [&](const Overload& overload) {
                    return overload.of == Overload::Of::Link
                           && std::ranges::find(rest, overload.element) != rest.end();
                });
        }
    }
}

} // namespace

double easingTime(const System& system, const LinkPlace& link)
{
    const auto index = std::size_t(link.index);
    const bool isRod = link.kind == LinkKind::Rod;
    if (!isRod && system.springs[index].stiffness <= 0.0)
        return std::numeric_limits<double>::infinity();
    const Rod rod = isRod ? system.rods[index] : asRod(system.springs[index]);
    const double mass = system.mass[std::size_t(link.a)] + system.mass[std::size_t(link.b)];
    return std::sqrt(mass * rod.compliance) + rod.dampingTime;
}

void leaveOneOfLines(const System& system, const State& state, std::vector<Overload>& overloads)
{
    const auto links = std::ranges::count(overloads, Overload::Of::Link, &Overload::of);
    if (links == 0 || (links == 1 && state.tears.empty()))
        return;
    const LineNodes nodes(system, state);
    leavePartedLines(system, state, nodes, overloads);
    leaveWorstOfLines(system, nodes, overloads);
}

} // namespace ripstop
