#include "check/strength_gaps.h"

#include "scene/usage.h"

namespace ripstop {
namespace {

bool lacksStrength(const Material& material, const Use& made)
{
    const bool isFabric = made.threads > 0 || made.elasticPanels > 0;
    return (made.lines > 0 && !material.lineStrength && !material.breakingMoment)
           || (isFabric && !material.warpStrength && !material.weftStrength);
}

} // namespace

std::vector<Id> materialsWithoutStrength(const Scene& scene)
{
    const Usage usage = usageOf(scene);
    const auto lacks = [&](Id id, const Material& material) {
        const auto made = usage.ofMaterial.find(id);
        return made != usage.ofMaterial.end() && lacksStrength(material, made->second);
    };
    std::vector<Id> without;
    for (const Entry& entry : scene.items)
        if (const auto* material = std::get_if<Material>(&entry.item);
            material && lacks(entry.id, *material))
            without.push_back(entry.id);
    if (lacks(noId, Material()))
        without.push_back(noId);
    return without;
}

} // namespace ripstop
