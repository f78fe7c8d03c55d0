// One pass over links and panels counts; of parts with spars two more find what rigidity particles
// hold, as that takes the neighbours of particles.
#include "scene/usage.h"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace ripstop {
namespace {

void count(const Link& link, Use& use)
{
    const bool isRod = link.kind == LinkKind::Rod;
    ++(isRod ? use.rods : use.springs);
    use.ownStiffness += !isRod && link.stiffness;
    use.ownDamping += !isRod && link.damping;
    use.ownCompliance += isRod && link.compliance;
    use.ownTearLimit += link.tearLimit.has_value();
    use.lines += link.role == LinkRole::Line;
    use.threads += link.role == LinkRole::Thread && link.width > 0.0;
    use.biases += link.role == LinkRole::Bias && link.width > 0.0;
}

std::set<Id> materialsOfSpars(const Scene& scene)
{
    std::set<Id> spars;
    for (const Entry& entry : scene.items)
        if (const auto* material = std::get_if<Material>(&entry.item);
            material && material->flexuralRigidity > 0.0)
            spars.insert(entry.id);
    return spars;
}

// A rigidity particle is tied to many particles of spars, by rods of another material that both
// push and pull. Two that are tied to both ends of each link leave a spar no way to bend.
//   spars  materials
void countHeldSpars(const Part& part, const std::set<Id>& spars, Usage& usage)
{
    constexpr std::size_t many = 5;
    std::unordered_map<std::uint32_t, std::set<Id>> ties; // of particles of spars, to others
    for (const Link& link : part.links)
        if (spars.contains(link.material))
            for (const Id end : {link.from, link.to})
                ties[std::uint32_t(end)];
    if (ties.empty())
        return;
    std::unordered_map<std::uint32_t, std::size_t> tied; // particles of spars, by what holds them
    for (const Link& link : part.links) {
        if (link.kind != LinkKind::Rod || link.resists != Resists::Both
            || spars.contains(link.material))
            continue;
        for (const auto& [spar, other] : {std::pair(link.from, link.to), {link.to, link.from}})
            if (const auto at = ties.find(std::uint32_t(spar)); at != ties.end())
                tied[std::uint32_t(other)] += at->second.insert(other).second;
    }
    for (const Link& link : part.links) {
        if (!spars.contains(link.material))
            continue;
        const std::set<Id>& a = ties[std::uint32_t(link.from)];
        const std::set<Id>& b = ties[std::uint32_t(link.to)];
        const auto holds = [&](Id one) {
            return b.contains(one) && tied[std::uint32_t(one)] >= many;
        };
        usage.ofMaterial[link.material].held += std::ranges::count_if(a, holds) >= 2;
    }
}

} // namespace

Usage usageOf(const Scene& scene)
{
    Usage usage;
    const std::set<Id> spars = materialsOfSpars(scene);
    forEachPart(scene, [&](Id, const Part& part) {
        Id last = noId; // neighbours share their material
        Use* use = &usage.ofMaterial[noId];
        const auto at = [&](Id material) -> Use& {
            if (material != last)
                use = &usage.ofMaterial[last = material];
            return *use;
        };
        for (const Link& link : part.links) {
            count(link, at(link.material));
            count(link, usage.ofAll);
        }
        const bool isElastic = part.carrier == FabricKind::Panels;
        for (const Panel& panel : part.panels) {
            ++at(panel.material).panels;
            at(panel.material).elasticPanels += isElastic;
        }
        countHeldSpars(part, spars, usage);
        usage.ofAll.panels += part.panels.size();
        usage.ofAll.elasticPanels += isElastic ? part.panels.size() : 0;
    });
    return usage;
}

bool changesUsage(const Edit& edit)
{
    return std::ranges::any_of(edit.changes, [](const Change& change) {
        const auto* values = std::get_if<SetValues>(&change);
        return !values || values->property->traits.contains(Trait::Counts);
    });
}

std::optional<std::string> whyIdle(const Scene& scene, const Usage& usage, const Property& property,
                                   Id id)
{
    const auto ref = find(scene, id);
    if (!ref || kindOf(*ref) != property.kind)
        return std::nullopt;
    const auto made = usage.ofMaterial.find(id);
    const Circumstances around{scene, usage.ofAll,
                               made == usage.ofMaterial.end() ? Use() : made->second};
    for (const Need& need : property.needs)
        if (!need.holds(*ref, around))
            return need.otherwise;
    return std::nullopt;
}

} // namespace ripstop
