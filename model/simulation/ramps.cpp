// Numbers of links are noted by their keys, since an edit may renumber them; those that differ
// after it become ramps. Those that begin have no duration until all of the edit have been seen,
// since they last equally long. rampsAt() makes of all ramps a patch for the system, as an author's
// edit would be, and dropEnded() forgets those that have arrived.
#include "simulation/ramps.h"

#include "forces/spring_force.h"

#include <algorithm>
#include <limits>

namespace ripstop {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

const TearLimit& tearOf(const System& system, const LinkPlace& link)
{
    return link.kind == LinkKind::Rod ? system.rods[std::size_t(link.index)].tear
                                      : system.springs[std::size_t(link.index)].tear;
}

Resists resistsOf(const System& system, const LinkPlace& link)
{
    return link.kind == LinkKind::Rod ? system.rods[std::size_t(link.index)].resists
                                      : system.springs[std::size_t(link.index)].resists;
}

Ramp::Numbers numbersOf(const System& system, const LinkPlace& link)
{
    if (link.kind == LinkKind::Rod) {
        const Rod& rod = system.rods[std::size_t(link.index)];
        return {rod.restLength, rod.compliance, 0.0, rod.tear.limit};
    }
    const Spring& spring = system.springs[std::size_t(link.index)];
    return {spring.restLength, spring.stiffness, spring.damping, spring.tear.limit};
}

Ramp::Numbers numbersAt(const Ramp& ramp, LinkKind kind, double time)
{
    if (hasEnded(ramp, time))
        return ramp.to;
    const double share = shareOf(ramp, time);
    const auto& [from, to] = std::pair(ramp.from, ramp.to);
    return {between(from.restLength, to.restLength, share),
            kind == LinkKind::Rod ? between(from.stiffness, to.stiffness, share)
                                  : stiffnessBetween(from.stiffness, to.stiffness, share),
            between(from.damping, to.damping, share), between(from.limit, to.limit, share)};
}

// By how much less it is stretched when it pulls as before, and what its length changes by, m.
double wayOf(const Ramp& ramp, LinkKind kind, double stretch)
{
    const double before = kind == LinkKind::Rod ? ramp.from.stiffness : ramp.to.stiffness;
    const double after = kind == LinkKind::Rod ? ramp.to.stiffness : ramp.from.stiffness;
    const double less = before > after ? 1.0 - after / before : 0.0;
    return std::abs(stretch) * less + std::abs(ramp.to.restLength - ramp.from.restLength);
}

// Adds the numbers of ramps at a time, s, to what is to change of a system.
void addLinks(const System& system, const std::vector<Ramp>& ramps, double time, Patch& patch)
{
    if (ramps.empty())
        return;
    KeyIndex index(system.links.size());
    for (std::size_t i = 0; i < system.links.size(); ++i)
        index.add(system.links[i].key, int(i));
    for (const Ramp& ramp : ramps) {
        const int place = index(ramp.link);
        if (place < 0)
            continue;
        const LinkPlace& link = system.links[std::size_t(place)];
        const Ramp::Numbers now = numbersAt(ramp, link.kind, time);
        if (link.kind == LinkKind::Rod) {
            Rod rod = system.rods[std::size_t(link.index)];
            rod.restLength = now.restLength;
            rod.compliance = now.stiffness;
            rod.tear.limit = now.limit;
            patch.rods.emplace_back(place, rod);
        } else {
            Spring spring = system.springs[std::size_t(link.index)];
            spring.restLength = now.restLength;
            spring.stiffness = now.stiffness;
            spring.damping = now.damping;
            spring.tear.limit = now.limit;
            patch.springs.emplace_back(place, spring);
        }
    }
}

template <typename S, typename Visit>
void forEachList(S& state, const Visit& visit)
{
    visit(state.ramps);
    visit(state.clothRamps);
    visit(state.panelRamps);
    visit(state.factorRamps);
}

} // namespace

NotedNumbers::NotedNumbers(const System& system, const State& state)
    : m_time(state.time)
    , m_ramps(state.ramps)
    , m_cloth(system, state)
{
    m_links.reserve(system.links.size());
    RampFinder rampOf(m_ramps, &Ramp::link);
    for (const LinkPlace& link : system.links) {
        const Ramp* ramp = rampOf(link.key);
        m_links.push_back(
            {link.key,
             link.kind,
             tearOf(system, link).rule,
             resistsOf(system, link),
             {state.position[std::size_t(link.a)], state.position[std::size_t(link.b)]},
             ramp ? numbersAt(*ramp, link.kind, m_time) : numbersOf(system, link)});
    }
}

void NotedNumbers::addTo(RampWay& way, const Ramp& ramp, LinkKind kind, const Link& link) const
{
    way.box.extend(link.ends[0]);
    way.box.extend(link.ends[1]);
    const double length = (link.ends[1] - link.ends[0]).norm();
    const double stretch = length - ramp.from.restLength;
    if (length > 0.0)
        way.strain = std::max(
            way.strain, wayOf(ramp, kind, isSlack(link.resists, stretch) ? 0.0 : stretch) / length);
}

std::vector<Ramp> NotedNumbers::linkRampsTo(const System& edited, RampWay& way) const
{
    KeyIndex index(m_links.size());
    for (std::size_t i = 0; i < m_links.size(); ++i)
        index.add(m_links[i].key, int(i));
    std::vector<Ramp> ramps;
    RampFinder rampOf(m_ramps, &Ramp::link);
    for (const LinkPlace& link : edited.links) {
        const int place = index(link.key);
        if (place < 0)
            continue;
        const Link& noted = m_links[std::size_t(place)];
        const Ramp::Numbers to = numbersOf(edited, link);
        if (const Ramp* ramp = rampOf(link.key); ramp && ramp->to == to) {
            ramps.push_back(*ramp);
            continue;
        }
        Ramp::Numbers from = noted.numbers;
        if (noted.kind != link.kind) {
            // A spring that got too stiff for a force gets so by and by. One that was may not be
            // as stiff as before for a moment, but what gets softer throws nothing.
            const bool stiffens = link.kind == LinkKind::Rod && from.stiffness > 0.0;
            from.stiffness = stiffens ? 1.0 / from.stiffness : to.stiffness;
            from.damping = to.damping;
        }
        if (noted.rule != tearOf(edited, link).rule) // a limit of something else
            from.limit = to.limit;
        if (from != to && edited.rampTime > 0.0) {
            ramps.push_back({link.key, m_time, 0.0, from, to});
            addTo(way, ramps.back(), link.kind, noted);
        }
    }
    std::ranges::sort(ramps, {}, &Ramp::link);
    return ramps;
}

void NotedNumbers::rampTo(const System& edited, State& state) const
{
    RampWay way;
    state.ramps = linkRampsTo(edited, way);
    state.clothRamps = m_cloth.lawRampsTo(edited, way);
    m_cloth.panelRampsTo(edited, state, way);
    const double lasts = way.lastsFor(edited.rampTime);
    forEachList(state, [lasts](auto& ramps) {
        for (auto& ramp : ramps)
            if (ramp.lasts == 0.0)
                ramp.lasts = lasts;
    });
}

bool hasRamps(const State& state)
{
    bool some = false;
    forEachList(state, [&](const auto& ramps) { some |= !ramps.empty(); });
    return some;
}

Patch rampsAt(const System& system, const State& state, double time)
{
    Patch patch;
    patch.generation = system.generation;
    patch.run = system.run;
    addLinks(system, state.ramps, time, patch);
    addCloth(system, state, time, patch);
    return patch;
}

Patch endsOf(const System& system, const State& state) { return rampsAt(system, state, never); }

void dropEnded(State& state, double time)
{
    forEachList(state, [time](auto& ramps) {
        std::erase_if(ramps, [time](const auto& ramp) { return hasEnded(ramp, time); });
    });
}

} // namespace ripstop
