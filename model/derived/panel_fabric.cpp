// Part by part: refusal() looks for what keeps panels from carrying, cut() lays them flat, and
// Neighbours tells what comes in the place of a thread. References change first and rows go last,
// so that undo brings back the threads before what names them.
#include "derived/panel_fabric.h"

#include "derived/flat_panel.h"
#include "derived/panel_sides.h"
#include "scene/particle_of.h"
#include "scene/references.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ripstop {
namespace {

std::optional<Failure> refusal(const Scene& scene, const Part& part)
{
    if (part.panels.empty())
        return Failure("%1 has threads and no panels that could carry their pull: draw panels over "
                       "them first.",
                       part.name);
    for (const Panel& panel : part.panels) {
        const Material* material = findItem<Material>(scene, panel.material);
        if (!material)
            return Failure(
                "Panel %1 of %2 has no material and would carry nothing: give it that of "
                "the fabric first.",
                std::uint32_t(panel.id), part.name);
        if (!material->membraneStiffness)
            return Failure(
                "Panels of %1 would carry nothing, as their material %2 has no membrane "
                "stiffness: give it one first, in N/m, or the numbers of a fabric of the "
                "library.",
                part.name, material->name);
    }
    return std::nullopt;
}

// What is beside the threads of a part.
class Neighbours
{
public:
    Neighbours(Id id, const Part& part)
        : m_part(id)
    {
        for (const Link& link : part.links)
            if (isOfFabric(link)) {
                m_length[sideOf(link.from, link.to)] = link.restLength;
                m_thread[sideOf(link.from, link.to)] = &link;
                m_threads.emplace(link.id, sideOf(link.from, link.to));
            }
        for (const Panel& panel : part.panels)
            for (const PanelSide& side : sidesOf(panel))
                m_panels[side].push_back(panel.id);
    }

    std::vector<Id> threads() const
    {
        std::vector<Id> ids;
        for (const auto& [id, side] : m_threads)
            ids.push_back(id);
        return ids;
    }

    // Of the thread along a side, m; 0 where there is none.
    double length(const PanelSide& side) const
    {
        const auto found = m_length.find(side);
        return found == m_length.end() ? 0.0 : found->second;
    }

    // The mean of a factor of the threads along the sides of a panel; 1 where there are none.
    double meanFactor(const Panel& panel, double Link::*factor) const
    {
        double sum = 0.0;
        int count = 0;
        for (const PanelSide& side : sidesOf(panel))
            if (const auto found = m_thread.find(side); found != m_thread.end()) {
                sum += found->second->*factor;
                ++count;
            }
        return count > 0 ? sum / count : 1.0;
    }

    // Probes are of no single panel. Answers false when `id` is no thread of this part.
    bool addHeirs(Id id, bool ofProbe, std::vector<Id>& heirs) const
    {
        const auto thread = m_threads.find(id);
        if (thread == m_threads.end())
            return false;
        if (ofProbe) {
            heirs.push_back(m_part);
        } else if (const auto beside = m_panels.find(thread->second); beside != m_panels.end()) {
            heirs.insert(heirs.end(), beside->second.begin(), beside->second.end());
        }
        return true;
    }

private:
    Id m_part;
    std::map<Id, PanelSide> m_threads;
    std::map<PanelSide, double> m_length; // m, at rest
    std::map<PanelSide, const Link*> m_thread;
    std::map<PanelSide, std::vector<Id>> m_panels;
};

// Laid flat, with the lengths of threads where these make a triangle.
Panel cut(const Scene& scene, Panel panel, const Neighbours& neighbours)
{
    const Particle* const a = particleOf(scene, panel.a);
    const Particle* const b = particleOf(scene, panel.b);
    const Particle* const c = particleOf(scene, panel.c);
    if (!a || !b || !c) // which the check reports
        return panel;
    layFlat(panel, *a, *b, *c);
    Panel threaded = panel;
    const auto sides = sidesOf(panel);
    for (std::size_t k = 0; k < 3; ++k)
        if (const double length = neighbours.length(sides[k]); length > 0.0)
            threaded.*restLengths[k] = length;
    return flatPanel(threaded, a->position, b->position, c->position) ? threaded : panel;
}

bool isCut(const Panel& panel)
{
    return std::ranges::any_of(restLengths, [&](auto side) { return panel.*side > 0.0; });
}

// Of the panels that are not cut yet.
void addCuts(const Scene& scene, const Part& part, const Neighbours& neighbours, Edit& edit)
{
    SetValues ab{&propertyOf<&Panel::restAB>(), {}, {}};
    SetValues bc{&propertyOf<&Panel::restBC>(), {}, {}};
    SetValues ca{&propertyOf<&Panel::restCA>(), {}, {}};
    SetValues grain{&propertyOf<&Panel::grain>(), {}, {}};
    const auto set = [](SetValues& values, Id id, double value) {
        values.targets.push_back(id);
        values.values.emplace_back(value);
    };
    for (const Panel& row : part.panels) {
        if (isCut(row))
            continue;
        const Panel panel = cut(scene, row, neighbours);
        set(ab, row.id, panel.restAB);
        set(bc, row.id, panel.restBC);
        set(ca, row.id, panel.restCA);
        set(grain, row.id, panel.grain);
    }
    for (SetValues* values : {&ab, &bc, &ca, &grain})
        if (!values->targets.empty())
            edit.changes.emplace_back(std::move(*values));
}

void addFactors(const Part& part, const Neighbours& neighbours, Edit& edit)
{
    const auto add = [&](const Property& property, double Link::*ofThreads, double Panel::*own) {
        SetValues values{&property, {}, {}};
        for (const Panel& panel : part.panels)
            if (const double mean = neighbours.meanFactor(panel, ofThreads);
                mean != 1.0 && panel.*own == 1.0) {
                values.targets.push_back(panel.id);
                values.values.emplace_back(mean);
            }
        if (!values.targets.empty())
            edit.changes.emplace_back(std::move(values));
    };
    add(propertyOf<&Panel::stiffnessFactor>(), &Link::stiffnessFactor, &Panel::stiffnessFactor);
    add(propertyOf<&Panel::strengthFactor>(), &Link::strengthFactor, &Panel::strengthFactor);
}

} // namespace

bool isOfFabric(const Link& link) { return link.role != LinkRole::Line && link.width > 0.0; }

Result<PanelFabric> carriedByPanels(const Scene& scene, const std::vector<Id>& parts)
{
    PanelFabric made{{Message("Threads to panels"), {}}, {}, 0, 0};
    std::vector<Neighbours> all;
    std::vector<Change> removed;
    std::optional<Failure> failure;
    SetValues carrier{&propertyOf<&Part::carrier>(),
                      {},
                      {std::string(choiceNames<FabricKind>[std::size_t(FabricKind::Panels)])}};
    forEachPart(scene, [&](Id id, const Part& part) {
        if (failure || std::ranges::find(parts, id) == parts.end()
            || std::ranges::none_of(part.links, isOfFabric))
            return;
        failure = refusal(scene, part);
        const Neighbours& neighbours = all.emplace_back(id, part);
        addCuts(scene, part, neighbours, made.edit);
        addFactors(part, neighbours, made.edit);
        removed.emplace_back(RemoveRows{id, {}, neighbours.threads(), {}});
        if (part.carrier != FabricKind::Panels)
            carrier.targets.push_back(id);
        made.parts.push_back(id);
        made.threads += neighbours.threads().size();
        made.panels += part.panels.size();
    });
    if (failure)
        return *failure;
    if (made.parts.empty())
        return Failure{"There is no fabric of threads here: no link has the role thread or bias "
                       "and a width. Choose a part that has such links."};
    if (!carrier.targets.empty())
        made.edit.changes.emplace_back(std::move(carrier));
    for (const Entry& entry : scene.items) {
        const Heirs heirs = [&](Id id, std::vector<Id>& list) {
            const bool isThread = std::ranges::any_of(all, [&](const Neighbours& neighbours) {
                return neighbours.addHeirs(id, std::holds_alternative<Probe>(entry.item), list);
            });
            if (!isThread)
                list.push_back(id);
        };
        std::visit([&](const auto& item) { passOn(made.edit, entry.id, &item, heirs); },
                   entry.item);
    }
    made.edit.changes.insert(made.edit.changes.end(), removed.begin(), removed.end());
    return made;
}

} // namespace ripstop
