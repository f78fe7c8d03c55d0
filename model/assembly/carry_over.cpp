// Carries a state over into another system, stage by stage.
//
// It begins with the start of the new system and what is of the run as a whole. Particles come
// next, as all else depends on where they are: those of the same key, then twins beside the
// particles that tears parted them from, then new particles along links from neighbours that have a
// motion. Pins and guides take away motion that is not allowed any more. Links (torn or not, held,
// doubled by tears), panels, inputs, gusts and canopies follow, each found by its key. Which fields
// each of these has is said in system/fields.h alone.
#include "assembly/carry_over.h"

#include "base/key_index.h"
#include "constraints/guides.h"
#include "system/fields.h"

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

// The places of items by their keys.
template <typename Items, typename KeyOf>
KeyIndex indexOf(const Items& items, KeyOf keyOf)
{
    KeyIndex index(items.size());
    for (std::size_t i = 0; i < items.size(); ++i)
        index.add(keyOf(items[i]), int(i));
    return index;
}

// Makes all that a state says of one particle, spring, ... what another state says of one.
template <Per per>
void carryEntry(const State& state, int from, State& carried, std::size_t to)
{
    forEachPer<per>(
        [&](auto& values, const auto& before) { values[to] = before[std::size_t(from)]; }, carried,
        state);
}

// Spreads the motion of known particles along links until every tied particle has one.
void followNeighbours(const System& to, State& carried, std::vector<std::uint8_t>& placed)
{
    if (std::find(placed.begin(), placed.end(), 0) == placed.end())
        return;
    std::vector<std::size_t> known;
    known.reserve(placed.size());
    for (std::size_t i = 0; i < placed.size(); ++i)
        if (placed[i])
            known.push_back(i);
    const auto follow = [&](std::size_t from, const auto& link) {
        const auto other = std::size_t(std::size_t(link.a) == from ? link.b : link.a);
        if (placed[other])
            return;
        carryEntry<Per::Particle>(carried, int(from), carried, other);
        carried.position[other] =
            to.start.position[other] + carried.position[from] - to.start.position[from];
        placed[other] = 1;
        known.push_back(other);
    };
    for (std::size_t next = 0; next < known.size() && known.size() < placed.size(); ++next) {
        const std::size_t from = known[next];
        for (int k = to.springsAt.start[from]; k < to.springsAt.start[from + 1]; ++k)
            follow(from, to.springs[std::size_t(to.springsAt.items[std::size_t(k)])]);
        for (int k = to.rodsAt.start[from]; k < to.rodsAt.start[from + 1]; ++k)
            follow(from, to.rods[std::size_t(to.rodsAt.items[std::size_t(k)])]);
    }
}

// Gives twins that are new the motion of the particles that they came from.
void placeTwins(const System& to, State& carried, std::vector<std::uint8_t>& placed)
{
    if (carried.splits.empty())
        return;
    const KeyIndex particleOf = indexOf(to.key, [](Key key) { return key; });
    for (const Split& split : carried.splits) {
        const int from = particleOf(split.from);
        const int twin = particleOf(split.twin);
        if (from < 0 || twin < 0 || placed[std::size_t(twin)])
            continue;
        carryEntry<Per::Particle>(carried, from, carried, std::size_t(twin));
        placed[std::size_t(twin)] = placed[std::size_t(from)];
    }
}

// Gives second links that are new their share of what the first link holds; they wait as that does.
void carryTwinLinks(const System& from, const System& to, State& carried)
{
    if (carried.splits.empty())
        return;
    const KeyIndex before = indexOf(from.links, [](const LinkPlace& link) { return link.key; });
    const KeyIndex now = indexOf(to.links, [](const LinkPlace& link) { return link.key; });
    for (const Split& split : carried.splits)
        for (const Split::Cut& cut : split.cut) {
            const int first = now(cut.link);
            const int twin = now(cut.twin);
            if (first < 0 || twin < 0 || before(cut.twin) >= 0)
                continue;
            const LinkPlace& place = to.links[std::size_t(first)];
            const auto twinAt = std::size_t(to.links[std::size_t(twin)].index);
            if (place.kind == LinkKind::Spring) {
                carryEntry<Per::Spring>(carried, place.index, carried, twinAt);
            } else {
                carryEntry<Per::Rod>(carried, place.index, carried, twinAt);
                carried.rodTension[twinAt] *= cut.share;
                carried.rodTension[std::size_t(place.index)] *= 1.0 - cut.share;
            }
            const auto held =
                std::find_if(carried.tearHolds.begin(), carried.tearHolds.end(),
                             [&](const TearHold& hold) { return hold.link == first; });
            if (held != carried.tearHolds.end())
                carried.tearHolds.push_back({twin, held->ratio});
        }
}

void carryHolds(const System& from, const State& state, const System& to, State& carried)
{
    carried.tearHolds.clear();
    if (state.tearHolds.empty())
        return;
    const KeyIndex linkOf = indexOf(to.links, [](const LinkPlace& link) { return link.key; });
    for (const TearHold& hold : state.tearHolds)
        if (const int match = linkOf(from.links[std::size_t(hold.link)].key); match >= 0)
            carried.tearHolds.push_back({match, hold.ratio});
}

void carryLinks(const System& from, const State& state, const System& to, State& carried)
{
    const KeyIndex linkOf = indexOf(from.links, [](const LinkPlace& link) { return link.key; });
    for (const LinkPlace& link : to.links) {
        const int match = linkOf(link.key);
        if (match < 0)
            continue;
        const LinkPlace& old = from.links[std::size_t(match)];
        const auto at = std::size_t(link.index);
        if (link.kind != old.kind) // a rod and a spring have in common only whether they are torn
            (link.kind == LinkKind::Rod ? carried.rodTorn : carried.springTorn)[at] =
                isTorn(old, state);
        else if (link.kind == LinkKind::Rod)
            carryEntry<Per::Rod>(state, old.index, carried, at);
        else
            carryEntry<Per::Spring>(state, old.index, carried, at);
    }
}

} // namespace

State carryOver(const System& from, const State& state, const System& to, State memory)
{
    State carried = std::move(memory);
    carried = to.start;
    forEachPer<Per::Run>([](auto& value, const auto& before) { value = before; }, carried, state);
    if (to.integrator != from.integrator)
        carried.driftSubstep = 0.0; // BDF2 looks back to more than Verlet notes

    const KeyIndex particleOf = indexOf(from.key, [](Key key) { return key; });
    std::vector<std::uint8_t> placed(to.key.size(), 0);
    std::vector<std::uint8_t> wasPinned(to.key.size(), 0);
    for (std::size_t j = 0; j < to.key.size(); ++j)
        if (const int match = particleOf(to.key[j]); match >= 0) {
            carryEntry<Per::Particle>(state, match, carried, j);
            placed[j] = 1;
            wasPinned[j] = from.inverseMass[std::size_t(match)] == 0.0;
        }
    placeTwins(to, carried, placed);
    followNeighbours(to, carried, placed);
    for (std::size_t j = 0; j < to.key.size(); ++j) {
        if (!placed[j]) // this particle has no previous step to remember
            carried.drift[j] = carried.velocityBefore[j] = carried.velocity[j];
        if (to.inverseMass[j] == 0.0 && !wasPinned[j]) { // it stops, for the air as well
            carried.velocity[j].setZero();
            carried.drift[j].setZero();
            carried.velocityBefore[j].setZero();
        }
    }
    for (const GuidedParticle& guided : to.guided)
        turnAlong(guided, carried);
    carryLinks(from, state, to, carried);
    carryHolds(from, state, to, carried);
    carryTwinLinks(from, to, carried);

    const KeyIndex panelOf = indexOf(from.panelKey, [](Key key) { return key; });
    for (std::size_t j = 0; j < to.panelKey.size(); ++j)
        if (const int match = panelOf(to.panelKey[j]); match >= 0)
            carryEntry<Per::Panel>(state, match, carried, j);

    const KeyIndex inputOf = indexOf(from.inputs, [](const Input& input) { return input.key; });
    for (std::size_t j = 0; j < to.inputs.size(); ++j)
        if (const int match = inputOf(to.inputs[j].key); match >= 0)
            carryEntry<Per::Input>(state, match, carried, j);

    const KeyIndex gustsOf = indexOf(from.gusts, [](const GustSpec& gusts) { return gusts.key; });
    for (std::size_t j = 0; j < to.gusts.size(); ++j)
        if (const int match = gustsOf(to.gusts[j].key); match >= 0)
            carryEntry<Per::Gusts>(state, match, carried, j);

    for (std::size_t j = 0; j < to.canopies.size(); ++j) // of which there are few
        for (std::size_t i = 0; i < from.canopies.size(); ++i)
            if (from.canopies[i].part == to.canopies[j].part
                && from.canopies[i].piece == to.canopies[j].piece)
                carryEntry<Per::Canopy>(state, int(i), carried, j);
    return carried;
}

} // namespace ripstop
