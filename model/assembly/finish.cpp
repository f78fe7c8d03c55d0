// finish() goes in this order: names for what was made by hand, the order of rods, lists of what
// meets at each particle, a start state of the right sizes, and what forces derive from all of
// that. Each stage reads what the ones before have filled in.
#include "assembly/finish.h"

#include "forces/forces.h"
#include "system/fields.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

namespace ripstop {
namespace {

void putRodsInOrder(System& system, const RodOrder& order)
{
    std::vector<Rod> sorted;
    std::vector<int> place(order.rod.size());
    sorted.reserve(order.rod.size());
    for (const int rod : order.rod) {
        place[std::size_t(rod)] = int(sorted.size());
        sorted.push_back(system.rods[std::size_t(rod)]);
    }
    system.rods = std::move(sorted);
    if (!system.direct.empty()) {
        std::vector<std::uint8_t> direct;
        for (const int rod : order.rod)
            direct.push_back(system.direct[std::size_t(rod)]);
        system.direct = std::move(direct);
    }
    for (LinkPlace& link : system.links)
        if (link.kind == LinkKind::Rod)
            link.index = place[std::size_t(link.index)];
    for (ShiftedRod& shifted : system.shiftedRods)
        shifted.rod = place[std::size_t(shifted.rod)];
}

void fillPanelsBeside(System& system)
{
    Rows& rows = system.panelsBeside;
    rows.start.clear();
    rows.items.clear();
    rows.start.reserve(system.links.size() + 1);
    rows.start.push_back(0);
    rows.items.reserve(3 * system.panels.size());
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
    for (std::size_t i = 0; i < system.links.size(); ++i) {
        const LinkPlace& link = system.links[i];
        (link.kind == LinkKind::Spring ? system.springLink
                                       : system.rodLink)[std::size_t(link.index)] = int(i);
    }
}

// One counter for all systems, so that no two versions have the same number.
std::uint64_t nextSerial()
{
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
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
    if (system.panelKey.empty()) {
        system.panelKey.resize(system.panels.size());
        std::iota(system.panelKey.begin(), system.panelKey.end(), Key(0));
    }
    nameLinks(system);

    RodOrder order = orderRods(n, system.rods);
    putRodsInOrder(system, order);
    finishOrdered(system, std::move(order));
}

void finishOrdered(System& system, RodOrder order)
{
    system.serial = nextSerial();
    touchAll(system);
    system.colorStart = std::move(order.colorStart);
    system.chunkStart = std::move(order.chunkStart);
    system.chunkClass = std::move(order.chunkClass);
    system.chunkReach = order.reach;
    backReferences(system);
    listTearable(system);

    const std::size_t n = system.start.position.size();
    const auto ends = [](const auto& link) { return std::array{link.a, link.b}; };
    fillIncidence(system.springsAt, n, system.springs, ends);
    fillIncidence(system.rodsAt, n, system.rods, ends);
    fillIncidence(system.panelsAt, n, system.panels, [](const FabricPanel& p) { return p.corner; });
    fillPanelsBeside(system);

    forEachSized(system, system.start, [](auto& values, std::size_t count) {
        if (values.size() != count)
            values.assign(count, {});
    });
    (void)listForces(system, {true, true, true, true, true, true, true});
}

void listTearable(System& system)
{
    const auto list = [](const auto& links, std::vector<int>& tearable) {
        tearable.clear();
        for (std::size_t i = 0; i < links.size(); ++i)
            if (links[i].tear.rule != TearRule::Never)
                tearable.push_back(int(i));
    };
    list(system.springs, system.tearableSprings);
    list(system.rods, system.tearableRods);
}

void touch(System& system, const Touched& changed)
{
    constexpr std::size_t most = 4096; // beyond this, looking at all is as fast as one by one
    Touched& touched = system.touched;
    if (touched.rods.size() + touched.particles.size() + changed.rods.size()
            + changed.particles.size()
        > most)
        return touchAll(system);
    system.valuesSerial = nextSerial();
    touched.rods.insert(touched.rods.end(), changed.rods.begin(), changed.rods.end());
    touched.particles.insert(touched.particles.end(), changed.particles.begin(),
                             changed.particles.end());
}

void touchAll(System& system)
{
    system.valuesSerial = nextSerial();
    system.touched = {system.valuesSerial, {}, {}};
}

} // namespace ripstop
