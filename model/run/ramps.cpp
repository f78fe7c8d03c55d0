#include "run/ramps.h"

#include "base/key_index.h"

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

Ramp::Numbers numbersOf(const System& system, const LinkPlace& link)
{
    if (link.kind == LinkKind::Rod) {
        const Rod& rod = system.rods[std::size_t(link.index)];
        return {rod.restLength, rod.compliance, 0.0, rod.tear.limit};
    }
    const Spring& spring = system.springs[std::size_t(link.index)];
    return {spring.restLength, spring.stiffness, spring.damping, spring.tear.limit};
}

double between(double from, double to, double share) { return from + share * (to - from); }

// So that what hangs on the spring goes evenly.
double stiffnessBetween(double from, double to, double share)
{
    return from > 0.0 && to > 0.0 ? 1.0 / between(1.0 / from, 1.0 / to, share)
                                  : between(from, to, share);
}

bool hasEnded(const Ramp& ramp, double time) { return time >= ramp.began + ramp.lasts; }

Ramp::Numbers numbersAt(const Ramp& ramp, LinkKind kind, double time)
{
    if (hasEnded(ramp, time))
        return ramp.to;
    const double s = std::max((time - ramp.began) / ramp.lasts, 0.0);
    const double share = s * s * (3.0 - 2.0 * s);
    const auto& [from, to] = std::pair(ramp.from, ramp.to);
    return {between(from.restLength, to.restLength, share),
            kind == LinkKind::Rod ? between(from.stiffness, to.stiffness, share)
                                  : stiffnessBetween(from.stiffness, to.stiffness, share),
            between(from.damping, to.damping, share), between(from.limit, to.limit, share)};
}

const Ramp* rampOf(std::span<const Ramp> ramps, Key link)
{
    const auto found = std::ranges::lower_bound(ramps, link, {}, &Ramp::link);
    return found != ramps.end() && found->link == link ? &*found : nullptr;
}

} // namespace

NotedLinks::NotedLinks(const System& system, std::span<const Ramp> underWay, double time)
    : m_time(time)
    , m_ramps(underWay.begin(), underWay.end())
{
    m_links.reserve(system.links.size());
    for (const LinkPlace& link : system.links) {
        const Ramp* ramp = rampOf(m_ramps, link.key);
        m_links.push_back({link.key, link.kind, tearOf(system, link).rule,
                           ramp ? numbersAt(*ramp, link.kind, time) : numbersOf(system, link)});
    }
}

std::vector<Ramp> NotedLinks::rampsTo(const System& edited) const
{
    KeyIndex index(m_links.size());
    for (std::size_t i = 0; i < m_links.size(); ++i)
        index.add(m_links[i].key, int(i));
    std::vector<Ramp> ramps;
    for (const LinkPlace& link : edited.links) {
        const int place = index(link.key);
        if (place < 0 || m_links[std::size_t(place)].kind != link.kind)
            continue;
        const Link& noted = m_links[std::size_t(place)];
        const Ramp::Numbers to = numbersOf(edited, link);
        if (const Ramp* ramp = rampOf(m_ramps, link.key); ramp && ramp->to == to) {
            ramps.push_back(*ramp);
            continue;
        }
        Ramp::Numbers from = noted.numbers;
        if (noted.rule != tearOf(edited, link).rule) // a limit of something else
            from.limit = to.limit;
        if (from != to && edited.rampTime > 0.0)
            ramps.push_back({link.key, m_time, edited.rampTime, from, to});
    }
    std::ranges::sort(ramps, {}, &Ramp::link);
    return ramps;
}

Patch rampsAt(const System& system, std::span<const Ramp> ramps, double time)
{
    KeyIndex index(system.links.size());
    for (std::size_t i = 0; i < system.links.size(); ++i)
        index.add(system.links[i].key, int(i));
    Patch patch;
    patch.generation = system.generation;
    patch.run = system.run;
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
    return patch;
}

Patch endsOf(const System& system, std::span<const Ramp> ramps)
{
    return rampsAt(system, ramps, never);
}

void dropEnded(std::vector<Ramp>& ramps, double time)
{
    std::erase_if(ramps, [time](const Ramp& ramp) { return hasEnded(ramp, time); });
}

} // namespace ripstop
