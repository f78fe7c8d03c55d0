// A line is told by the particles along it: where two links meet, and nothing else.
#include "tearing/line_parting.h"

#include "base/joined_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

// The links that are left at a particle where nothing but links meet: along a line there are two,
// which pull alike, and at a loose end one. None are told of pins and of corners of panels.
struct LinksLeft
{
    int count = 0;
    std::array<int, 2> link{}; // the last two

    LinksLeft(const System& system, const State& state, int particle);

    bool isAlong() const { return count == 2; }
    bool isLooseEnd() const { return count == 1; }
};

// Calls back with each link that ends at a particle, torn or not.
template <typename Visit> // visit(link), index into System::links
void forEachLinkAt(const System& system, int particle, Visit visit)
{
    const auto p = std::size_t(particle);
    const auto forEach = [&](const Rows& rows, const std::vector<int>& linkOf) {
        for (int k = rows.start[p]; k < rows.start[p + 1]; ++k)
            visit(linkOf[std::size_t(rows.items[std::size_t(k)])]);
    };
    forEach(system.springsAt, system.springLink);
    forEach(system.rodsAt, system.rodLink);
}

bool isCornerOfFabric(const System& system, const State& state, int particle)
{
    const Rows& rows = system.panelsAt;
    const auto p = std::size_t(particle);
    return std::any_of(rows.items.begin() + rows.start[p], rows.items.begin() + rows.start[p + 1],
                       [&](int panel) { return !state.panelGone[std::size_t(panel)]; });
}

LinksLeft::LinksLeft(const System& system, const State& state, int particle)
{
    if (system.inverseMass[std::size_t(particle)] == 0.0
        || isCornerOfFabric(system, state, particle))
        return;
    forEachLinkAt(system, particle, [&](int one) {
        if (isTorn(system.links[std::size_t(one)], state))
            return;
        link = {link[1], one};
        ++count;
    });
}

// Of the links of one line only the worst stays, of equals the first: when it has parted, the
// others hold nothing.
void leaveWorstOfLines(const System& system, const State& state, std::vector<Overload>& overloads)
{
    JoinedSets lines(overloads.size());
    std::vector<int> firstAt(state.position.size(), -1); // overload
    for (std::size_t i = 0; i < overloads.size(); ++i) {
        if (overloads[i].of != Overload::Of::Link)
            continue;
        const LinkPlace& link = system.links[std::size_t(overloads[i].element)];
        for (const int end : {link.a, link.b}) {
            int& first = firstAt[std::size_t(end)];
            if (first >= 0 && LinksLeft(system, state, end).isAlong())
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

// Where a line ends that goes on from a link over one of its ends, and how long a pull takes there.
struct WayAlong
{
    int last;        // particle
    double crossing; // s, without the link itself
};

WayAlong wayAlong(const System& system, const State& state, int link, int end)
{
    WayAlong way{end, 0.0};
    for (int at = link;;) {
        const LinksLeft here(system, state, way.last);
        const int next = here.link[0] == at ? here.link[1] : here.link[0];
        if (!here.isAlong() || next == link) // or it is a ring
            return way;
        const LinkPlace& place = system.links[std::size_t(next)];
        way.last = place.a == way.last ? place.b : place.a;
        way.crossing += easingTime(system, place);
        at = next;
    }
}

// Whether a link whose end a particle is has torn in the last so many seconds.
bool hasTornAt(const System& system, const State& state, int particle, double seconds)
{
    bool hasTorn = false;
    forEachLinkAt(system, particle, [&](int link) {
        const LinkPlace& place = system.links[std::size_t(link)];
        if (!isTorn(place, state))
            return;
        for (auto tear = state.tears.rbegin();
             tear != state.tears.rend() && state.time - tear->time < seconds; ++tear)
            hasTorn |= tear->element == place.key;
    });
    return hasTorn;
}

// What is left of a line that has parted loses its load as a pull runs along it and back. Until
// then its links may be above their limit, and get further above it by what they are tied to; they
// hold nothing for long all the same.
bool hasJustParted(const System& system, const State& state, int link)
{
    const LinkPlace& place = system.links[std::size_t(link)];
    const std::array ways{wayAlong(system, state, link, place.a),
                          wayAlong(system, state, link, place.b)};
    const double crossing = ways[0].crossing + easingTime(system, place) + ways[1].crossing;
    return std::ranges::any_of(ways, [&](const WayAlong& way) {
        return LinksLeft(system, state, way.last).isLooseEnd()
               && hasTornAt(system, state, way.last, 2.0 * crossing);
    });
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
    if (!state.tears.empty())
        std::erase_if(overloads, [&](const Overload& overload) {
            return overload.of == Overload::Of::Link
                   && hasJustParted(system, state, overload.element);
        });
    if (std::ranges::count(overloads, Overload::Of::Link, &Overload::of) > 1)
        leaveWorstOfLines(system, state, overloads);
}

} // namespace ripstop
