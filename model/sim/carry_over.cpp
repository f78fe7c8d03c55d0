#include "sim/carry_over.h"

#include "base/key_index.h"

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

// Place of each item by its key.
template <typename Items, typename KeyOf>
KeyIndex indexOf(const Items& items, KeyOf keyOf)
{
    KeyIndex index(items.size());
    for (std::size_t i = 0; i < items.size(); ++i)
        index.add(keyOf(items[i]), int(i));
    return index;
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
        carried.position[other] =
            to.start.position[other] + carried.position[from] - to.start.position[from];
        carried.velocity[other] = carried.velocity[from];
        carried.drift[other] = carried.drift[from];
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

void carryLinks(const System& from, const State& state, const System& to, State& carried)
{
    const KeyIndex linkOf = indexOf(from.links, [](const LinkPlace& link) { return link.key; });
    for (const LinkPlace& link : to.links) {
        const int match = linkOf(link.key);
        if (match < 0)
            continue;
        const LinkPlace& old = from.links[std::size_t(match)];
        const bool torn = old.kind == LinkKind::Rod ? state.rodTorn[std::size_t(old.index)]
                                                    : state.springTorn[std::size_t(old.index)];
        (link.kind == LinkKind::Rod ? carried.rodTorn
                                    : carried.springTorn)[std::size_t(link.index)] = torn;
        if (link.kind == LinkKind::Rod && old.kind == LinkKind::Rod)
            carried.rodTension[std::size_t(link.index)] = state.rodTension[std::size_t(old.index)];
    }
}

} // namespace

State carryOver(const System& from, const State& state, const System& to, State memory)
{
    State carried = std::move(memory);
    carried = to.start;
    carried.time = state.time;
    carried.step = state.step;
    carried.substep = state.substep;
    carried.substeps = state.substeps;
    carried.tears = state.tears;
    carried.driftSubstep = state.driftSubstep;

    const KeyIndex particleOf = indexOf(from.key, [](Key key) { return key; });
    std::vector<std::uint8_t> placed(to.key.size(), 0);
    for (std::size_t j = 0; j < to.key.size(); ++j)
        if (const int match = particleOf(to.key[j]); match >= 0) {
            carried.position[j] = state.position[std::size_t(match)];
            carried.velocity[j] = state.velocity[std::size_t(match)];
            carried.drift[j] = state.drift[std::size_t(match)];
            placed[j] = 1;
        }
    followNeighbours(to, carried, placed);
    for (std::size_t j = 0; j < to.key.size(); ++j) {
        if (!placed[j]) // has no previous step to remember
            carried.drift[j] = carried.velocity[j];
        if (to.inverseMass[j] == 0.0) { // what has just been pinned stops, for the air as well
            carried.velocity[j].setZero();
            carried.drift[j].setZero();
        }
    }
    carryLinks(from, state, to, carried);

    const KeyIndex panelOf = indexOf(from.panelKey, [](Key key) { return key; });
    for (std::size_t j = 0; j < to.panelKey.size(); ++j)
        if (const int match = panelOf(to.panelKey[j]); match >= 0)
            carried.panelGone[j] = state.panelGone[std::size_t(match)];

    const KeyIndex inputOf = indexOf(from.inputs, [](const Input& input) { return input.key; });
    for (std::size_t j = 0; j < to.inputs.size(); ++j)
        if (const int match = inputOf(to.inputs[j].key); match >= 0) {
            carried.inputCommand[j] = state.inputCommand[std::size_t(match)];
            carried.inputValue[j] = state.inputValue[std::size_t(match)];
        }

    const KeyIndex gustsOf = indexOf(from.gusts, [](const GustSpec& gusts) { return gusts.key; });
    for (std::size_t j = 0; j < to.gusts.size(); ++j)
        if (const int match = gustsOf(to.gusts[j].key); match >= 0)
            carried.gusts[j] = state.gusts[std::size_t(match)];

    for (std::size_t j = 0; j < to.canopies.size(); ++j) // of which there are few
        for (std::size_t i = 0; i < from.canopies.size(); ++i)
            if (from.canopies[i].part == to.canopies[j].part
                && from.canopies[i].piece == to.canopies[j].piece)
                carried.canopies[j] = state.canopies[i];
    return carried;
}

} // namespace ripstop
