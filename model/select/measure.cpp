// Probes for a selection: the kinds of elements that a quantity asks for stand in the table of
// quantities (base/quantity.h). withProbe() fills target and further particles from the selection,
// and where several elements are meant it makes a group first, whose id the probe points at.
#include "select/measure.h"

#include "base/quantity.h"
#include "select/elements.h"
#include "select/group.h"

#include <algorithm>

namespace ripstop {
namespace {

using Of = QuantityRow::Of;

bool hasAny(const Elements& elements, Of of)
{
    switch (of) {
    case Of::Particles:
        return !elements.particles.empty();
    case Of::Links:
        return !elements.links.empty();
    case Of::LinksAndPanels:
        return !elements.links.empty() || !elements.panels.empty();
    case Of::Fabric:
    case Of::Panels:
    case Of::Canopy:
        return !elements.panels.empty();
    case Of::Whole:
    case Of::Probes:
        return true;
    }
    return false;
}

bool isForWhole(Of of) { return of == Of::Whole || of == Of::Probes; }

std::string nameFor(const Scene& scene, Quantity quantity)
{
    std::string name(choiceNames<Quantity>[std::size_t(quantity)]);
    std::ranges::replace(name, '_', ' ');
    return freeName(scene, name);
}

} // namespace

std::string asks(Quantity quantity)
{
    const QuantityRow& row = rowOf(quantity);
    if (row.points == 2)
        return "two particles";
    if (row.points == 3)
        return "three particles: nose, tail and one on the right";
    switch (row.of) {
    case Of::Particles:
        return "particles, or parts and groups with some";
    case Of::Links:
        return "links, or parts and groups with some";
    case Of::LinksAndPanels:
        return "links or panels, or parts and groups with some";
    case Of::Fabric:
    case Of::Panels:
        return "panels, or parts and groups with some";
    case Of::Canopy:
        return "a canopy";
    case Of::Whole:
    case Of::Probes:
        break;
    }
    return "the whole scene";
}

bool isMeasurable(const Scene& scene, Quantity quantity, const std::vector<Id>& selected)
{
    const QuantityRow& row = rowOf(quantity);
    if (isForWhole(row.of))
        return true;
    const Elements elements = sortedElements(scene, selected);
    return row.points == 1 ? hasAny(elements, row.of)
                           : elements.particles.size() == std::size_t(row.points);
}

std::optional<ProbeEdit> withProbe(const Scene& scene, Quantity quantity,
                                   const std::vector<Id>& selected)
{
    if (!isMeasurable(scene, quantity, selected))
        return std::nullopt;
    const QuantityRow& row = rowOf(quantity);
    Probe probe;
    probe.quantity = quantity;
    probe.name = nameFor(scene, quantity);
    ProbeEdit result;
    result.edit.label = Message("Measure %1", probe.name);
    std::uint32_t next = std::uint32_t(scene.nextId);

    if (row.points > 1) {
        const std::vector<const Particle*> particles = sortedElements(scene, selected).particles;
        probe.target = particles[row.points == 2 ? 1 : 0]->id;
        probe.from = particles[row.points == 2 ? 0 : 1]->id;
        probe.side = row.points == 3 ? particles[2]->id : noId;
    } else if (!isForWhole(row.of) && selected.size() == 1) {
        probe.target = selected.front();
    } else if (!isForWhole(row.of)) {
        const Edit group = grouped(scene, freeName(scene, probe.name + " of"), selected);
        result.edit.changes = group.changes;
        probe.target = Id{next++};
    }
    result.probe = Id{next};
    const std::size_t place = scene.items.size() + result.edit.changes.size();
    result.edit.changes.emplace_back(AddItem{place, {result.probe, std::move(probe)}});
    return result;
}

} // namespace ripstop
