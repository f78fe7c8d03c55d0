// Ties says what the links of the scene join. Threads are made side by side in the order of the
// particles, as the import makes them, so that both give the same fabric.
#include "derived/thread_fabric.h"

#include "derived/cloth_area.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace ripstop {
namespace {

using Ends = std::pair<Id, Id>; // of a thread, the lower id first

struct CutSide
{
    Id a;
    Id b;
    double length; // m, as cut; 0 where the panel does not say
};

std::array<CutSide, 3> cutSides(const Panel& panel)
{
    return {CutSide{panel.a, panel.b, panel.restAB}, CutSide{panel.b, panel.c, panel.restBC},
            CutSide{panel.c, panel.a, panel.restCA}};
}

Ends endsOf(Id a, Id b) { return {std::min(a, b), std::max(a, b)}; }

// What the links of the scene join.
struct Ties
{
    explicit Ties(const Scene& scene)
    {
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Link& link : part.links) {
                pairs.insert(endsOf(link.from, link.to));
                ends.insert({link.from, link.to});
            }
        });
    }

    bool hold(const Panel& panel) const
    {
        const auto isTied = [&](const CutSide& side) {
            return pairs.contains(endsOf(side.a, side.b));
        };
        return std::ranges::any_of(cutSides(panel), isTied)
               || (ends.contains(panel.a) && ends.contains(panel.b) && ends.contains(panel.c));
    }

    std::set<Ends> pairs;
    std::set<Id> ends;
};

// What lies beside a side: sums over its panels.
struct Beside
{
    double area = 0.0;      // m^2
    double length = 0.0;    // m, as cut
    double stiffness = 0.0; // 1, factors
    double strength = 0.0;
    int panels = 0;
    Id material{};
};

Vec3 placeOf(const Scene& scene, Id id)
{
    const std::optional<ConstRef> ref = find(scene, id);
    const auto* particle = ref ? std::get_if<const Particle*>(&*ref) : nullptr;
    return particle ? (*particle)->position : Vec3(Vec3::Zero()); // the check reports it
}

std::map<Ends, Beside> sidesOf(const Scene& scene, const Part& part)
{
    const ClothArea cut(part, &scene);
    std::map<Ends, Beside> sides;
    for (const Panel& panel : part.panels)
        for (const CutSide& side : cutSides(panel)) {
            Beside& beside = sides[endsOf(side.a, side.b)];
            if (beside.panels++ == 0)
                beside.material = panel.material;
            beside.area += cut.of(panel);
            beside.length += side.length > 0.0
                                 ? side.length
                                 : (placeOf(scene, side.b) - placeOf(scene, side.a)).norm();
            beside.stiffness += panel.stiffnessFactor;
            beside.strength += panel.strengthFactor;
        }
    return sides;
}

} // namespace

std::vector<Id> partsWithoutThreads(const Scene& scene)
{
    std::vector<Id> parts;
    std::optional<Ties> ties;
    forEachPart(scene, [&](Id id, const Part& part) {
        if (part.carrier != FabricKind::Threads || part.panels.empty())
            return;
        if (!ties)
            ties.emplace(scene);
        if (!std::ranges::all_of(part.panels,
                                 [&](const Panel& panel) { return ties->hold(panel); }))
            parts.push_back(id);
    });
    return parts;
}

std::vector<Change> threadsFor(const Scene& scene, const std::vector<Id>& parts)
{
    const Ties ties(scene);
    std::vector<Change> changes;
    auto next = std::uint32_t(scene.nextId);
    for (const Id id : parts) {
        const Part& part = *findItem<Part>(scene, id);
        AddRows rows{id, {}, {}, {}};
        for (const auto& [ends, beside] : sidesOf(scene, part)) {
            if (ties.pairs.contains(ends) || !(beside.length > 0.0))
                continue;
            const double count = beside.panels;
            Link thread;
            thread.id = Id{next++};
            thread.from = ends.first;
            thread.to = ends.second;
            thread.material = beside.material;
            thread.role = LinkRole::Thread;
            thread.restLength = beside.length / count;
            thread.width = beside.area / thread.restLength;
            thread.stiffnessFactor = beside.stiffness / count;
            thread.strengthFactor = beside.strength / count;
            rows.links.push_back(thread);
        }
        if (!rows.links.empty())
            changes.emplace_back(std::move(rows));
    }
    return changes;
}

Edit threaded(const Scene& scene, Edit edit)
{
    std::vector<Id> chosen; // parts
    for (const Change& change : edit.changes)
        if (const auto* values = std::get_if<SetValues>(&change);
            values && isOneOf<&Part::carrier>(*values->property))
            chosen.insert(chosen.end(), values->targets.begin(), values->targets.end());
    if (chosen.empty())
        return edit;
    Scene after = scene;
    (void)apply(after, edit);
    std::vector<Id> bare = partsWithoutThreads(after);
    std::erase_if(bare, [&](Id id) { return std::ranges::count(chosen, id) == 0; });
    // as they are cut: rest lengths of panels count where panels carry
    std::vector<Change> threads = threadsFor(scene, bare);
    std::ranges::move(threads, std::back_inserter(edit.changes));
    return edit;
}

} // namespace ripstop
