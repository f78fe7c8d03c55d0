// Ties says what the links of the scene join. Threads are made side by side in the order of the
// particles, as the import makes them, so that both give the same fabric.
#include "derived/thread_fabric.h"

#include "derived/cloth_area.h"
#include "derived/panel_sides.h"
#include "scene/particle_of.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace ripstop {
namespace {

// What the links of the scene join, in ascending order.
struct Ties
{
    explicit Ties(const Scene& scene)
    {
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Link& link : part.links) {
                pairs.push_back(sideOf(link.from, link.to));
                ends.insert(ends.end(), {link.from, link.to});
            }
        });
        std::ranges::sort(pairs);
        std::ranges::sort(ends);
    }

    bool join(const PanelSide& side) const { return std::ranges::binary_search(pairs, side); }
    bool end(Id particle) const { return std::ranges::binary_search(ends, particle); }

    bool hold(const Panel& panel) const
    {
        return std::ranges::any_of(sidesOf(panel),
                                   [&](const PanelSide& side) { return join(side); })
               || (end(panel.a) && end(panel.b) && end(panel.c));
    }

    std::vector<PanelSide> pairs;
    std::vector<Id> ends;
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

double lengthOf(const Scene& scene, const PanelSide& side) // m, as it lies
{
    const Particle* const a = particleOf(scene, side.first);
    const Particle* const b = particleOf(scene, side.second);
    return a && b ? (b->position - a->position).norm() : 0.0; // the check reports what is missing
}

std::map<PanelSide, Beside> besideSides(const Scene& scene, const Part& part)
{
    const ClothArea cut(part, &scene);
    std::map<PanelSide, Beside> all;
    for (const Panel& panel : part.panels) {
        const double area = cut.of(panel);
        const auto sides = sidesOf(panel);
        for (std::size_t i = 0; i < sides.size(); ++i) {
            Beside& beside = all[sides[i]];
            if (beside.panels++ == 0)
                beside.material = panel.material;
            const double length = panel.*restLengths[i];
            beside.area += area;
            beside.length += length > 0.0 ? length : lengthOf(scene, sides[i]);
            beside.stiffness += panel.stiffnessFactor;
            beside.strength += panel.strengthFactor;
        }
    }
    return all;
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
        for (const auto& [ends, beside] : besideSides(scene, part)) {
            if (ties.join(ends) || !(beside.length > 0.0))
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
