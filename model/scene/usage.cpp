#include "scene/usage.h"

#include <algorithm>

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

} // namespace

Usage usageOf(const Scene& scene)
{
    Usage usage;
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
